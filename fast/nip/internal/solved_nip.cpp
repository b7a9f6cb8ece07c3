#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>

namespace nipref::fast {
namespace {

constexpr double longer_by = 1e-3;
/// How far, relatively, a contact that the search has passed may be to tell derivatives.
constexpr double nearest_neighbour = 1e-5, farthest_neighbour = 1e-2;
/// Between refinements: a factor of about a hundred.
constexpr double nats_of_step = 4.6;
constexpr double most_nats = 42;

bool is_neighbour(double ratio) {
  const double difference = std::fabs(ratio - 1);
  return difference > nearest_neighbour && difference < farthest_neighbour;
}

}  // namespace

SolvedNip::SolvedNip(std::shared_ptr<const NipEquations> equations, double half_length,
                     std::optional<double> load, double accuracy)
    : equations_(std::move(equations)),
      load_(load),
      accuracy_(accuracy),
      near_(half_length),
      exponent_(LengthSearch::usual_exponent) {
  // The last of the terms that a panel has beyond its degree are smaller than the accuracy asks.
  solve_to(std::max(-std::log(accuracy) - nats_of_step, 1.0));
  while (shortfall().all > 1 && refine()) {
  }
}

std::unique_ptr<const Solution> SolvedNip::solve(double half_length, double nats, double tolerance) const {
  CountedKernels kernels = this->kernels();
  auto solved = std::make_unique<const Solution>(
      equations_->solve(half_length, panels(near_, equations_->resolution(nats)), tolerance, kernels));
  kernels.count_system(solved->size());
  return solved;
}

void SolvedNip::solve_to(double nats) {
  nats_ = nats;
  neighbour_.reset();
  length_.reset();
  if (load_)
    solve_for_load(nats);
  else
    solution_ = solve(near_, nats);
}

void SolvedNip::solve_for_load(double nats) {
  constexpr double few_nats = 5, rough = 1e-3;
  const auto settle = [&](double these_nats, double tolerance, double until, bool lays_out) {
    for (LengthSearch search(*load_, near_, {until, longest_sought}, exponent_);;) {
      const double half_length = search.length();
      // The layout follows only large changes of the length: with each new layout the load jumps.
      if (lays_out) near_ = half_length;
      auto before = std::exchange(solution_, solve(half_length, these_nats, tolerance));
      if (!lays_out && before && is_neighbour(before->half_length() / half_length))
        neighbour_ = std::move(before);
      const bool settled = search.settled(solution_->value(solution_->load()));
      exponent_ = search.exponent();
      if (settled && !std::isfinite(search.residual()))
        throw data::BadInput("load", *load_,
                             "over its unit, must be one for which a contact length is found");
      if (settled) return;
    }
  };
  if (!solution_) settle(few_nats, 1e-6, rough, true);
  near_ = last().half_length();
  solution_.reset();
  settle(nats, tolerance(), std::max(1e-2 * accuracy_, 1e-15), false);
}

const Solution& SolvedNip::neighbour() const {
  if (!neighbour_) neighbour_ = solve(last().half_length() * (1 + longer_by), nats_);
  return *neighbour_;
}

double SolvedNip::growth(const std::function<double(const Solution&)>& value) const {
  return (value(neighbour()) - value(last())) / (neighbour().half_length() - last().half_length());
}

const Estimate& SolvedNip::half_length_estimate() const {
  if (!length_) {
    length_ = {last().half_length(), 0};
    if (load_) {
      const double rise = growth([](const Solution& solution) { return solution.value(solution.load()); });
      const auto [load, error] = last().estimate(last().load());
      length_->value += (*load_ - load) / rise;
      length_->error = (error + std::fabs(load - *load_)) / std::fabs(rise);
    }
  }
  return *length_;
}

double SolvedNip::value(const std::function<double(const Solution&)>& number) const {
  if (!load_) return number(last());
  return number(last()) + growth(number) * (half_length() - last().half_length());
}

Estimate SolvedNip::estimate(const Number& number) const {
  return estimate(number, [&](const Solution& solution) { return solution.value(number(solution)); });
}

Estimate SolvedNip::estimate(const Number& linearised,
                             const std::function<double(const Solution&)>& number) const {
  Estimate result = last().estimate(linearised(last()));
  result.value = value(number);
  if (load_) result.error += std::fabs(growth(number)) * half_length_estimate().error;
  return result;
}

Estimate SolvedNip::at_place(double e, double unsure, const AtPlace& number) const {
  Estimate here = estimate([&](const Solution& solution) { return number(solution, e); });
  here.error += shift(e, unsure, number);
  return here;
}

double SolvedNip::shift(double e, double unsure, const AtPlace& number) const {
  const double reach = unsure + 0x1p-52 * std::fabs(e), value = last().value(number(last(), e));
  double largest = 0;
  for (const double moved : {e - reach, e + reach})
    largest = std::max(largest, std::fabs(last().value(number(last(), moved)) - value));
  return largest;
}

SolvedNip::Shortfall SolvedNip::shortfall() const {
  std::vector<AccuracyTarget> targets = equations_->accuracy_targets(last());
  targets.push_back({last().load(), 0});
  Shortfall largest{0, 0};
  for (const auto& [number, scale] : targets) {
    const Estimate estimate = last().estimate(number);
    const double size = accuracy_ * std::max(scale, std::fabs(estimate.value));
    largest.all = std::max(largest.all, estimate.error / size);
    largest.rounding = std::max(largest.rounding, last().rounding(number) / size);
    if (std::isnan(estimate.error)) largest.all = estimate.error;
  }
  if (std::isnan(largest.all)) {
    throw data::BadInput("contact's half length", last().half_length(),
                         "in half-thicknesses, must be one that can be solved in double with this sheet");
  }
  return largest;
}

bool SolvedNip::refine() {
  const Shortfall now = shortfall();
  if (nats_ >= most_nats || now.all <= 2 * now.rounding) return false;
  const double missing = std::max(now.all > 1 ? std::log(now.all) : 0, nats_of_step);
  solve_to(std::min(nats_ + std::min(missing, 3 * nats_of_step), most_nats));
  return true;
}

}  // namespace nipref::fast
