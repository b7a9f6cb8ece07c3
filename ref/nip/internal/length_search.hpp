#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// All lengths within the relative distance `spread` of `length`.
struct Lengths {
  Float length;
  Float spread = 0;

  [[nodiscard]] Interval interval() const {
    return interval_of(length).widened(interval_of(abs(length) * spread));
  }
};

inline Float middle_of(const Float& x) { return x; }

/// A search for the length that carries a load. contact_of(Lengths) returns the contacts of these lengths by a pointer
/// or an optional, which is empty if the precision does not suffice. Contacts have a load(). Contacts with a growth(),
/// d ln W/d ln L, are sought by Newton steps, others by secant steps. A member `systems` is set to the number solved.
struct LengthSearch {
  Exact load;
  Float length;              ///< the start, later the result, in any unit that contact_of takes
  Float longest = HUGE_VAL;  ///< the largest length that is tried
  double longest_step = 2;   ///< largest change of ln L in a step
  Float exponent = 3;        ///< d ln W/d ln L
  Float exponent_error = 1;  ///< about the error of `exponent`
  int systems = 0;           ///< number of systems solved

  /// Takes steps for ln W over ln L until W is within 10^-digits of the load or is expected to be so after the last
  /// step. Returns false if the precision does not suffice to solve a contact. BadInput "load" if no length is found.
  template <class ContactOf>
  bool seek(int digits, const ContactOf& contact_of) {
    constexpr int most_steps = 60;
    constexpr double least_exponent = 1;
    const Float tolerance = pow(Float(10), -digits);
    std::optional<std::pair<Float, Float>> last;  // ln L and ln W - ln load
    for (int step = 0; step < most_steps; ++step) {
      ++systems;
      const auto tried = contact_of(Lengths{length});
      if (!tried) return false;
      const Float found = middle_of(tried->load());
      if (!(found > Float(0))) {
        length = length / 3;
        continue;
      }
      const Float excess = log(found / to_float(load)), log_length = log(length);
      constexpr bool has_growth = requires { tried->growth(); };
      if constexpr (has_growth) {
        exponent = tried->growth();
        exponent_error = abs(excess);
      } else if (last && log_length != last->first) {
        exponent = std::max<Float>((excess - last->second) / (log_length - last->first), least_exponent);
        exponent_error = abs(last->second);
      }
      last = {log_length, excess};
      const Float change = std::clamp<Float>(-excess / exponent, -longest_step, longest_step);
      length = std::min<Float>(exp(log_length + change), longest);
      // The error after the step is about the excess times the error of the exponent; 100 is a margin.
      if (abs(excess) * std::min<Float>(100 * exponent_error, 1) <= tolerance) return true;
    }
    throw data::BadInput("load", load.approximate(), "no contact length was found that carries it");
  }

  /// All contacts of lengths within 10^-digits of the one found. One of them carries the load, since the shortest
  /// carries less and the longest more. Nothing if the precision does not suffice for the proof.
  template <class ContactOf>
  auto contact_carrying(int digits, const ContactOf& contact_of) -> decltype(contact_of(Lengths{})) {
    constexpr int beyond = 3;
    if (!seek(digits + beyond, contact_of)) return {};
    const Interval wanted(load, working_bits());
    // The sign of W - load, 0 where the bounds do not tell.
    const auto sign_at = [&](const Float& at) {
      ++systems;
      const auto contact = contact_of(Lengths{at});
      return contact ? sign_of(contact->load() - wanted) : 0;
    };
    const Lengths lengths{length, pow(Float(10), -digits)};
    // Both lie inside by a thousandth: rounding puts neither outside, and the load changes far more than its error.
    const Float change = length * lengths.spread * (1 - Float(1e-3));
    if (sign_at(length - change) * sign_at(length + change) >= 0) return {};
    ++systems;
    auto contact = contact_of(lengths);
    constexpr bool has_systems = requires { contact->systems; };
    if constexpr (has_systems)
      if (contact) contact->systems = systems;
    return contact;
  }
};

}  // namespace nipref::ref
