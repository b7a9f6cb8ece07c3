#pragma once
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/solve/internal/paths.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {

/// The angle in degrees plus that of the motion. The two senses of an axis are equivalent, so that it is from -90 to 90.
inline fast::Estimate from_x1(const fast::Estimate& from_motion, double motion) {
  return {std::remainder(from_motion.value + motion, 180),
          from_motion.error + 0x1p-52 * (std::fabs(from_motion.value) + std::fabs(motion))};
}
inline ref::Estimate from_x1(ref::Estimate angle, double motion) {
  mpfr_prec_round(angle.value.get(), angle.value.precision() + 64, MPFR_RNDN);
  mpfr_add_d(angle.value.get(), angle.value.get(), motion, MPFR_RNDN);
  ref::Real half_turn(64);
  mpfr_set_ui(half_turn.get(), 180, MPFR_RNDN);
  mpfr_remainder(angle.value.get(), angle.value.get(), half_turn.get(), MPFR_RNDN);
  return angle;
}

/// A body on a half-space by either path: the functions of Contact have the names of the results. It is solved when a
/// result first needs it; Surface gives what depends on the solids and the speed alone.
template <class Path, class Surface, class Contact>
class HalfSpaceContact : public SolvedContact<typename Path::Number> {
 public:
  using Number = typename Path::Number;
  using Line = typename Path::Line;
  using Make = Contact (*)(const Surface&, const data::HalfSpaceProblem&, int digits);

  /// accuracy: the requested relative accuracy, for the reference 10^-digits. The digits are the reference's.
  HalfSpaceContact(Surface surface, const data::HalfSpaceProblem& problem, double accuracy, int digits,
                   Make make)
      : surface_(std::move(surface)), problem_(problem), accuracy_(accuracy), digits_(digits), make_(make) {}

  [[nodiscard]] Number number(ResultId id) const override {
    switch (id) {
      case ResultId::span_along:
        return span(0);
      case ResultId::span_across:
        return span(90);
      case ResultId::span_ratio:
        return contact().span_ratio(Path::line(90));
      case ResultId::normal_force:
        return force();
      case ResultId::friction_force:
        return by_friction(force());
      case ResultId::peak_pressure:
        return contact().peak_pressure();
      case ResultId::critical_speed:
        return surface_.critical_speed();
      case ResultId::centre_along:
      case ResultId::centre_across:
        return centre(id);
      default:
        return of_ellipse(id);
    }
  }
  /// `place`: an angle from the motion in degrees, or a position on the scene's line.
  [[nodiscard]] Number at(ResultId id, double place) const override {
    switch (id) {
      case ResultId::pressure:
        return contact().pressure(Path::line(*problem_.line), typename Path::Position(place));
      case ResultId::shear:
        return shear(place);
      case ResultId::span:
        return span(place);
      case ResultId::leading_end:
        return leading_end(Path::line(place));
      case ResultId::trailing_end:
        return trailing_end(place);
      case ResultId::compliance:
        return surface_.compliance(place);
      case ResultId::coupling:
        return surface_.coupling(place);
      default:
        return of_rolling(id, Path::line(place));
    }
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    if (!problem_.line) return {-90, 90};
    return {value_of(trailing_end(*problem_.line)), value_of(leading_end(Path::line(*problem_.line)))};
  }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double place) const override {
    return half_space_result_size(id, place, accuracy_, *this,
                                  [&] { return value_of(surface_.compliance(place)); });
  }
  [[nodiscard]] fast::Work work() const override {
    fast::Work work;
    work.line_responses = surface_.evaluations();
    return work;
  }

 private:
  [[nodiscard]] const Contact& contact() const {
    if (!contact_) contact_ = make_(surface_, problem_, digits_);
    return *contact_;
  }
  [[nodiscard]] Number exactly(double value) const { return Path::exactly(value, digits_); }
  /// The reference returns what the scene gives without an error.
  [[nodiscard]] Number span(double degrees) const {
    const auto* given = std::get_if<data::GivenSpan>(&problem_.given);
    if (!Path::is_fast && given != nullptr && degrees == 0) return exactly(given->along);
    return contact().span(Path::line(degrees));
  }
  [[nodiscard]] Number force() const {
    const auto* given = std::get_if<data::GivenNormalForce>(&problem_.given);
    if (!Path::is_fast && given != nullptr) return exactly(given->force);
    return contact().force();
  }
  [[nodiscard]] Number by_friction(const Number& normal) const { return exactly(problem_.friction) * normal; }
  /// Friction times the pressure of a sliding body, or the shear under a rolling sphere.
  [[nodiscard]] Number shear(double x) const {
    if constexpr (requires { contact().shear(Path::line(x), typename Path::Position(x)); })
      return contact().shear(Path::line(*problem_.line), typename Path::Position(x));
    return by_friction(at(ResultId::pressure, x));
  }
  /// x+ on the line in this direction; it is half of the span where the centre is the point of first touch.
  [[nodiscard]] Number leading_end(const Line& psi) const {
    if constexpr (requires { contact().leading_end(psi); }) return contact().leading_end(psi);
    return 0.5 * contact().span(psi);
  }
  [[nodiscard]] Number trailing_end(double degrees) const {
    return -1 * leading_end(Path::reversed(Path::line(degrees)));
  }
  [[nodiscard]] Number centre(ResultId id) const {
    if constexpr (requires { contact().centre_along(); }) {
      if (Path::is_fast || problem_.friction != 0)
        return id == ResultId::centre_along ? contact().centre_along() : contact().centre_across();
    }
    return exactly(0);
  }
  /// Scene::check allows these results for a rolling sphere only.
  [[nodiscard]] Number of_rolling(ResultId id, const Line& psi) const {
    if constexpr (requires { contact().creep(psi); })
      return id == ResultId::creep ? contact().creep(psi) : contact().compressed_radius(psi);
    refuse(id);
  }
  /// Scene::check allows these results for the exact method only.
  [[nodiscard]] Number of_ellipse(ResultId id) const {
    if constexpr (requires { contact().axis_ratio(); }) {
      if (id == ResultId::axis_ratio) return contact().axis_ratio();
      if (id == ResultId::approach) return contact().approach();
      return from_x1(contact().orientation(), problem_.direction);
    }
    refuse(id);
  }
  [[noreturn]] static void refuse(ResultId id) {
    throw data::BadInput("wanted", data::scene_result(id).name, "must be out of what this method has");
  }

  Surface surface_;
  data::HalfSpaceProblem problem_;
  double accuracy_;
  int digits_;
  Make make_;
  mutable std::optional<Contact> contact_;
};

}  // namespace nipref::verify
