#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_contact.hpp>

namespace nipref::ref {
namespace {

/// About a minute; a load takes several solutions.
constexpr int most_unknowns = 600, most_unknowns_for_load = 420;
constexpr int guard_digits = 14;  ///< of the arithmetic beyond the results
constexpr int search_digits = 8;
constexpr int most_load_steps = 40;

/// The distance from the ends in which the pressure changes, half-thicknesses: the shortest memory's.
double end_length(const std::vector<RollingMemory>& memory) {
  double length = 2.5;
  for (const RollingMemory& term : memory) length = std::min(length, 2 / static_cast<double>(term.rate));
  return length;
}

/// How finely a contact is cut.
struct Fineness {
  int terms;
  bool other_panels;
};

RollingLayout rolling_layout(const Float& half_length, const std::vector<RollingMemory>& memory,
                             const Fineness& fineness) {
  const double first = end_length(memory);
  const auto size = static_cast<double>(half_length);
  if (first >= 2 * size && size <= 0.5) {
    if (!fineness.other_panels) return {half_length, first, true, fineness.terms};
    return {half_length, size, false, fineness.terms};
  }
  return {half_length, fineness.other_panels ? 0.7 * std::min(first, size) : first, false, fineness.terms};
}

/// That are likely to give so many digits: each brings a factor of 5.8 or so.
int first_terms(int digits) { return static_cast<int>(digits * 2.302585 / 1.763) + 2; }

void check_unknowns(const RollingLayout& layout, int most, int digits) {
  if (layout.unknowns() <= most) return;
  throw data::BadInput("digits", std::to_string(digits),
                       "must be fewer, or the contact shorter or its memory longer: the reference tries " +
                           std::to_string(most) + " unknowns at most here");
}

RollingPressure solved(const Float& half_length, RollingKernel& kernel, const Fineness& fineness) {
  return {half_length, rolling_layout(half_length, kernel.memory(), fineness), kernel};
}

/// A guess at the half length that carries a load, a few tens of per cent off at most where memories are long
/// or short: between a half-space and springs, with the compliance that the contact meets.
double guessed_half_length(double load, const std::vector<RollingMemory>& memory) {
  double size = 1;
  for (int i = 0; i < 60; ++i) {
    double softness = 1;
    for (const RollingMemory& term : memory)
      softness += static_cast<double>(term.amplitude) / (static_cast<double>(term.rate) + 1 / size);
    size = std::sqrt(size * std::sqrt(load * softness / (3.14159 + 8 * size / 3)));
  }
  return size;
}

}  // namespace

RollingContact::RollingContact(std::vector<RollingMemory> memory, int digits)
    : digits_(digits),
      kernel_(std::make_unique<RollingKernel>(std::move(memory), digits + guard_digits - 6)) {}

int RollingContact::working_digits() const { return digits_ + guard_digits; }

void RollingContact::measure() {
  const auto apart = [](const Float& x, const Float& y, const Float& scale) { return abs(x - y) / scale; };
  const Float& size = fine_->half_length();
  const Float square = size * size;
  difference_ = ldexp(Float(1), 20 - mpfr_get_prec(Float().get()));
  const auto take = [&](const Float& x) {
    if (!(x <= difference_)) difference_ = x;
  };
  take(apart(fine_->load(), coarse_->load(), fine_->load()));
  take(apart(fine_->half_length(), coarse_->half_length(), size));
  take(apart(fine_->offset(), coarse_->offset(), size));
  take(apart(fine_->edge_displacement(), coarse_->edge_displacement(), square));
  const Float scale = fine_->load() / size;
  constexpr int samples = 7;
  for (int i = 1; i < samples; ++i) {
    const Float part = (1 - cos(i * pi() / samples));
    take(apart(fine_->pressure(part * size), coarse_->pressure(part * coarse_->half_length()), scale));
  }
}

/// Once more with more terms until both agree.
void RollingContact::solve(const Float& half_length, const std::optional<Float>& load) {
  const Float enough = pow(Float(10), -digits_) / 4;
  Float size = half_length;
  for (int terms = first_terms(digits_);; terms += terms / 4) {
    const Fineness finer{terms + terms / 5, true};
    check_unknowns(rolling_layout(size, kernel_->memory(), finer),
                   load ? most_unknowns_for_load : most_unknowns, digits_);
    coarse_ = std::make_unique<RollingPressure>(solved(size, *kernel_, {terms, false}));
    if (load) {  // of the length that carries the load
      const auto slope_of = [&](const RollingPressure& one, const RollingPressure& other) {
        return log(one.load() / other.load()) / log(one.half_length() / other.half_length());
      };
      const Float step = pow(Float(10), -digits_ / 3);
      const RollingPressure beside = solved(size * (1 + step), *kernel_, {terms, false});
      const Float growth = slope_of(beside, *coarse_);
      const auto better = [&](const RollingPressure& now) {
        return now.half_length() * exp(log(*load / now.load()) / growth);
      };
      while (true) {
        const Float next = better(*coarse_);
        const Float change = abs(next / coarse_->half_length() - 1);
        if (change < pow(Float(10), -digits_ - 4)) break;
        coarse_ = std::make_unique<RollingPressure>(solved(next, *kernel_, {terms, false}));
      }
      size = coarse_->half_length();
      fine_ = std::make_unique<RollingPressure>(solved(size, *kernel_, finer));
      size = better(*fine_);
    }
    fine_ = std::make_unique<RollingPressure>(solved(size, *kernel_, finer));
    measure();
    if (difference_ <= enough) return;
  }
}

RollingContact RollingContact::of_half_length(const Float& half_length, std::vector<RollingMemory> memory,
                                              int digits) {
  RollingContact contact(std::move(memory), digits);
  contact.solve(half_length, std::nullopt);
  return contact;
}

RollingContact RollingContact::of_load(const Float& load, std::vector<RollingMemory> memory, int digits,
                                       const std::function<void(double half_length)>& check) {
  Float size = guessed_half_length(static_cast<double>(load), memory);
  {
    RollingKernel kernel(memory, search_digits + 6);
    const WorkingDigits working(search_digits + 10);
    Float last_size = size, last_load, growth = 2;
    for (int step = 0; step < most_load_steps; ++step) {
      check(static_cast<double>(size));
      const int terms = first_terms(digits);
      check_unknowns(rolling_layout(size, memory, {terms + terms / 5, true}), most_unknowns_for_load, digits);
      const Float now = solved(size, kernel, {first_terms(search_digits), false}).load();
      if (step > 0 && size != last_size) growth = log(now / last_load) / log(size / last_size);
      const Float factor = exp(log(load / now) / growth);
      last_size = std::exchange(size, (size * factor).at_working_precision());
      last_load = now;
      if (abs(factor - 1) < pow(Float(10), -search_digits + 2)) break;
    }
  }
  RollingContact contact(std::move(memory), digits);
  contact.solve(size, load);
  return contact;
}

FloatEstimate RollingContact::estimate(const Functional& functional, const Float& scale) const {
  Float value = functional(*fine_);
  Float error = 2 * abs(value - functional(*coarse_)) + difference_ * scale;
  return {std::move(value), std::move(error)};
}

}  // namespace nipref::ref
