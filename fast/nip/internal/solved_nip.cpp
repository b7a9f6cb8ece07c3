#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/length_search.hpp>
#include <nipref/fast/nip/internal/solved_nip.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>

namespace nipref::fast {
namespace {

/// The least relative difference of half-lengths for derivatives, and that of a contact solved for derivatives alone.
constexpr double nearest_neighbour = 1e-7, longer_by = 1e-6;
/// The least nats that a refinement adds: a factor of about a hundred.
constexpr double nats_of_step = 4.6;
constexpr double most_nats = 42;

}  // namespace

SolvedNip::SolvedNip(std::shared_ptr<const NipEquations> equations, double half_length,
                     std::optional<double> load, double accuracy)
    : equations_(std::move(equations)),
      load_(load),
      accuracy_(accuracy),
      near_(half_length),
      sought_(half_length),
      exponent_(LengthSearch::usual_exponent) {
  if (load_) search_roughly();
  // The truncation error is estimated from one term more than the accuracy needs. On a panel that is the whole contact
  // this term is smaller by so many nats.
  const double of_term = 2 * internal::log_of_ellipse({0, 2 / sought_});
  solve_to(std::max(-std::log(accuracy) - std::min(of_term, nats_of_step), 1.0));
  while (add_terms(shortfall(), 1)) {
  }
  if (load_) meet_load();
}

std::unique_ptr<const Solution> SolvedNip::solve(double half_length, const Resolution& resolution,
                                                 double tolerance) const {
  CountedKernels kernels = this->kernels();
  auto solved = std::make_unique<const Solution>(
      equations_->solve(half_length, panels(near_, resolution, longest_whole_), tolerance, kernels));
  work_->count_system(solved->size());
  return solved;
}

void SolvedNip::solve_to(double nats) {
  nats_ = nats;
  neighbour_.reset();
  length_.reset();
  solution_ = solve(sought_);
}

/// Solves each contact with its own panels, until the next step leads nearly to the length. This step leaves about a
/// hundredth of the load's residual, and so does the first step of meet_load(). In a film that sticks the load of a
/// given length has the errors of the integrals times the film's stiffness over that of a sheet without friction. Their
/// tolerance is that of whole decades, so that few rules of integration are cached.
void SolvedNip::search_roughly() {
  constexpr double few_nats = 9, tolerance = 1e-6, near_enough = 5e-2;
  Resolution few_terms = equations_->resolution(few_nats);
  few_terms.checking_terms = 0;
  LengthSearch search(*load_, near_, {tolerance, longest_sought}, equations_->load_exponent_at(near_));
  bool settled = false;
  while (!settled && search.residual() > near_enough) {
    near_ = search.length();
    const double decades = std::floor(std::log10(std::min(1.0, equations_->softening_over(near_))));
    solution_ = solve(near_, few_terms, std::max(tolerance * std::pow(10, decades), quadrature_tolerance));
    settled = search.settled(solution_->carried_load());
  }
  near_ = sought_ = search.length();
  exponent_ = search.exponent();
}

/// Finds the length by secants with one layout of the panels, because the load jumps with each new layout.
void SolvedNip::meet_load() {
  constexpr double rounding = 1e-15;
  LengthSearch search(*load_, last().half_length(), {rounding, longest_sought}, exponent_);
  const auto suffices = [&] {
    length_.reset();
    return curvature() <= std::max(1e-2 * accuracy_, rounding);
  };
  while (!search.settled(last().carried_load())) {
    const bool is_far = std::fabs(search.length() / last().half_length() - 1) > nearest_neighbour;
    if (!is_far && suffices()) break;
    auto before = std::exchange(solution_, solve(search.length()));
    if (is_far) neighbour_ = std::move(before);
    if (suffices()) break;
  }
  exponent_ = search.exponent();
  sought_ = half_length();
  if (!std::isfinite(sought_))
    throw data::BadInput("load", *load_, "over its unit, must be one for which a contact length is found");
}

const Solution& SolvedNip::neighbour() const {
  if (!neighbour_) neighbour_ = solve(last().half_length() * (1 + longer_by));
  return *neighbour_;
}

double SolvedNip::to_neighbour() const { return neighbour().half_length() - last().half_length(); }

double SolvedNip::load_growth() const {
  return (neighbour().carried_load() - last().carried_load()) / to_neighbour();
}

double SolvedNip::parts_of_both() const {
  const double part = (half_length() - last().half_length()) / to_neighbour();
  return std::fabs(1 - part) + std::fabs(part);
}

const Estimate& SolvedNip::half_length_estimate() const {
  if (!length_) {
    length_ = {last().half_length(), 0};
    if (load_) {
      const double rise = load_growth();
      const auto [load, truncation, rounding] = last().parts(last().load());
      length_->value += (*load_ - load) / rise;
      const double least_rise = std::max(std::fabs(rise) - 2 * rounding / std::fabs(to_neighbour()), 0.0);
      length_->error = parts_of_both() * (truncation + rounding) / least_rise + curvature() * length_->value;
    }
  }
  return *length_;
}

double SolvedNip::curvature() const {
  const double here = last().half_length(), left = (*load_ - last().carried_load()) / load_growth();
  double bend = 15;
  for (const std::complex<double>& rate : equations_->resolution(nats_).rates)
    bend =
        std::max(bend, std::pow(5.5 + 2 * std::abs(rate) * here, 2) / 2 * std::exp(-2 * rate.real() * here));
  return bend * std::fabs(left / here) * std::fabs((here + left - neighbour().half_length()) / here);
}

std::complex<double> SolvedNip::traction(double e) const {
  const auto of = [e](const Solution& solution) {
    if (e <= solution.half_length()) return solution.traction(e);
    return std::conj(solution.traction(std::max(0.0, 2 * solution.half_length() - e)));
  };
  if (!load_) return of(last());
  const double left = half_length() - last().half_length();
  return of(last()) + left / to_neighbour() * (of(neighbour()) - of(last()));
}

SolvedNip::InBoth operator-(const SolvedNip::InBoth& a, const SolvedNip::InBoth& b) {
  SolvedNip::InBoth difference{a.here - b.here, {}, a.shift + b.shift};
  if (a.there) difference.there = *a.there - *b.there;
  return difference;
}

Estimate SolvedNip::estimate(const InBoth& number) const {
  const auto [here, truncation, rounding] = last().parts(number.here);
  if (!load_) return {here, truncation + rounding + number.shift};
  const double rise = (neighbour().value(*number.there) - here) / to_neighbour(),
               largest_rise = std::fabs(rise) + 2 * rounding / std::fabs(to_neighbour());
  const double value = here + rise * (half_length() - last().half_length());
  return {value, parts_of_both() * (truncation + rounding) + largest_rise * half_length_estimate().error +
                     curvature() * std::max(std::fabs(value), std::fabs(rise) * half_length()) +
                     number.shift};
}

SolvedNip::InBoth SolvedNip::in_both(const Number& number) const {
  InBoth result{number(last())};
  if (load_) result.there = number(neighbour());
  return result;
}

std::vector<SolvedNip::InBoth> SolvedNip::at_place(const ContactPlace& place, double reach,
                                                   const AtPlace& numbers) const {
  std::vector<InBoth> result;
  for (Functional& here : numbers(last(), place)) result.push_back({std::move(here)});
  if (load_) {
    std::vector<Functional> there = numbers(neighbour(), place);
    for (std::size_t i = 0; i < result.size(); ++i) result[i].there = std::move(there[i]);
  }
  if (reach == 0) return result;
  const auto take_shifts = [&](double e) {
    const std::vector<Functional> moved = numbers(last(), {place.trailing, e});
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i].shift =
          std::max(result[i].shift, std::fabs(last().value(moved[i]) - last().value(result[i].here)));
  };
  // Away from the end a number J is smooth on the least scale l of e, of the memories and of the sheet's slowest
  // residue term, |z| = 2.4. Shifts r to both sides change it equally but for r^2 |J''|, at most 8 (r/l)^2 |J| by
  // Cauchy's bound on a circle of radius l/2. If this is less than the rounding error that counts, 16 u, one side
  // suffices, that of the end.
  constexpr double apart = 0x1p-26, of_sheet = 2.4;
  double steepest = std::max(1 / std::fabs(place.e), of_sheet);
  for (const auto& rate : equations_->resolution(nats_).rates) steepest = std::max(steepest, std::abs(rate));
  const double towards_end = -std::copysign(reach, place.e);
  take_shifts(place.e + towards_end);
  if (!(reach * steepest <= apart)) take_shifts(place.e - towards_end);
  return result;
}

SolvedNip::Shortfall SolvedNip::shortfall() const {
  std::vector<AccuracyTarget> targets = equations_->accuracy_targets(last());
  targets.push_back({last().load(), 0});
  const double middle = last().traction(last().half_length()).real();
  for (const Panel& panel : last().tractions().panels()) {
    const double at =
        panel.about_middle && !panel.at_end ? last().half_length() : panel.left + 0.2 * panel.width();
    const auto add = [&](TractionComponent component, bool trailing) {
      targets.push_back({equations_->traction(last(), component, {trailing, at}), middle});
    };
    add(TractionComponent::pressure, false);
    if (equations_->sticks()) add(TractionComponent::shear, false);
    if (equations_->offset_unknown()) add(TractionComponent::pressure, true);
  }
  Shortfall largest{0, 0};
  for (const auto& [number, scale] : targets) {
    const auto [value, truncation, rounding] = last().parts(number);
    const double size = accuracy_ * std::max(scale, std::fabs(value)), error = truncation + rounding;
    largest.all = std::max(largest.all, error / size);
    largest.rounding = std::max(largest.rounding, rounding / size);
    if (std::isnan(error)) largest.all = error;
  }
  if (std::isnan(largest.all)) {
    throw data::BadInput("contact's half length", last().half_length(),
                         "in half-thicknesses, must be one that can be solved in double with this sheet");
  }
  return largest;
}

bool SolvedNip::add_terms(const Shortfall& now, double enough) {
  if (now.all <= enough) return false;
  const bool rounding_rules = now.all <= 2 * now.rounding;
  if (nats_ >= most_nats || rounding_rules) {
    if (last().tractions().panels().size() > 1 || near_ <= longest_always_whole) return false;
    longest_whole_ = longest_always_whole;
    solve_to(nats_);
    return true;
  }
  const double missing = std::max(now.all > 1 ? std::log(now.all) : 0, nats_of_step);
  solve_to(std::min(nats_ + std::min(missing, 3 * nats_of_step), most_nats));
  return true;
}

bool SolvedNip::refine() {
  const bool has_more = add_terms(shortfall(), 0);
  if (has_more && load_) meet_load();
  return has_more;
}

}  // namespace nipref::fast
