#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <nipref/fast/sheet/field.hpp>
#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast {

/// Pressure, and shear along the sheet, dimensionless, or sums over both.
template <class Number>
struct PressureAndShear {
  Number pressure, shear;

  void add(const Number& factor, const PressureAndShear<double>& of) {
    pressure += of.pressure * factor;
    shear += of.shear * factor;
  }
};
using FaceTraction = PressureAndShear<double>;

/// The traction at the distance e >= 0 from the right or the left end of a contact: continuous, 0 at the ends and
/// analytic between them.
using FaceTractions = std::function<FaceTraction(bool right, double e)>;

/// The parts of a contact that count as a whole as near to a place or far from it, numbered along the sheet: two graded
/// ends, one half-thickness long or half the contact if that is less, and between them blocks of equal length.
class ContactBlocks {
 public:
  struct Range {
    std::size_t begin, end;
  };

  explicit ContactBlocks(double half_length);

  [[nodiscard]] double half_length() const { return half_length_; }
  [[nodiscard]] double graded() const { return graded_; }  ///< length of the first and of the last
  [[nodiscard]] double inner() const { return inner_; }    ///< length of the others
  [[nodiscard]] std::size_t of_side() const { return of_side_; }
  [[nodiscard]] std::size_t count() const { return 2 * of_side_; }
  [[nodiscard]] double left_end(std::size_t block) const;
  [[nodiscard]] double length(std::size_t block) const {
    return block == 0 || block + 1 == count() ? graded_ : inner_;
  }
  /// The blocks that are nearer than `reach` to alpha.
  [[nodiscard]] Range near(double alpha, double reach) const;

 private:
  double half_length_, graded_, inner_;
  std::size_t of_side_;
};

/// A line load at the distance e from the end of its side.
struct LoadOnFace {
  double e;
  FaceTraction force;
};
/// Line loads that act as the tractions of a block do on polynomials; blocks are counted from the contact's end.
using LoadsOfBlock = std::function<std::vector<LoadOnFace>(bool right, std::size_t from_end)>;

/// The stresses of the sheet less those of both half-planes under the near blocks of tractions, and the whole stresses
/// under the far blocks; dimensionless, in the tractions' unit. The first are analytic within a distance of 2, the second,
/// sums over residues whose coefficients add up over all far blocks, within the distance of these. So both are polynomials
/// over a block, and its loads are shared among a few nodes as the polynomials through the nodes would have it.
class SheetPart {
 public:
  /// `symmetric`: the pressure is even about the middle and the shear odd.
  SheetPart(const ContactBlocks& blocks, bool symmetric, const LoadsOfBlock& loads);

  /// A line load.
  struct Node {
    double alpha;
    FaceTraction force;
  };

  /// The blocks that are near to alpha.
  [[nodiscard]] ContactBlocks::Range near(double alpha) const;
  [[nodiscard]] SheetStresses at(double alpha, double depth) const;
  /// The same of the displacements from the face at a depth of 0 to 1.
  [[nodiscard]] internal::FromFace from_face(double alpha, double depth, const internal::Shares& share) const;

 private:
  template <class Field>
  [[nodiscard]] Field under_all(double alpha, const auto& there) const;
  [[nodiscard]] std::span<const Node> nodes_of(const ContactBlocks::Range& blocks) const;
  void add_nodes(std::size_t block, const LoadsOfBlock& loads);
  void mirror();  ///< makes the left half's nodes from the right half's
  void sum_far();

  ContactBlocks blocks_;
  std::vector<Node> nodes_;
  /// Coefficients of all blocks to the left or to the right of the beginning of a block, for places about that
  /// beginning.
  std::vector<internal::FarLoads> to_the_left_, to_the_right_;
};

}  // namespace nipref::fast
