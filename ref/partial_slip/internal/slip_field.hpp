#pragma once
#include <array>
#include <memory>
#include <vector>

#include <nipref/ref/partial_slip/internal/slip_contact.hpp>

namespace nipref::ref {

/// What a solved contact gives at any place: ref/partial_slip/README.md, Between the nodes.
class SlipField {
 public:
  explicit SlipField(std::unique_ptr<const SlipContact> contact);

  /// A place in a panel, in steps of the grid.
  struct Place {
    GridIndex panel;
    Float step;
  };
  /// Twice as many places as nodes, by rising e, where tractions and strain are known best.
  struct Sample {
    Place place;
    Float e, pressure, shear, weight;
  };

  [[nodiscard]] const SlipContact& contact() const { return *contact_; }
  [[nodiscard]] bool contains(const Float& e) const { return e > 0 && e < contact_->length(); }
  [[nodiscard]] const Row<Sample>& samples() const { return samples_; }
  [[nodiscard]] Place place_of(const Float& e) const;
  [[nodiscard]] Float e_of(const Place& place) const;
  /// p (0) or q (1), also outside; and its derivative by the steps of the grid.
  [[nodiscard]] Float traction(std::size_t of, const Float& e) const;
  [[nodiscard]] Float traction(std::size_t of, const Place& place) const;
  [[nodiscard]] Float slope(std::size_t of, const Place& place) const;
  /// dv/de.
  [[nodiscard]] Float strain(const Float& e) const;
  [[nodiscard]] Float strain(const Place& place) const;
  /// u, or v along +e up to a constant.
  struct Displacement {
    Float normal, tangential;
  };
  [[nodiscard]] Displacement displacement(const Float& e) const;
  /// int p (L1 - e) de.
  [[nodiscard]] Float moment() const;
  /// -int q (dv/de - xi) de.
  [[nodiscard]] Float dissipation() const;
  /// e of the largest |p| or |q|.
  [[nodiscard]] Float place_of_largest(std::size_t of) const;

 private:
  struct Remainder {
    Float first;  ///< the place of the first value, in steps; the others follow by halves
    std::array<Row<Float>, 2> values;
  };
  [[nodiscard]] Float remainder(std::size_t of, const Place& place) const;
  void add_displacement(const Float& e, const Float& from, const Float& load, const Float& sheared,
                        Displacement& sum) const;

  std::unique_ptr<const SlipContact> contact_;
  Row<Remainder> remainders_;
  Row<Sample> samples_;
};

}  // namespace nipref::ref
