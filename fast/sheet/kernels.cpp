#include <numbers>

#include <nipref/fast/sheet/internal/argument_checks.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {
namespace {

using internal::Component;
using internal::Domain;

/// The logarithmic kernels are infinite at 0.
template <Component component>
constexpr Domain domain = shape(component) == internal::Shape::logarithmic ? Domain::finite_nonzero
                                                                           : Domain::finite;

template <Component component>
double evaluate(std::string_view name, double argument, Accuracy accuracy) {
  internal::check_argument(name, argument, domain<component>);
  return internal::sheet_code().scalar[static_cast<int>(component)][accuracy.tier()](argument);
}

template <Component component>
void evaluate(std::string_view name, std::span<const double> argument, std::span<double> value,
              Accuracy accuracy) {
  internal::check_arguments(name, argument, value.size(), domain<component>);
  internal::sheet_code().batch[static_cast<int>(component)][accuracy.tier()](argument.data(), value.data(),
                                                                             value.size());
}

double half_pi_sign(double alpha) { return alpha == 0 ? 0 : std::copysign(std::numbers::pi / 2, alpha); }

}  // namespace

double I1(double alpha, Accuracy accuracy) { return evaluate<Component::I1>("alpha", alpha, accuracy); }
double I2(double alpha) {
  internal::check_argument("alpha", alpha, Domain::finite);
  return half_pi_sign(alpha);
}
double I3(double alpha, Accuracy accuracy) { return evaluate<Component::I3>("alpha", alpha, accuracy); }
double I4(double eta, Accuracy accuracy) { return evaluate<Component::I4>("eta", eta, accuracy); }
double I5(double eta, Accuracy accuracy) { return evaluate<Component::I5>("eta", eta, accuracy); }
double I6(double alpha, double eta, Accuracy accuracy) {
  internal::check_argument("alpha", alpha, Domain::finite_nonzero);
  internal::check_argument("eta", eta, Domain::finite);
  return internal::sheet_code().scalar_i6[accuracy.tier()](alpha, eta);
}
double I7(double eta, Accuracy accuracy) { return evaluate<Component::I7>("eta", eta, accuracy); }

void I1(std::span<const double> alpha, std::span<double> value, Accuracy accuracy) {
  evaluate<Component::I1>("alpha", alpha, value, accuracy);
}
void I2(std::span<const double> alpha, std::span<double> value) {
  internal::check_arguments("alpha", alpha, value.size(), Domain::finite);
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = half_pi_sign(alpha[i]);
}
void I3(std::span<const double> alpha, std::span<double> value, Accuracy accuracy) {
  evaluate<Component::I3>("alpha", alpha, value, accuracy);
}
void I4(std::span<const double> eta, std::span<double> value, Accuracy accuracy) {
  evaluate<Component::I4>("eta", eta, value, accuracy);
}
void I5(std::span<const double> eta, std::span<double> value, Accuracy accuracy) {
  evaluate<Component::I5>("eta", eta, value, accuracy);
}
void I6(std::span<const double> alpha, std::span<const double> eta, std::span<double> value,
        Accuracy accuracy) {
  internal::check_arguments("alpha", alpha, value.size(), Domain::finite_nonzero);
  internal::check_arguments("eta", eta, value.size(), Domain::finite);
  internal::sheet_code().batch_i6[accuracy.tier()](alpha.data(), eta.data(), value.data(), value.size());
}
void I7(std::span<const double> eta, std::span<double> value, Accuracy accuracy) {
  evaluate<Component::I7>("eta", eta, value, accuracy);
}

}  // namespace nipref::fast
