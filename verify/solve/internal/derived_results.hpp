#pragma once
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <nipref/data/scene/scene.hpp>
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// Whether a result of a nip is a product of others: eccentricity, resistance_force, power_loss.
bool is_product(ResultId id);
/// leading_moment, trailing_moment.
bool is_moment(ResultId id);

/// leading_moment = int p Y dY ahead of the line through the rollers' centres, trailing_moment behind it (thesis 7.13): by
/// Gauss's rule over the pressure of a contact; the error is that of the pressure and what half as many nodes leave.
fast::Estimate moment_of_pressure(const SolvedContact<fast::Estimate>& contact, ResultId id);

/// A solved contact, and what follows from its results whatever the method:
///   eccentricity = R mu_R, resistance_force = W mu_R, power_loss = speed W mu_R     (thesis 7.12, 7.14, 7.15)
///   slip = v' - creep ratio, v' the surface's strain: as (2.5) has it the surface moves by F_0 (1 + v') where the
///     rollers move by F = F_0 (1 + creep ratio), so that this is the rate at which it slides on them, over F_0. It is 0 in
///     a contact with full friction; without friction, where the creep ratio is the mean strain, its mean there is 0.
///     Outside the contact it says how it would slide if it touched.
/// Errors are those of what they follow from.
template <class Number>
class WithDerivedResults : public SolvedContact<Number> {
 public:
  /// Both must live as long as this.
  WithDerivedResults(const data::Scene& scene, const SolvedContact<Number>& contact)
      : scene_(scene), contact_(contact) {}

  [[nodiscard]] Number number(ResultId id) const override;
  [[nodiscard]] Number at(ResultId id, double y) const override;
  [[nodiscard]] std::vector<Number> inside(ResultId id, const data::FieldPlaces& places) const override {
    return contact_.inside(id, places);
  }
  [[nodiscard]] std::vector<Number> list(ResultId id) const override { return contact_.list(id); }
  [[nodiscard]] ProfileExtent profile_extent() const override { return contact_.profile_extent(); }
  [[nodiscard]] std::optional<double> least_size(ResultId id, double y) const override;
  [[nodiscard]] fast::Work work() const override { return contact_.work(); }
  [[nodiscard]] fast::Work error_work() const override { return contact_.error_work(); }

 private:
  [[nodiscard]] Number slip(double y) const;  ///< fast's contacts know their own
  /// Asked for by itself and with the slip there.
  [[nodiscard]] const Number& strain(double y) const;

  const data::Scene& scene_;
  const SolvedContact<Number>& contact_;
  mutable std::optional<Number> creep_;  ///< asked for with every slip
  mutable std::map<double, Number> strains_;
};

}  // namespace nipref::verify
