#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_contact.hpp>

namespace nipref::ref {
namespace {

/// A minute or two; a load takes several solutions.
constexpr int most_unknowns = 1400, most_unknowns_for_load = 1000;
constexpr int guard_digits = 14;  ///< of the arithmetic beyond the results
constexpr int spare_digits = 6;   ///< of those, what the kernels need not have
constexpr int search_digits = 8, fine_search_digits = 12;
constexpr int most_load_steps = 40;

/// Sheet and pressure change within so many half-thicknesses or so.
constexpr double sheet_length = 2.5;

/// The distance from the ends in which the pressure changes, half-thicknesses: the shortest memory's, less where it softens
/// the sheet much, or that in which a fluid flows by as much as it gives way at once.
double end_length(const std::vector<RollingMemory>& memory) {
  double length = sheet_length;
  for (const RollingMemory& term : memory) {
    const Float change =
        is_flow(term) ? abs(term.amplitude) : std::max(abs(term.rate), Float(abs(term.amplitude) / 4));
    length = std::min(length, 2 / static_cast<double>(change));
  }
  return length;
}

/// What begins at an end fades over the distance from there, but what swings does so within that.
double longest_panel(const std::vector<RollingMemory>& memory) {
  double longest = std::numeric_limits<double>::infinity();
  for (const RollingMemory& term : memory) {
    if (!term.rate.is_real()) longest = std::min(longest, 2 / static_cast<double>(term.rate.im));
  }
  return std::max(sheet_length, longest);
}

/// How finely a contact is cut.
struct Fineness {
  int terms;
  bool other_panels;
};

RollingLayout rolling_layout(const Float& half_length, const std::vector<RollingMemory>& memory,
                             const Fineness& fineness) {
  const double first = end_length(memory), longest = longest_panel(memory);
  const auto size = static_cast<double>(half_length);
  const bool other = fineness.other_panels;
  if (first >= 2 * size && size <= 0.5) return {half_length, size, 2, longest, !other, fineness.terms};
  if (!other) return {half_length, first, 2, longest, false, fineness.terms};
  return {half_length, 0.7 * std::min(first, size), 2.25, longest, false, fineness.terms};
}

/// That are likely to give so many digits: each brings a factor of 5.8 or so.
int first_terms(int digits) { return static_cast<int>(digits * 2.302585 / 1.763) + 2; }

void check_unknowns(const RollingLayout& layout, int most, int digits) {
  if (layout.unknowns() <= most) return;
  throw data::BadInput("digits", std::to_string(digits),
                       "must be fewer, or the contact shorter or its memory longer: the reference tries " +
                           std::to_string(most) + " unknowns at most here");
}

std::unique_ptr<RollingPressure> solved(const Float& half_length, RollingKernel& kernel,
                                        const Fineness& fineness) {
  return std::make_unique<RollingPressure>(half_length,
                                           rolling_layout(half_length, kernel.memory(), fineness), kernel);
}

/// A guess at the half length that carries a load, a few tens of per cent off at most where memories are long
/// or short: between a half-space and springs, with the compliance that the contact meets.
double guessed_half_length(double load, const std::vector<RollingMemory>& memory) {
  double size = 1;
  for (int i = 0; i < 60; ++i) {
    double softness = 1;
    for (const RollingMemory& term : memory)
      softness += static_cast<double>((term.amplitude / (term.rate + ComplexFloat(1 / size))).re);
    size = std::sqrt(size * std::sqrt(load * softness / (3.14159 + 8 * size / 3)));
  }
  return size;
}

/// Digits that are lost where memories make the sheet far softer than it is at once, a fluid over a
/// half-thickness: their parts cancel.
int digits_of_softness(const std::vector<RollingMemory>& memory) {
  double softness = 1;
  for (const RollingMemory& term : memory)
    softness +=
        static_cast<double>(is_flow(term) ? abs(term.amplitude) : abs(term.amplitude) / abs(term.rate));
  return static_cast<int>(std::log10(softness));
}

/// Steps that grow as a load does, by the slope of the last two.
class LoadSteps {
 public:
  LoadSteps(Float load, Float growth) : load_(std::move(load)), growth_(std::move(growth)) {}

  /// The length that should carry the load, from one that carries another.
  Float next(const Float& size, const Float& load_here) {
    if (last_size_ && *last_size_ != size) growth_ = log(load_here / *last_load_) / log(size / *last_size_);
    last_size_ = size, last_load_ = load_here;
    return at_working_precision(size * exp(log(load_ / load_here) / growth_));
  }
  [[nodiscard]] const Float& growth() const { return growth_; }

 private:
  Float load_, growth_;
  std::optional<Float> last_size_, last_load_;
};

}  // namespace

int RollingContact::working_digits(const RollingMaterial& material, int digits) {
  return digits + guard_digits + digits_of_softness(material.normal);
}

RollingContact::RollingContact(const RollingMaterial& material, int digits)
    : digits_(digits),
      working_digits_(working_digits(material, digits)),
      normal_(std::make_unique<NormalRollingKernel>(material, working_digits_ - spare_digits)),
      tangential_(std::make_unique<TangentialRollingKernel>(material, working_digits_ - spare_digits)),
      stretch_(std::make_unique<StretchRollingKernel>(material, working_digits_ - spare_digits)) {}

void RollingContact::measure() {
  const auto apart = [](const Float& x, const Float& y, const Float& scale) { return abs(x - y) / scale; };
  const Float& size = fine_->half_length();
  const Float square = size * size;
  difference_ = ldexp(Float(1), 20 - working_bits());
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

int RollingContact::first_unknowns(const Float& half_length, const RollingMaterial& material, int digits) {
  const int terms = first_terms(digits);
  const RollingLayout layout = rolling_layout(half_length, material.normal, {terms + terms / 5, true});
  check_unknowns(layout, most_unknowns, digits);
  return layout.unknowns();
}

/// Once more with more terms until both agree.
void RollingContact::solve_for_length(const Float& half_length) {
  const Float enough = pow(Float(10), -digits_) / 4;
  for (int terms = first_terms(digits_);; terms += terms / 4) {
    const int more = terms + terms / 5;
    check_unknowns(rolling_layout(half_length, normal_->memory(), {more, true}), most_unknowns, digits_);
    coarse_ = solved(half_length, *normal_, {terms, false});
    fine_ = solved(half_length, *normal_, {more, true});
    measure();
    if (difference_ <= enough) return;
  }
}

/// Both of the length that carries the load: what either still lacks shows in their difference.
void RollingContact::solve_for_load(Sought sought) {
  const Float enough = pow(Float(10), -digits_) / 4, exact = enough / 8;
  Float size = sought.half_length;
  for (int terms = first_terms(digits_);; terms += terms / 4) {
    const int more = terms + terms / 5;
    check_unknowns(rolling_layout(size, normal_->memory(), {more, true}), most_unknowns_for_load, digits_);
    for (const bool fine : {false, true}) {
      LoadSteps steps(sought.load, sought.growth);
      auto& contact = fine ? fine_ : coarse_;
      for (int step = 0; step < most_load_steps; ++step) {
        contact = solved(size, *normal_, {fine ? more : terms, fine});
        size = steps.next(size, contact->load());
        if (abs(size / contact->half_length() - 1) < exact) break;
      }
      sought.growth = steps.growth();
    }
    measure();
    const Float lacking = abs(fine_->load() / sought.load - 1);
    if (lacking > difference_) difference_ = lacking;
    if (difference_ <= enough) return;
  }
}

RollingContact RollingContact::of_half_length(const Float& half_length, const RollingMaterial& material,
                                              int digits) {
  RollingContact contact(material, digits);
  contact.solve_for_length(half_length);
  return contact;
}

/// With few digits, and then a few more.
RollingContact::Sought RollingContact::search(const Float& load, const RollingMaterial& material, int digits,
                                              const std::function<void(double half_length)>& check) {
  const int most_terms = first_terms(digits);
  const WorkingDigits working(fine_search_digits + 10);
  NormalRollingKernel kernel(material, fine_search_digits + 6);
  Float size = guessed_half_length(static_cast<double>(load), material.normal);
  Float growth = 2;
  for (const int digits_here : {search_digits, fine_search_digits}) {
    LoadSteps steps(load, growth);
    for (int step = 0; step < most_load_steps; ++step) {
      check(static_cast<double>(size));
      check_unknowns(rolling_layout(size, material.normal, {most_terms + most_terms / 5, true}),
                     most_unknowns_for_load, digits);
      const Float next = steps.next(size, solved(size, kernel, {first_terms(digits_here), false})->load());
      const Float change = abs(next / size - 1);
      size = next;
      if (change < pow(Float(10), -digits_here + 3)) break;
    }
    growth = steps.growth();
  }
  return {load, size, growth};
}

RollingContact RollingContact::of_load(const Float& load, const RollingMaterial& material, int digits,
                                       const std::function<void(double half_length)>& check) {
  const Sought sought = search(load, material, digits, check);
  RollingContact contact(material, digits);
  contact.solve_for_load(sought);
  return contact;
}

data::WithError<Float> RollingContact::estimate(const Functional& functional, const Float& scale) const {
  Float value = functional(*fine_);
  Float error = 2 * abs(value - functional(*coarse_)) + difference_ * scale;
  return {std::move(value), std::move(error)};
}

}  // namespace nipref::ref
