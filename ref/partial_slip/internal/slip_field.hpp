#pragma once
#include <functional>
#include <memory>
#include <optional>

#include <nipref/ref/partial_slip/internal/slip_contact.hpp>

namespace nipref::ref {

/// The results of a solved contact at any place: ref/partial_slip/README.md, Between the nodes.
class SlipField {
 public:
  explicit SlipField(std::unique_ptr<const SlipContact> contact);

  /// One of the places where tractions and slip are known best: about twice as many as nodes, by rising e.
  struct Sample {
    GridIndex panel;
    int sign;
    Float step, e, slip, weight;
    OfBoth<Float> tractions;
  };
  /// A local maximum of |p| or |q|.
  struct Hump {
    Float size, e;
  };

  [[nodiscard]] const SlipContact& contact() const { return *contact_; }
  [[nodiscard]] const Row<Sample>& samples() const { return samples_; }
  [[nodiscard]] const Row<SlipZone>& zones() const { return contact_->zones(); }

  [[nodiscard]] Float length() const { return contact_->panels().length(); }
  [[nodiscard]] Float leading() const { return contact_->leading(); }
  [[nodiscard]] Float trailing() const { return length() - leading(); }
  [[nodiscard]] Float boundary(GridIndex zone) const;  ///< e at which the zone begins
  [[nodiscard]] Float load() const { return contact_->integral(pressure_part); }
  [[nodiscard]] Float traction() const { return contact_->integral(shear_part); }
  [[nodiscard]] Float creep() const { return contact_->creep(); }
  [[nodiscard]] Float leading_displacement() const { return displacement(0).normal; }
  [[nodiscard]] Float trailing_displacement() const { return displacement(length()).normal; }
  [[nodiscard]] Float indentation() const { return leading_displacement() + leading() * leading(); }
  [[nodiscard]] Float rolling_resistance() const;  ///< 2/load int p (L1 - e) de
  [[nodiscard]] Float dissipation() const;         ///< -int q (dv/de - xi) de
  /// All local maxima, and the values where panels meet.
  [[nodiscard]] Row<Hump> humps(std::size_t of) const;
  [[nodiscard]] Hump largest(std::size_t of) const;

  // Inside and outside the contact.
  [[nodiscard]] OfBoth<Float> tractions(const Float& e) const;
  [[nodiscard]] Float pressure(const Float& e) const { return tractions(e)[pressure_part]; }
  [[nodiscard]] Float shear(const Float& e) const { return tractions(e)[shear_part]; }
  [[nodiscard]] Float strain(const Float& e) const;  ///< dv/de
  [[nodiscard]] Float slip(const Float& e) const { return strain(e) - creep(); }
  [[nodiscard]] Float normal_displacement(const Float& e) const;
  /// Along +e, relative to the line through the rollers' centres.
  [[nodiscard]] Float tangential_displacement(const Float& e) const;

 private:
  /// A place in a panel, in steps of the grid.
  struct Place {
    GridIndex panel;
    Float step;
  };
  /// The remainders of a panel's tractions beyond their linear interpolation.
  struct Remainders {
    Float first;  ///< place of the first value, in steps; the others follow in half steps
    OfBoth<Row<Float>> values;
  };

  [[nodiscard]] bool contains(const Float& e) const { return e > 0 && e < length(); }
  [[nodiscard]] Place place_of(const Float& e) const;
  [[nodiscard]] OfBoth<Float> remainders(const Place& place) const;
  [[nodiscard]] OfBoth<Float> tractions(const Place& place) const;
  [[nodiscard]] OfBoth<Float> tractions(const ContactPoint& point, const OfBoth<Float>& remainders) const;
  [[nodiscard]] Float strain_at(const Place& place, const PointSums& sums,
                                const OfBoth<Float>& remainders) const;
  /// Is called with a line load at `from`. Sums over the line loads of for_loads() are integrals of p and q times
  /// kernels that are singular at e.
  using UseLoad = std::function<void(const Float& from, const Float& pressed, const Float& sheared)>;
  void for_loads(const Float& e, const UseLoad& use) const;
  /// The displacement up to a constant.
  [[nodiscard]] NormalAndTangential<Float> displacement(const Float& e) const;

  std::unique_ptr<const SlipContact> contact_;
  Row<Remainders> remainders_;
  Row<Sample> samples_;
  mutable std::optional<Float> tangential_in_middle_;
};

}  // namespace nipref::ref
