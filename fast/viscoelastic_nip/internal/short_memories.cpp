#include <algorithm>
#include <cmath>
#include <complex>

#include <nipref/fast/viscoelastic_nip/internal/short_memories.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// Memories with shorter relaxation lengths, over the contact or the half-thickness, are replaced by their limit.
double too_short(double accuracy) { return std::max(1e-9, std::min(accuracy / 100, 1e-5)); }
/// Half-thicknesses. A memory with a longer relaxation length adds nothing: it is at most 1e120 of the compliance over
/// that length. A memory that flows for ever, rate 0, has no relaxation length.
constexpr double too_long = 1e150;
/// Differences between contacts with resolved short memories and their limit, over the neglected length, reach 3.
constexpr double safety = 8;

/// The length on which pressure and kernel change near an end.
double edge(double half_length) { return std::min(half_length, 1.0); }

/// The compliance that a memory adds in the end, 1/stress.
Complex strength(const data::RelaxationTerm& term) { return term.amplitude / term.rate; }

/// Relaxation lengths of memories, half-thicknesses, and which of them are short.
class RelaxationLengths {
 public:
  RelaxationLengths(const data::ViscoelasticNip& nip, double half_length, double accuracy)
      : half_thicknesses_per_time_(nip.speed / nip.half_thickness()),
        shortest_(too_short(accuracy) * edge(half_length)) {}

  [[nodiscard]] Complex relaxation_length(const data::RelaxationTerm& term) const {
    return half_thicknesses_per_time_ / term.rate;
  }
  /// Longer than 1/|rate| where the memory oscillates.
  [[nodiscard]] double decay_length(const data::RelaxationTerm& term) const {
    return half_thicknesses_per_time_ / term.rate.real();
  }
  [[nodiscard]] bool is_too_long(const data::RelaxationTerm& term) const {
    return term.rate != 0.0 && !(std::abs(relaxation_length(term)) < too_long);
  }
  [[nodiscard]] bool is_short(const data::RelaxationTerm& term) const {
    return term.rate != 0.0 && std::abs(relaxation_length(term)) < shortest_;
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

double EffectiveSheet::neglected(double half_length) const { return safety * shift_size / edge(half_length); }

double EffectiveSheet::neglected_of_shift(double half_length) const {
  return std::max(safety * decay_length / edge(half_length), 0x1p-48) * shift_size;
}

double EffectiveSheet::neglected_near_end(double half_length, double distance) const {
  if (shift_size == 0) return 0;
  const double growth = std::sqrt(edge(half_length) / std::max(std::fabs(distance), shift_size));
  // Twice the sum of the oscillations at their beginning, where the pressure rises like a square root.
  const double oscillating =
      2 * oscillation / std::sqrt(edge(half_length)) * std::exp(-std::fabs(distance) / decay_length);
  return (neglected(half_length) * std::max(growth, 1.0) + oscillating) * std::max(softening, 1.0);
}

double EffectiveSheet::neglected_behind(double half_length, double distance) const {
  if (residual_strain == 0) return 0;
  // For one memory and a pressure that rises like a square root the factor is sqrt(pi/2).
  constexpr double several = 4;
  return several * residual_strain * std::sqrt(decay_length / edge(half_length)) *
         std::exp(-distance / decay_length);
}

EffectiveSheet effective_sheet(const data::ViscoelasticNip& nip, const data::MaterialFunctions& functions,
                               double half_length, double accuracy) {
  const RelaxationLengths lengths(nip, half_length, accuracy);
  const data::MaterialFunction normal = functions.normal_compliance();
  const data::MaterialFunction& theta2 = functions.theta2;
  const double compliance = lengths.at_once(normal);
  EffectiveSheet sheet{compliance,
                       {lengths.longer(normal, compliance), lengths.at_once(theta2) / compliance,
                        lengths.longer(theta2, compliance)}};
  sheet.softening = compliance / normal.instantaneous;
  for (const data::MaterialFunction* function : {&normal, &theta2}) {
    for (const data::RelaxationTerm& term : function->terms) {
      if (!lengths.is_short(term)) continue;
      const Complex delay = strength(term) / compliance * lengths.relaxation_length(term);
      sheet.shift_size += std::abs(delay);
      sheet.decay_length = std::max(sheet.decay_length, lengths.decay_length(term));
      if (term.rate.imag() != 0)
        sheet.oscillation +=
            std::abs(strength(term)) / compliance * std::sqrt(std::abs(lengths.relaxation_length(term)));
      if (function == &normal) sheet.shift += delay.real();
      if (function == &theta2) sheet.residual_strain += std::abs(strength(term)) / compliance;
    }
  }
  return sheet;
}

}  // namespace nipref::fast
