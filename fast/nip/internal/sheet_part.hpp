#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast {

/// Pressure, and shear along the sheet, dimensionless.
struct FaceTraction {
  double pressure, shear;
};

/// The traction at the distance e >= 0 from the right or the left end of a contact; continuous, 0 at the ends, analytic
/// between but for the ends.
using FaceTractions = std::function<FaceTraction(bool right, double e)>;

/// What a place sees as near or as far, whole: a contact's two graded ends, a half-thickness long or half of the contact
/// if that is less, and between them parts of one length, numbered along the sheet.
class ContactBlocks {
 public:
  struct Range {
    std::size_t begin, end;
  };

  explicit ContactBlocks(double half_length);

  [[nodiscard]] double half_length() const { return half_length_; }
  [[nodiscard]] double graded() const { return graded_; }  ///< length of the first and of the last
  [[nodiscard]] double inner() const { return inner_; }    ///< of those between
  [[nodiscard]] std::size_t of_side() const { return of_side_; }
  [[nodiscard]] std::size_t count() const { return 2 * of_side_; }
  [[nodiscard]] double left_end(std::size_t block) const;
  [[nodiscard]] double length(std::size_t block) const {
    return block == 0 || block + 1 == count() ? graded_ : inner_;
  }
  /// Those that are near to what is between two alphas.
  [[nodiscard]] Range near(double left, double right) const;

 private:
  double half_length_, graded_, inner_;
  std::size_t of_side_;
};

/// What the sheet adds to the stresses of both half-planes that are loaded by the near blocks of tractions, and the whole
/// of what the far ones make: analytic up to a distance of 2, from some ten nodes a half-thickness; what is far as one,
/// by what it has of each residue. Dimensionless, in the tractions' unit.
class SheetPart {
 public:
  /// `symmetric`: the pressure is even about the middle and the shear odd.
  SheetPart(const ContactBlocks& blocks, bool symmetric, const FaceTractions& traction);

  /// Adds it at one alpha, `near` as seen from there or from an interval about it.
  void add(double alpha, const ContactBlocks::Range& near, const internal::StressesAtDepths& depths,
           std::span<SheetStresses> sums) const;

 private:
  struct Node {
    double alpha, pressure, shear;
  };

  void add_nodes(std::size_t block, const FaceTractions& traction);
  void mirror();  ///< the right half's nodes to the left
  void sum_far();
  [[nodiscard]] std::span<const Node> nodes_of(const ContactBlocks::Range& blocks) const;

  ContactBlocks blocks_;
  std::vector<Node> nodes_;
  /// Of all blocks to the left or to the right of where a block begins, as seen from there.
  std::vector<internal::FarLoads> to_the_left_, to_the_right_;
};

/// The sheet's part at one alpha as a series in the square of the depth: stresses across and along are even in it, the
/// shear over the depth too.
class SheetPartAcross {
 public:
  static constexpr std::size_t count = 14;

  SheetPartAcross(const SheetPart& part, const ContactBlocks::Range& near, double alpha);
  SheetPartAcross() = default;  ///< 0
  /// Adds that of another alpha.
  void add(double weight, const SheetPartAcross& other);

  [[nodiscard]] SheetStresses at(double depth) const;

 private:
  std::array<SheetStresses, count> coefficient_{};
};

/// The same between two alphas, from some of them.
class SheetPartBetween {
 public:
  static constexpr std::size_t count = 24;

  SheetPartBetween(const SheetPart& part, const ContactBlocks::Range& near, double left, double right);

  [[nodiscard]] SheetStresses at(double alpha, double depth) const;

 private:
  double left_, length_;
  std::array<SheetPartAcross, count> coefficient_{};
};

inline SheetStresses operator+(const SheetStresses& a, const SheetStresses& b) {
  return {a.across + b.across, a.along + b.along, a.shear + b.shear};
}
inline SheetStresses operator*(double factor, const SheetStresses& a) {
  return {factor * a.across, factor * a.along, factor * a.shear};
}

}  // namespace nipref::fast
