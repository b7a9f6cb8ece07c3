#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/field_series.hpp>
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
  /// Those that are nearer than `reach` to what is between two alphas.
  [[nodiscard]] Range near(double left, double right, double reach) const;

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

  /// A line load.
  struct Node {
    double alpha, pressure, shear;
  };

  /// What it sees as near at one alpha.
  [[nodiscard]] ContactBlocks::Range near(double alpha) const;
  /// There at one depth.
  [[nodiscard]] SheetStresses at(double alpha, double depth) const;
  [[nodiscard]] std::span<const Node> nodes_of(const ContactBlocks::Range& blocks) const;
  /// What is beyond `near`, as seen from alpha.
  [[nodiscard]] std::optional<internal::FarLoads> to_the_left(const ContactBlocks::Range& near,
                                                              double alpha) const;
  [[nodiscard]] std::optional<internal::FarLoads> to_the_right(const ContactBlocks::Range& near,
                                                               double alpha) const;

 private:
  void add_nodes(std::size_t block, const FaceTractions& traction);
  void mirror();  ///< the right half's nodes to the left
  void sum_far();

  ContactBlocks blocks_;
  std::vector<Node> nodes_;
  /// Of all blocks to the left or to the right of where a block begins, as seen from there.
  std::vector<internal::FarLoads> to_the_left_, to_the_right_;
};

/// The same at many places: cells along the sheet, laid out as the blocks are, in each of which it is a power series.
class SheetPartInCells {
 public:
  /// `blocks` as for the part.
  SheetPartInCells(const SheetPart& part, const ContactBlocks& blocks);

  /// None far beyond the contact.
  [[nodiscard]] std::optional<long> cell_of(double alpha) const;
  [[nodiscard]] double centre(long cell) const { return length_ * (static_cast<double>(cell) + 0.5); }
  /// What counts as near, seen from there.
  [[nodiscard]] ContactBlocks::Range near(long cell) const;
  /// About its centre.
  [[nodiscard]] internal::StressSeries series(long cell);

 private:
  /// Which side's block, an end's or not, and how many blocks away: series of a load at each of its nodes.
  using Key = std::tuple<bool, bool, long>;
  [[nodiscard]] const std::vector<internal::FieldSeries>& by_nodes(std::size_t block, long cell);

  const SheetPart& part_;
  ContactBlocks blocks_;
  double length_ = 1;
  long blocks_of_cell_ = 1;
  std::map<Key, std::vector<internal::FieldSeries>> known_;
};

inline SheetStresses operator+(const SheetStresses& a, const SheetStresses& b) {
  return {a.across + b.across, a.along + b.along, a.shear + b.shear};
}
inline SheetStresses operator*(double factor, const SheetStresses& a) {
  return {factor * a.across, factor * a.along, factor * a.shear};
}

}  // namespace nipref::fast
