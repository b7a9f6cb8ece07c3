#pragma once
#include <cmath>
#include <concepts>
#include <functional>
#include <memory>

#include <nipref/verify/solve/internal/methods.hpp>
#include <nipref/verify/solve/internal/nip_results.hpp>

namespace nipref::verify {

/// The accuracy of the continuous contact to which line loads are compared; their distance to it is at least about
/// 1e-3.
inline constexpr double truth_accuracy = 1e-5;

/// The error of line loads is their distance to the truth, whose own error is added.
inline fast::Estimate compared_with(const fast::Estimate& truth, double value) {
  return {value, std::fabs(value - truth.value) + truth.error};
}

/// The contact of line loads in double, whose functions have the names of the results; each is compared with the same
/// result of the continuous contact.
template <class LineLoads>
SolvedInDouble compared_with_truth(const std::shared_ptr<LineLoads>& loads,
                                   const std::shared_ptr<const SolvedContact<fast::Estimate>>& truth,
                                   const auto& problem) {
  auto contact = std::make_unique<SolvedContact<fast::Estimate>>();
  const auto set = [&](ResultId id, auto function) {
    if constexpr (std::invocable<decltype(function), LineLoads&, double>) {
      contact->set(
          id, [=](double y) { return compared_with(truth->at(id, y), std::invoke(function, *loads, y)); });
    } else {
      contact->set(id, [=] { return compared_with(truth->number(id), std::invoke(function, *loads)); });
    }
  };
  set_nip_results<LineLoads>(set, [](const LineLoads&) { return 0.0; });
  complete_nip(*contact, problem);
  contact->measure = Measure::truth;
  contact->error_work = [truth] { return truth->work(); };
  return contact;
}

}  // namespace nipref::verify
