#pragma once
#include <memory>
#include <vector>

#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/elastic_nip/internal/half_contact.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/ladder.hpp>

namespace nipref::fast {

/// How the contact of an elastic nip is solved level by level: see Ladder.
class ElasticNipLevels {
 public:
  using Contact = HalfContact;
  struct Resolution {
    bool spectral;  ///< one expansion over the whole contact
    int panels;
    int terms;  ///< on each
    double least;
  };
  static constexpr int most = 8;
  static constexpr double whole_share = 0.1;

  ElasticNipLevels(data::Friction friction, double poisson) : friction_(friction), poisson_(poisson) {}

  [[nodiscard]] Resolution resolution(double near, int level) const;
  /// All resolutions are: they have some hundred unknowns.
  [[nodiscard]] static bool is_affordable(const Resolution&) { return true; }
  [[nodiscard]] std::unique_ptr<HalfContact> solve(double half_length, const Resolution& resolution,
                                                   double tolerance, CountedKernels& kernels) const;
  [[nodiscard]] std::vector<AccuracyTarget<HalfContact>> accuracy_targets(const HalfContact& last,
                                                                          double accuracy) const;
  [[nodiscard]] double half_length_guess(double load) const { return fast::half_length_guess(load); }

 private:
  data::Friction friction_;
  double poisson_;
};

using ElasticNipLadder = Ladder<ElasticNipLevels>;

}  // namespace nipref::fast
