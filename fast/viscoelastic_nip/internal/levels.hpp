#pragma once
#include <memory>
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
    int panels;  ///< on each half
    int terms;   ///< on each
    double least;
  };
  static constexpr int most = 7;
  static constexpr double whole_share = 0.1;

  explicit ViscoelasticNipLevels(ViscoelasticCompliances material) : material_(std::move(material)) {}

  [[nodiscard]] Resolution resolution(double near, int level) const;
  /// Only relaxation lengths below a millionth of the contact ask for more unknowns, and in vain: rounding.
  [[nodiscard]] static bool is_affordable(const Resolution& resolution) {
    return 2 * resolution.panels * resolution.terms <= 1600;
  }
  [[nodiscard]] std::unique_ptr<ViscoelasticPressure> solve(double half_length, const Resolution& resolution,
                                                            double tolerance, CountedKernels& kernels) const;
  [[nodiscard]] std::vector<Judged<ViscoelasticPressure>> judged(const ViscoelasticPressure& last,
                                                                 double accuracy) const;
  [[nodiscard]] double half_length_guess(double load) const;

 private:
  ViscoelasticCompliances material_;
};

using ViscoelasticNipLadder = Ladder<ViscoelasticNipLevels>;

}  // namespace nipref::fast
