#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

/// One of the values of an axis.
struct AxisValue {
  std::string shown;  ///< as it was given, or the shortest decimal of a range's double
  std::string exact;  ///< the same, but the doubles of a range in hexadecimal
};

/// A name and the values that it takes one after the other.
struct Axis {
  std::string name;
  std::vector<AxisValue> values;
};

/// Whether a text means several values: "lo..hi", which may have a spacing as in ranges.hpp, or "a,b,c".
bool is_swept(const std::string& text);

/// The values of a list are its items without the blanks around them. Those of a range are about `points` different
/// doubles in ascending order, both ends included. Any other text is its own value. Throws BadInput naming `name` for
/// an empty item of a list, for a comma between digits, "1,5", which may be a decimal comma ("1, 5" and "1.0,5.0" are
/// lists), and where parse_range does; naming "points" for a range of no points or of more than 1e7.
Axis axis_of(const std::string& name, const std::string& text, std::size_t points);

/// All combinations of the axes' values, the last axis going fastest.
class AxesProduct {
 public:
  /// BadInput if there are more than 1e7.
  explicit AxesProduct(std::vector<Axis> axes);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const std::vector<Axis>& axes() const { return axes_; }
  /// The value of each axis in the combination of that number, which is less than size().
  [[nodiscard]] std::vector<const AxisValue*> at(std::size_t number) const;
  /// The same with the names of the axes, in the shown or in the exact form.
  [[nodiscard]] Assignments assignments(std::size_t number, std::string AxisValue::*form) const;

 private:
  std::vector<Axis> axes_;
  std::size_t size_ = 1;
};

}  // namespace nipref::verify
