#pragma once
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/ladder.hpp>
#include <nipref/fast/viscoelastic_nip/internal/pressure.hpp>

namespace nipref::fast {

/// How the contact of a viscoelastic nip is solved level by level: see Ladder.
class ViscoelasticNipLevels {
 public:
  using Contact = ViscoelasticPressure;
  struct Resolution {
    std::vector<int> pieces;  ///< of the panels, see ViscoelasticLayout
    int terms;                ///< on each
    double least;
  };
  static constexpr int most = 7;
  static constexpr double whole_share = 0.03;

  explicit ViscoelasticNipLevels(ViscoelasticCompliances material) : material_(std::move(material)) {}

  [[nodiscard]] Resolution resolution(double near, int level) const;
  /// Only relaxation lengths below a millionth of the contact ask for more, and in vain: rounding; and memories that
  /// swing many times before they fade, whose first levels do with as many.
  static constexpr int most_unknowns = 1600;
  [[nodiscard]] static bool is_affordable(const Resolution& resolution) {
    return std::reduce(resolution.pieces.begin(), resolution.pieces.end()) * resolution.terms <=
           most_unknowns;
  }
  [[nodiscard]] std::unique_ptr<ViscoelasticPressure> solve(double half_length, const Resolution& resolution,
                                                            double tolerance, CountedKernels& kernels) const;
  [[nodiscard]] std::vector<AccuracyTarget<ViscoelasticPressure>> accuracy_targets(
      const ViscoelasticPressure& last, double accuracy) const;
  [[nodiscard]] double half_length_guess(double load) const;
  /// The compliance with which a contact acts over its whole length, over what acts at once.
  [[nodiscard]] double softening_over(double half_length) const;

 private:
  ViscoelasticCompliances material_;
};

using ViscoelasticNipLadder = Ladder<ViscoelasticNipLevels>;

}  // namespace nipref::fast
