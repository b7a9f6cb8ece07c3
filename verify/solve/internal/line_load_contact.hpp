#pragma once
#include <cmath>
#include <memory>
#include <utility>

#include <nipref/verify/solve/internal/derived_results.hpp>
#include <nipref/verify/solve/internal/methods.hpp>

namespace nipref::verify {

/// Line loads in double. The error of a result is its distance to the same result of the continuous contact, whose own
/// error is added.
class LineLoadContact : public SolvedContact<fast::Estimate> {
 public:
  [[nodiscard]] fast::Estimate number(ResultId id) const final {
    return is_moment(id) ? estimate(moment(id), moment_of_pressure(*truth_, id))
                         : estimate(value(id), truth_->number(id));
  }
  [[nodiscard]] fast::Estimate at(ResultId id, double y) const final {
    return estimate(profile(id, y), truth_->at(id, y));
  }
  [[nodiscard]] fast::Work error_work() const final { return truth_->work(); }

 protected:
  explicit LineLoadContact(std::unique_ptr<SolvedContact<fast::Estimate>> truth) : truth_(std::move(truth)) {}

  static fast::Estimate estimate(double value, const fast::Estimate& truth) {
    return {value, std::fabs(value - truth.value) + truth.error};
  }
  [[nodiscard]] const SolvedContact<fast::Estimate>& truth() const { return *truth_; }

 private:
  /// leading_moment or trailing_moment (thesis 7.13).
  [[nodiscard]] virtual double moment(ResultId id) const = 0;
  [[nodiscard]] virtual double value(ResultId id) const = 0;
  [[nodiscard]] virtual double profile(ResultId id, double y) const = 0;

  std::unique_ptr<SolvedContact<fast::Estimate>> truth_;
};

}  // namespace nipref::verify
