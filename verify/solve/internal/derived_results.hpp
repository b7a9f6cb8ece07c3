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
/// Whether it is leading_moment or trailing_moment.
bool is_moment(ResultId id);

/// leading_moment = int p Y dY ahead of the line through the rollers' centres, trailing_moment behind it (thesis
/// 7.13), by Gauss's rule. The error is the integrated error of the pressure and twice the difference from half as
/// many nodes.
fast::Estimate moment_of_pressure(const SolvedContact<fast::Estimate>& contact, ResultId id);

/// A solved contact with the results that follow from its other results for every method:
///   eccentricity = R mu_R, resistance_force = W mu_R, power_loss = speed W mu_R     (thesis 7.12, 7.14, 7.15)
///   slip = v' - creep ratio, v' the strain of the surface: by (2.5) the surface moves at F_0 (1 + v') and the rollers
///     at F_0 (1 + creep ratio), so that the slip is the velocity of sliding over F_0. It is 0 in a contact with full
///     friction. Without friction the creep ratio is the mean strain, so that the mean slip in the contact is 0.
///     Outside the contact it is the slip that there would be if the surfaces touched.
/// Their errors follow from those of the other results.
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
  [[nodiscard]] Number slip(double y) const;  ///< used by the reference only
  /// It is cached, as it is a result by itself and a term of the slip.
  [[nodiscard]] const Number& strain(double y) const;

  const data::Scene& scene_;
  const SolvedContact<Number>& contact_;
  mutable std::optional<Number> creep_;  ///< a term of every slip
  mutable std::map<double, Number> strains_;
};

}  // namespace nipref::verify
