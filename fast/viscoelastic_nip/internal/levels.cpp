#include <algorithm>
#include <cmath>

#include <nipref/fast/nip/internal/expansion_tail.hpp>
#include <nipref/fast/viscoelastic_nip/internal/functionals.hpp>
#include <nipref/fast/viscoelastic_nip/internal/levels.hpp>

namespace nipref::fast {
namespace {

/// How many pieces of a panel of this width hold what is left of e^(-rate d) at d = `from`. Pressure that sets in like a
/// square root leaves a swing of (rate edge)^(-1/2) of it at the edge, which fades on its way; over half a piece of c
/// radians its coefficients are Bessel's J_n(c) < (c/2)^n/n!. They are to fall by `fall` a term from the pressure's own,
/// nearly as on panels that double where nothing swings. Seen from the trailing end nothing sets in.
int pieces_for(const MemoryTerm& term, double edge, double from, double width, int terms) {
  constexpr double fall = 4;
  const double radians = width / 2 * std::fabs(term.rate.imag());
  const double faded = std::max(0.0, std::log(std::abs(term.rate) * edge) / 2) + term.rate.real() * from;
  if (radians <= 1 || faded > terms * std::log(fall)) return 1;
  const double held = 2 / fall * std::pow(std::tgamma(terms + 1) * std::exp(faded), 1.0 / terms);
  return static_cast<int>(std::ceil(std::min(radians / held, 1e4)));
}

/// Of the panels of a contact of this half length.
std::vector<int> pieces(double half_length, int panels, int terms, const std::vector<MemoryTerm>& memory) {
  const ViscoelasticLayout uncut(half_length, panels, terms);
  std::vector<int> counts;
  for (const ViscoelasticPanel& panel : uncut.panels()) {
    int count = 1;
    const double from =
        uncut.downstream({panel.half, panel.half == Half::leading ? panel.left : panel.left + panel.width});
    for (const MemoryTerm& term : memory) {
      if (!panel.at_end())
        count = std::max(count, pieces_for(term, std::min(half_length, 1.0), from, panel.width, terms));
    }
    counts.push_back(count);
  }
  return counts;
}

/// Of a swing that is longer than can be afforded the beginning is resolved.
void keep_first(int affordable, std::vector<int>& pieces) {
  int spare = affordable - static_cast<int>(pieces.size());
  for (int& count : pieces) {
    count = 1 + std::clamp(spare, 0, count - 1);
    spare -= count - 1;
  }
}

}  // namespace

/// The panels at the ends take at most the distance in which the sheet's kernel changes, and twice that in which a
/// memory takes over: waves e^(ikd) meet the compliance 1 + amplitude/(rate + ik), which is 0 where -ik is rate +
/// amplitude, so that pressure that sets in settles by that much a half-thickness. They resolve none that is too
/// short to matter. On each the nearest singularity is one panel length away.
ViscoelasticNipLevels::Resolution ViscoelasticNipLevels::resolution(double near, int level) const {
  double longest = widest_felt;
  for (const MemoryTerm& term : material_.normal)
    longest = std::min(longest, 2 / (std::abs(term.rate) + std::abs(term.amplitude)));
  const int panels = 1 + std::clamp(static_cast<int>(std::ceil(std::log2(near / longest))), 0, 36);
  const int terms = static_cast<int>(std::ceil(4 * std::pow(1.5, level)));
  Resolution resolution{pieces(near, panels, terms, material_.normal), terms,
                        std::pow(fastest_on_panels(near), -terms)};
  if (level <= 2) keep_first(most_unknowns / terms, resolution.pieces);
  return resolution;
}

std::unique_ptr<ViscoelasticPressure> ViscoelasticNipLevels::solve(double half_length,
                                                                   const Resolution& resolution,
                                                                   double tolerance,
                                                                   CountedKernels& kernels) const {
  return std::make_unique<ViscoelasticPressure>(
      ViscoelasticLayout(half_length, resolution.pieces, resolution.terms), material_, tolerance, kernels);
}

std::vector<AccuracyTarget<ViscoelasticPressure>> ViscoelasticNipLevels::accuracy_targets(
    const ViscoelasticPressure& last, double accuracy) const {
  const double half_length = last.half_length(), peak = last.pressure({Half::leading, half_length});
  const auto pressure = [](Half half, double part) {
    return [=](const ViscoelasticPressure& contact) {
      return contact.pressure({half, part * contact.half_length()});
    };
  };
  return {{&ViscoelasticPressure::load},
          {&ViscoelasticPressure::half_length},
          {&ViscoelasticPressure::edge_displacement, half_length * half_length},
          {&ViscoelasticPressure::offset, 0.1 * half_length},
          // Relative to its own size, however small that is, as far as rounding lets.
          {eccentricity, half_length * std::min(1.0, 1e-14 / accuracy), half_length, Rate::own,
           eccentricity_error_margin},
          {pressure(Half::leading, 0.25), peak},
          {pressure(Half::trailing, 0.25), peak},
          {pressure(Half::leading, 1)}};
}

double ViscoelasticNipLevels::softening_over(double half_length) const {
  double sum = 1;
  for (const MemoryTerm& term : material_.normal)
    sum += (term.amplitude / (term.rate + 1 / half_length)).real();
  return sum;
}

double ViscoelasticNipLevels::half_length_guess(double load) const {
  const double stiff = fast::half_length_guess(load);
  return fast::half_length_guess(load * softening_over(stiff));
}

}  // namespace nipref::fast
