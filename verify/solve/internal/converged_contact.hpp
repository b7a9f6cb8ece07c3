#pragma once
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <nipref/verify/solve/internal/derived_results.hpp>
#include <nipref/verify/solve/internal/inside.hpp>
#include <nipref/verify/solve/internal/result_sizes.hpp>

namespace nipref::verify {

/// A converged nip of either path, elastic or rolling: a result is computed by the function of the contact's class that
/// has its name. If the class has no such function, the result follows from the symmetry of an elastic nip, or it is 0
/// because there is no friction.
template <class Path, class Contact>
class ConvergedContact : public SolvedContact<typename Path::Number> {
 public:
  using Number = typename Path::Number;
  using WorkOf = fast::Work (*)(const Contact&);

  /// accuracy: the requested relative accuracy, for the reference 10^-digits.
  ConvergedContact(Contact contact, double roller_radius, double accuracy, WorkOf work_of)
      : contact_(std::move(contact)), roller_radius_(roller_radius), accuracy_(accuracy), work_of_(work_of) {}

  [[nodiscard]] Number number(ResultId id) const override {
    switch (id) {
      case ResultId::contact_length:
        return contact_.contact_length();
      case ResultId::leading_length:
        return leading_length();
      case ResultId::trailing_length:
        return trailing_length();
      case ResultId::load:
        return contact_.load();
      case ResultId::indentation:
        return contact_.indentation();
      case ResultId::edge_displacement:
        return edge_displacement();
      case ResultId::trailing_displacement:
        return trailing_displacement();
      case ResultId::creep_ratio:
        return contact_.creep_ratio();
      case ResultId::peak_pressure:
        return contact_.peak_pressure();
      case ResultId::greatest_shear:
      case ResultId::greatest_shear_position:
      case ResultId::greatest_shear_depth:
        return inside_.number(contact_, id);
      default:
        return special_number(id);
    }
  }
  [[nodiscard]] Number at(ResultId id, double y) const override {
    switch (id) {
      case ResultId::pressure:
        return contact_.pressure(y);
      case ResultId::shear:
        if constexpr (has_shear) return contact_.shear(y);
        return Path::exactly(0, 16);
      case ResultId::normal_displacement:
        return contact_.normal_displacement(y);
      case ResultId::tangential_displacement:
        return contact_.tangential_displacement(y);
      case ResultId::surface_strain:
        return contact_.surface_strain(y);
      default:
        if constexpr (requires { contact_.slip(y); }) {
          if (id == ResultId::slip) return contact_.slip(y);
        }
        throw std::logic_error("no profile of this contact");
    }
  }
  [[nodiscard]] std::vector<Number> inside(ResultId id, const data::FieldPlaces& places) const override {
    return inside_.field(contact_, id, places);
  }
  [[nodiscard]] std::vector<Number> list(ResultId) const override {
    std::vector<Number> zeros;
    if constexpr (requires { contact_.shear_zeros(); }) {
      for (const auto& zero : contact_.shear_zeros()) zeros.push_back(zero);
    }
    return zeros;
  }
  [[nodiscard]] ProfileExtent profile_extent() const override {
    const auto [first, last] = ends();
    return is_rolling ? ProfileExtent{first, last} : ProfileExtent{0, last};
  }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double y) const override {
    const auto [first, last] = ends();
    const NipSize size{roller_radius_, first, last, accuracy_};
    const auto middle = [&] { return pressure_in_the_middle(); };
    // The reference's digits of an elastic nip are relative to the result alone, except for the stresses inside.
    if (!Path::is_fast && !is_rolling && data::scene_result(id).needs != data::Needs::inside) return {};
    return nip_result_size(id, y, size, middle);
  }
  bool refine() override {
    if constexpr (Path::is_fast) {
      middle_.reset();
      inside_ = {};
      return contact_.refine();
    }
    return false;
  }
  [[nodiscard]] fast::Work work() const override { return work_of_(contact_); }

 private:
  static constexpr bool is_rolling = requires(const Contact& contact) { contact.leading_length(); };
  static constexpr bool has_shear = requires(const Contact& contact) { contact.shear(0); };

  [[nodiscard]] Number leading_length() const {
    if constexpr (is_rolling)
      return contact_.leading_length();
    else
      return 0.5 * contact_.contact_length();
  }
  [[nodiscard]] Number trailing_length() const {
    if constexpr (is_rolling)
      return contact_.trailing_length();
    else
      return leading_length();
  }
  [[nodiscard]] Number edge_displacement() const {
    if constexpr (is_rolling)
      return contact_.leading_displacement();
    else
      return contact_.edge_displacement();
  }
  [[nodiscard]] Number trailing_displacement() const {
    if constexpr (is_rolling)
      return contact_.trailing_displacement();
    else
      return edge_displacement();
  }
  /// Results for which only some classes have a function; they are 0 for the other classes.
  [[nodiscard]] Number special_number(ResultId id) const {
    if constexpr (is_rolling) {
      if (id == ResultId::rolling_resistance) return contact_.rolling_resistance();
    }
    if constexpr (requires { contact_.peak_pressure_position(); }) {
      if (id == ResultId::peak_pressure_position) return contact_.peak_pressure_position();
    }
    if constexpr (has_shear) {
      if (id == ResultId::peak_shear) return contact_.peak_shear();
      if (id == ResultId::peak_shear_position) return contact_.peak_shear_position();
    }
    if constexpr (Path::is_fast) {
      if (is_moment(id)) return moment_of_pressure(*this, id);
    }
    return Path::exactly(0, 16);
  }

  [[nodiscard]] ProfileExtent ends() const {
    if constexpr (is_rolling)
      return {-value_of(contact_.trailing_length()), value_of(contact_.leading_length())};
    const double half = value_of(contact_.contact_length()) / 2;
    return {-half, half};
  }
  /// It is cached, as every number of a field needs it.
  [[nodiscard]] double pressure_in_the_middle() const {
    if (!middle_) middle_ = value_of(contact_.pressure(0));
    return *middle_;
  }

  Contact contact_;
  double roller_radius_, accuracy_;
  WorkOf work_of_;
  mutable std::optional<double> middle_;
  Inside<Contact, Path> inside_;
};

}  // namespace nipref::verify
