#include <algorithm>
#include <cmath>
#include <complex>

#include <nipref/fast/viscoelastic_nip/internal/short_memories.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// Of a contact, or of the half-thickness: what is shorter is not told from its limit.
double too_short(double accuracy) { return std::max(1e-9, std::min(accuracy / 100, 1e-5)); }
/// In half-thicknesses: what a memory then still adds, at most 1e120 of the compliance over such a way, is none;
/// but what flows for ever has no such way.
constexpr double too_long = 1e150;
/// Differences between contacts with resolved short memories and their limit, over the neglected way, reach 3.
constexpr double safety = 8;

/// On which edge pressure and kernel change.
double edge(double half_length) { return std::min(half_length, 1.0); }

/// Of what a memory leaves, 1/stress.
Complex strength(const data::RelaxationTerm& term) { return term.amplitude / term.rate; }

/// The sheet in terms of ways: half-thicknesses.
class Ways {
 public:
  Ways(const data::ViscoelasticNip& nip, double half_length, double accuracy)
      : half_thicknesses_per_time_(nip.speed / nip.half_thickness()),
        shortest_(too_short(accuracy) * edge(half_length)) {}

  [[nodiscard]] Complex way(const data::RelaxationTerm& term) const {
    return half_thicknesses_per_time_ / term.rate;
  }
  /// Longer than 1/|rate| where that swings.
  [[nodiscard]] double fade(const data::RelaxationTerm& term) const {
    return half_thicknesses_per_time_ / term.rate.real();
  }
  [[nodiscard]] bool is_too_long(const data::RelaxationTerm& term) const {
    return term.rate != 0.0 && !(std::abs(way(term)) < too_long);
  }
  [[nodiscard]] bool is_short(const data::RelaxationTerm& term) const {
    return term.rate != 0.0 && std::abs(way(term)) < shortest_;
  }
  [[nodiscard]] double at_once(const data::MaterialFunction& function) const {
    double sum = function.instantaneous;
    for (const data::RelaxationTerm& term : function.terms) {
      if (is_short(term)) sum += strength(term).real();
    }
    return sum;
  }
  [[nodiscard]] std::vector<MemoryTerm> longer(const data::MaterialFunction& function,
                                               double compliance) const {
    std::vector<MemoryTerm> terms;
    for (const data::RelaxationTerm& term : function.terms) {
      if (is_short(term) || is_too_long(term)) continue;
      terms.push_back({term.amplitude / (half_thicknesses_per_time_ * compliance),
                       0.0 + term.rate / half_thicknesses_per_time_});  // no -0
    }
    return terms;
  }

 private:
  double half_thicknesses_per_time_;
  double shortest_;
};

}  // namespace

double EffectiveSheet::neglected(double half_length) const { return safety * way / edge(half_length); }

double EffectiveSheet::neglected_of_shift(double half_length) const {
  return std::max(safety * fade / edge(half_length), 0x1p-48) * way;
}

double EffectiveSheet::neglected_near_end(double half_length, double distance) const {
  if (way == 0) return 0;
  const double growth = std::sqrt(edge(half_length) / std::max(std::fabs(distance), way));
  // At its beginning, for a pressure that rises like a square root, half as much in all.
  const double swinging = 2 * swing / std::sqrt(edge(half_length)) * std::exp(-std::fabs(distance) / fade);
  return (neglected(half_length) * std::max(growth, 1.0) + swinging) * std::max(softening, 1.0);
}

double EffectiveSheet::neglected_behind(double half_length, double distance) const {
  if (held == 0) return 0;
  // sqrt(pi/2) of it, for a pressure that rises like a square root and one memory.
  constexpr double several = 4;
  return several * held * std::sqrt(fade / edge(half_length)) * std::exp(-distance / fade);
}

EffectiveSheet effective_sheet(const data::ViscoelasticNip& nip, const data::MaterialFunctions& functions,
                               double half_length, double accuracy) {
  const Ways ways(nip, half_length, accuracy);
  const data::MaterialFunction normal = functions.normal_compliance();
  const data::MaterialFunction& theta2 = functions.theta2;
  const double compliance = ways.at_once(normal);
  EffectiveSheet sheet{
      compliance,
      {ways.longer(normal, compliance), ways.at_once(theta2) / compliance, ways.longer(theta2, compliance)}};
  sheet.softening = compliance / normal.instantaneous;
  for (const data::MaterialFunction* function : {&normal, &theta2}) {
    for (const data::RelaxationTerm& term : function->terms) {
      if (!ways.is_short(term)) continue;
      const Complex delay = strength(term) / compliance * ways.way(term);
      sheet.way += std::abs(delay);
      sheet.fade = std::max(sheet.fade, ways.fade(term));
      if (term.rate.imag() != 0)
        sheet.swing += std::abs(strength(term)) / compliance * std::sqrt(std::abs(ways.way(term)));
      if (function == &normal) sheet.shift += delay.real();
      if (function == &theta2) sheet.held += std::abs(strength(term)) / compliance;
    }
  }
  return sheet;
}

}  // namespace nipref::fast
