#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/verify/catalogue/internal/nip_entry.hpp>
#include <nipref/verify/support/internal/cache.hpp>

namespace nipref::verify {
namespace {

/// The contacts of a family with their arguments, solved by either path.
struct SolvedNips {
  NipSolver solver;
  std::vector<Argument> arguments;
  Cache<std::vector<double>, NipEstimates> by_fast;
  Cache<std::vector<double>, NipReferences> by_ref;

  NipEstimates solved(std::span<const double> x, fast::Accuracy accuracy) const {
    return solver.fast({arguments, x}, accuracy);
  }
  fast::Estimate fast(std::span<const double> x, fast::Accuracy accuracy, std::size_t number) {
    std::vector<double> key(x.begin(), x.end());
    key.push_back(accuracy.rtol());
    return (*by_fast.at(key, [&] { return solved(x, accuracy); }))[number];
  }
  ref::Estimate ref(std::span<const double> x, int digits, std::size_t number) {
    std::vector<double> key(x.begin(), x.end());
    key.push_back(digits);
    return (*by_ref.at(key, [&] { return solver.ref({arguments, x}, digits); }))[number];
  }
};

Quantity nip_entry(Quantity entry, const std::shared_ptr<SolvedNips>& nips, std::size_t number) {
  entry.ref_takes_doubles = true;
  entry.by_ref = [nips, number](std::span<const ref::Exact> x, int digits) {
    return nips->ref(mapped(x, &ref::Exact::approximate), digits, number);
  };
  // The bench times the loop, which therefore solves each contact anew.
  set_fast(entry, [nips, number](std::span<const double> x, fast::Accuracy accuracy) {
    return nips->solved(x, accuracy)[number].value;
  });
  entry.by_fast = [nips, number](std::span<const double> x, fast::Accuracy accuracy) {
    return nips->fast(x, accuracy, number).value;
  };
  entry.fast_error = [nips, number](std::span<const double> x, fast::Accuracy accuracy) {
    return nips->fast(x, accuracy, number).error;
  };
  return entry;
}

}  // namespace

void check_nip_length(double L_over_B) {
  if (!(L_over_B >= shortest_nip && L_over_B <= longest_nip))
    throw data::BadInput("L_over_B", L_over_B, "must be from 1e-8 to 1000");
}

double nip_accuracy(fast::Accuracy accuracy) { return std::clamp(accuracy.rtol(), 1e-13, 0.1); }

ref::Estimate in_unit(ref::Estimate number, const mpq_class& factor) {
  const mpq_class size = abs(factor);
  ref::Float rounding = ref::zero_of_bits(64);
  mpfr_mul_q(ref::raw(number.value), ref::raw(number.value), factor.get_mpq_t(), MPFR_RNDN);
  mpfr_mul_q(ref::raw(number.error), ref::raw(number.error), size.get_mpq_t(), MPFR_RNDU);
  mpfr_abs(ref::raw(rounding), ref::raw(number.value), MPFR_RNDU);
  mpfr_mul_2si(ref::raw(rounding), ref::raw(rounding), -ref::bits_of(number.value), MPFR_RNDU);
  mpfr_add(ref::raw(number.error), ref::raw(number.error), ref::raw(rounding), MPFR_RNDU);
  return number;
}

fast::Estimate in_unit(const fast::Estimate& number, double factor) {
  // The factor has three rounding errors and the product one.
  const double value = number.value * factor;
  return {value, number.error * factor + 0x1p-51 * std::fabs(value)};
}

std::vector<Quantity> nip_entries(std::string_view family, const NipSolver& solver) {
  const auto nips = std::make_shared<SolvedNips>();
  nips->solver = solver;
  std::vector<Quantity> entries;
  for (const Quantity& row : described_quantities()) {
    if (row.family != family) continue;
    nips->arguments = row.arguments;
    entries.push_back(nip_entry(row, nips, entries.size()));
  }
  return entries;
}

double likely_seconds(const data::ElasticNip& nip, data::Friction friction, double length, int digits,
                      int most_terms) {
  const int terms = ref::proven_terms(nip, friction, length, digits, most_terms);
  if (terms > 0) return long_time * std::pow(terms / double{terms_in_long_time}, 2);
  const double unknowns = ref::elastic_unknowns(nip, friction, length, digits);
  const double thin = std::min(1.0, length / nip.sheet_thickness / 20);
  return 0.1 + 0.8e-6 * digits * (1 + thin) * unknowns * unknowns;
}

double likely_seconds(const data::ViscoelasticNip& nip, double length, int digits) {
  const double unknowns = ref::rolling_unknowns(nip, length, digits);
  const double thin = std::min(3.0, std::sqrt(length / nip.sheet_thickness / 5));
  return 0.1 + digits * unknowns * (2.5e-4 * (1 + thin) + 0.3e-6 * unknowns);
}

int most_digits_in_time(const std::function<double(int digits)>& seconds) {
  for (int digits = 50; digits >= 16; --digits) {
    const auto taken = unless_refused([&] { return seconds(digits); });
    if (taken && *taken <= long_time) return digits;
  }
  return 0;
}

}  // namespace nipref::verify
