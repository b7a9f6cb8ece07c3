#include <algorithm>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/nip/internal/solved_nip.hpp>

namespace nipref::ref {
namespace {

constexpr int most_unknowns = 1400;
constexpr int kernel_guard = 8, quadrature_guard = 6;  ///< digits
constexpr int search_digits = 10;

double first_nats(int digits) { return digits * std::numbers::ln10 + 2; }

Fineness fineness_of(bool fine, double nats) {
  return fine ? Fineness{1.5, 2.2, 1.2 * nats} : Fineness{1.3, 2, nats};
}

/// Of a contact on these panels; BadInput if they are too many.
int checked_unknowns(const NipSheet& sheet, const std::vector<TractionPanel>& panels, int digits) {
  int terms = 0;
  for (const TractionPanel& panel : panels) terms += panel.terms;
  const int unknowns = sheet.unknowns(terms);
  if (unknowns > most_unknowns)
    throw data::BadInput("digits", std::to_string(digits),
                         "must be fewer, or the contact shorter: the reference tries " +
                             std::to_string(most_unknowns) + " unknowns at most, and this takes " +
                             std::to_string(unknowns));
  return unknowns;
}

}  // namespace

SolvedNip::SolvedNip(Sheet sheet, int digits)
    : sheet_(std::move(sheet)),
      digits_(digits),
      kernels_(std::make_unique<SheetKernels>(digits + kernel_guard)) {}

SolvedNip SolvedNip::of_half_length(const Sheet& sheet, const Float& half_length, int digits) {
  SolvedNip nip(sheet, digits);
  nip.solve([&](const Fineness& fineness) { return nip.solution(half_length, fineness); }, half_length);
  return nip;
}

SolvedNip SolvedNip::of_load(const Sheet& sheet, const Float& load, double guess, int digits,
                             const Check& check) {
  LengthSearch search{.load = to_exact(load), .length = guess, .longest_step = 1};
  {  // with few digits
    const WorkingDigits working(working_digits(search_digits, sheet->lost_digits()));
    const SolvedNip few(sheet, search_digits);
    search.seek(search_digits, [&](const Lengths& at) {
      check(static_cast<double>(at.length));
      first_unknowns(*sheet, at.length, digits);
      return few.solution(at.length, fineness_of(false, first_nats(search_digits)));
    });
  }
  check(static_cast<double>(search.length));
  search.length = at_working_precision(search.length);
  SolvedNip nip(sheet, digits);
  const Float enough = pow(Float(10), -digits) / 1000;
  const auto solve_at = [&](const Fineness& fineness) {
    std::unique_ptr<NipSolution> here;
    search.seek(digits + 3, [&](const Lengths& at) {
      here = nip.solution(at.length, fineness);
      return here.get();
    });
    const bool is_there = abs(search.length - here->half_length()) <= enough * search.length;
    return is_there ? std::move(here) : nip.solution(search.length, fineness);
  };
  nip.solve(solve_at, search.length);
  return nip;
}

int SolvedNip::first_unknowns(const NipSheet& sheet, const Float& half_length, int digits) {
  const auto panels = panels_of(half_length, sheet.resolution(), fineness_of(true, first_nats(digits)));
  return checked_unknowns(sheet, panels, digits);
}

Float SolvedNip::kernel_share() { return pow(Float(10), 2 - kernel_guard); }

data::WithError<Float> SolvedNip::estimate(const Functional& functional, const Float& scale) const {
  Float value = functional(*fine_);
  const Float least = pow(Float(10), -digits_) / 100;
  Float error =
      2 * abs(value - functional(*coarse_)) + (difference_ + least) * std::max(scale, Float(abs(value)));
  return {std::move(value), std::move(error)};
}

std::unique_ptr<NipSolution> SolvedNip::solution(const Float& half_length, const Fineness& fineness) const {
  auto panels = panels_of(half_length, sheet_->resolution(), fineness);
  checked_unknowns(*sheet_, panels, digits_);
  return sheet_->solved(half_length, std::move(panels), (digits_ + quadrature_guard) * std::numbers::ln10,
                        *kernels_);
}

void SolvedNip::solve(const std::function<std::unique_ptr<NipSolution>(const Fineness&)>& solve_at,
                      const Float& near) {
  const Float enough = pow(Float(10), -digits_) / 4;
  for (double nats = first_nats(digits_);; nats *= 1.25) {
    checked_unknowns(*sheet_, panels_of(near, sheet_->resolution(), fineness_of(true, nats)), digits_);
    fine_ = solve_at(fineness_of(true, nats));
    coarse_ = solve_at(fineness_of(false, nats));
    measure();
    if (difference_ <= enough) return;
  }
}

void SolvedNip::measure() {
  const std::vector<Float> fine = fine_->signature(), coarse = coarse_->signature();
  difference_ = ldexp(Float(1), 20 - working_bits());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const Float apart = abs(fine[i] - coarse[i]);
    if (!(apart <= difference_)) difference_ = apart;
  }
}

}  // namespace nipref::ref
