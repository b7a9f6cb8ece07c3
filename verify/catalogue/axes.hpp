#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/arguments.hpp>

namespace nipref::verify {

/// One value that a name goes through.
struct AxisValue {
  std::string shown;  ///< as it was given, or the shortest decimal of a range's double
  std::string exact;  ///< what it is: the same, of a range the double in hexadecimal
};

/// A name with the values that it goes through.
struct Axis {
  std::string name;
  std::vector<AxisValue> values;
};

/// Whether a text stands for more than one value: "lo..hi" with what ranges.hpp has behind it, or "a,b,c".
bool is_swept(const std::string& text);

/// The values of a list as they stand there, without blanks around them; of a range about `points` doubles, its ends
/// among them, each once and in order; of anything else itself. BadInput naming `name` for an empty item of a list, for
/// a comma with digits alone on both sides, "1,5", as it may be a decimal one ("1, 5" and "1.0,5.0" are lists), and as
/// parse_range has it; naming "points" for a range by none or by more than 1e7.
Axis axis_of(const std::string& name, const std::string& text, std::size_t points);

/// All combinations of the axes' values, the last axis going fastest.
class AxesProduct {
 public:
  /// BadInput if there are more than 1e7.
  explicit AxesProduct(std::vector<Axis> axes);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const std::vector<Axis>& axes() const { return axes_; }
  /// Each axis' value in combination `number` < size().
  [[nodiscard]] std::vector<const AxisValue*> at(std::size_t number) const;
  /// The same with the names, as they are shown or as they are exactly.
  [[nodiscard]] Assignments assignments(std::size_t number, std::string AxisValue::*form) const;

 private:
  std::vector<Axis> axes_;
  std::size_t size_ = 1;
};

}  // namespace nipref::verify
