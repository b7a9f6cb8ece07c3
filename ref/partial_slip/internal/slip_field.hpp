#pragma once
#include <memory>
#include <vector>

#include <nipref/ref/partial_slip/internal/slip_contact.hpp>

namespace nipref::ref {

/// What a solved contact gives at any place: ref/partial_slip/README.md, Between the nodes.
class SlipField {
 public:
  explicit SlipField(std::unique_ptr<const SlipContact> contact);

  /// Twice as many places as nodes, by rising e, where tractions and slip are known best.
  struct Sample {
    GridIndex panel;
    Float step, e, slip, weight;
    OfBoth<Float> tractions;
  };
  struct Hump {
    Float size, e;
  };

  [[nodiscard]] const SlipContact& contact() const { return *contact_; }
  [[nodiscard]] const Row<Sample>& samples() const { return samples_; }

  [[nodiscard]] const Float& length() const { return length_; }
  [[nodiscard]] const Float& leading() const { return contact_->leading(); }
  [[nodiscard]] const Float& creep() const { return contact_->creep(); }
  [[nodiscard]] Float trailing() const { return length() - leading(); }
  [[nodiscard]] Float load() const { return contact_->integral(pressure_part); }
  [[nodiscard]] Float traction() const { return contact_->integral(shear_part); }
  /// u at the ends, and what it would be in the middle.
  [[nodiscard]] Float leading_displacement() const { return displacement(0).normal; }
  [[nodiscard]] Float trailing_displacement() const { return displacement(length()).normal; }
  [[nodiscard]] Float indentation() const { return leading_displacement() + leading() * leading(); }
  /// 2/load int p (L1 - e) de.
  [[nodiscard]] Float rolling_resistance() const;
  /// -int q (dv/de - xi) de.
  [[nodiscard]] Float dissipation() const;
  /// All local maxima of |p| or |q|, also where zones meet.
  [[nodiscard]] Row<Hump> humps(std::size_t of) const;
  [[nodiscard]] Hump largest(std::size_t of) const;

  /// p and q, also outside.
  [[nodiscard]] OfBoth<Float> tractions(const Float& e) const;
  /// dv/de.
  [[nodiscard]] Float strain(const Float& e) const;
  /// u, and v along +e, up to a constant.
  [[nodiscard]] NormalAndTangential<Float> displacement(const Float& e) const;

 private:
  /// A place in a panel, in steps of the grid.
  struct Place {
    GridIndex panel;
    Float step;
  };
  /// Of a panel, what tractions have besides their linear interpolation.
  struct Remainders {
    Float first;  ///< the place of the first, in steps; the others follow by halves
    OfBoth<Row<Float>> values;
  };

  [[nodiscard]] bool contains(const Float& e) const { return e > 0 && e < length_; }
  [[nodiscard]] Place place_of(const Float& e) const;
  [[nodiscard]] OfBoth<Float> remainders(const Place& place) const;
  [[nodiscard]] OfBoth<Float> tractions(const Place& place) const;
  [[nodiscard]] OfBoth<Float> tractions(const ContactPoint& point, const OfBoth<Float>& remainders) const;
  [[nodiscard]] Float strain_at(const Place& place, const PointSums& sums,
                                const OfBoth<Float>& remainders) const;

  std::unique_ptr<const SlipContact> contact_;
  Float length_;
  Row<Remainders> remainders_;
  Row<Sample> samples_;
};

}  // namespace nipref::ref
