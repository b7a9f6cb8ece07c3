#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/fast/number/accuracy.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/verify/support/random.hpp>

namespace nipref::verify {

/// Values of a quantity's arguments, in its order.
using Point = std::vector<double>;

/// The kind of an argument, which determines its domain in words and the way it is sampled.
enum class ArgumentKind {
  nonzero_position,  ///< distance/half-thickness; the kernel is infinite at 0
  position,          ///< distance/half-thickness
  depth,             ///< distance from the middle plane/half-thickness
  young,             ///< Young's modulus, unit of stress
  poisson,           ///< Poisson's ratio
  index,             ///< number of a root
  rate,              ///< 1/time
  amplitude,         ///< constant of a material function
  time,              ///< time since a load started
  passing_time,      ///< time at which a load passes a point
  positive,          ///< speed, half-thickness, modulus, relaxation time
  nonnegative,       ///< speed, coefficient of friction
  degrees,           ///< an angle
  choice             ///< one of a few: on the command line a name, in a Point its number
};

/// A key of a material's model, named as in a scene, and the arguments that hold its number or its list of numbers.
struct ModelKey {
  std::string name;
  std::vector<std::string> arguments;
  bool is_whole = false;  ///< all numbers must be given; otherwise those that are missing at the end are 0
};

/// A model of a material as a user writes it, MODEL(KEY=VALUE, KEY=[VALUE, ...]). Models of one name have other keys.
struct MaterialModel {
  std::string name;
  std::vector<ModelKey> keys;

  [[nodiscard]] const ModelKey* key(
      std::string_view name) const;  ///< null if the model has none of that name
  [[nodiscard]] bool holds(
      std::string_view argument_or_key) const;  ///< whether it is written within the model
};

struct Argument {
  std::string name;
  ArgumentKind kind;
  std::optional<std::string> default_text;  ///< none: the argument must be given
  std::vector<double>
      hard_values;  ///< where large errors are likely: internal branch points, limits, ends of the domain
  std::vector<std::string> choices = {};   ///< names of a choice, in the order of their numbers
  std::vector<MaterialModel> models = {};  ///< of a material: what a user writes for each choice

  [[nodiscard]] const std::string& choice(double number) const {
    return choices[static_cast<std::size_t>(number)];
  }
};

/// The properties of a kind of arguments.
struct KindOfNumber {
  ArgumentKind kind;
  std::string_view name, domain;  ///< the domain in words that continue "must be ..."
  // Audits take only numbers from `least` to `most`.
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
  // Audits spread numbers from `from` to `to`, evenly in the logarithm if both are positive. For kinds without these
  // two, the quantity draws its own points.
  double from = 0, to = 1;
};
const KindOfNumber& kind_of_number(ArgumentKind kind);

/// The kind of that name. std::logic_error if there is none.
ArgumentKind argument_kind(std::string_view name);

/// The number of a choice. BadInput naming the argument if it has none of that name.
double choice_number(const Argument& argument, const std::string& name);

/// Domain of an argument, in words that continue "must be ...".
std::string domain(const Argument& argument);

/// A method of another library, or of the thesis, for a quantity of one argument in double, timed beside fast.
struct Peer {
  std::string method;
  /// Makes the evaluator, with everything that can be reused for many arguments.
  std::function<std::function<double(double)>()> make;
};

/// A method of another library for such a quantity, to a given number of digits.
struct MultiprecisionPeer {
  std::string method;
  /// Decimal text of the value at a decimal argument; only the numbers of digits in bench's ladder are
  /// available.
  std::function<std::string(const std::string& argument, int digits)> evaluate;
};

/// A formula of the seed that is wrong or was evaluated coarsely, in double, for users who compare with the seed.
struct SeedForm {
  std::string
      name;  ///< "printed": the equation as it stands; "table": the formula that gives the seed's table
  std::string differs;  ///< its difference from the correct formula, one line
  std::function<double(std::span<const double> arguments)> value;
};

/// An entry of the catalogue: all that the verbs need to know about a quantity. Texts and numbers are in
/// quantities.toml.
struct Quantity {
  std::string name;
  std::string definition;  ///< one line
  std::string notation;    ///< the same with its formulas between backticks, see formula.hpp
  std::string source;      ///< seed and equation number
  std::string scale;       ///< the size against which errors are measured, in words
  std::string unit = "1";  ///< of the value; 1: none
  std::vector<Argument> arguments;
  /// The argument in which a user writes the constants of a half-space, solid=MODEL(KEY=VALUE, KEY=[VALUE, ...]). It
  /// has only one model, which needs no number in a point.
  std::optional<Argument> solid = {};
  double promise;  ///< fast at full accuracy: largest error in units in the last place of the scale

  std::function<ref::Estimate(std::span<const ref::Exact> arguments, int digits)> by_ref;
  std::function<double(std::span<const double> arguments, fast::Accuracy accuracy)> by_fast;
  /// The error that fast states for its value, unit of the quantity; it must cover the true error, as the promise must.
  /// If it is empty, fast states the promise alone.
  std::function<double(std::span<const double> arguments, fast::Accuracy accuracy)> fast_error;
  /// Whether the reference, too, takes the doubles nearest to the arguments, because its problem is given in doubles.
  bool ref_takes_doubles = false;
  int most_digits = 1000;  ///< largest number of digits that the reference computes
  /// The values at many points, given as one column for each argument: by a loop over the scalar interface, and by the
  /// batch interface, which is empty if there is none.
  using Columns = std::span<const std::span<const double>>;
  std::function<void(Columns columns, std::span<double> values, fast::Accuracy accuracy)> by_fast_loop;
  std::function<void(Columns columns, std::span<double> values, fast::Accuracy accuracy)> by_fast_batch;
  /// The size that the value would have away from its zeros, unit of the quantity; 0 if it is the value itself.
  std::function<double(std::span<const double> arguments)> envelope;

  /// Draws a point for audits, if the arguments depend on each other so much that they cannot be drawn one by one.
  std::function<Point(Random&)> draw;
  /// Moves a point away from places where the quantity is infinite or where the reference alone refuses it, if these
  /// depend on several arguments.
  std::function<void(Point&)> keep_off;
  /// Whether each value needs the solution of a contact or a new material. The bench times such a quantity only if it
  /// is named, and only at a few points.
  bool is_costly = false;
  std::size_t audit_points = 20'000;  ///< unless the caller says how many
  /// The name that quantities share if one solution gives them all: they are audited at the same points, so that each
  /// solution is used for all of them. It is empty for a quantity that has its own points.
  std::string family = {};
  std::string subject = {};  ///< the name of the folders of fast and ref that compute it

  std::vector<SeedForm> seed_forms;  ///< the seed's formulas that differ from the right one
  std::vector<Peer> peers;
  std::vector<MultiprecisionPeer> multiprecision_peers;

  /// The name for which random points are drawn: that of the family, or the quantity's own.
  [[nodiscard]] const std::string& drawn_for() const { return family.empty() ? name : family; }
};

/// fast's value of `quantity` at `point`, or a quiet NaN if fast refuses the point: a NaN fails every check.
double fast_value(const Quantity& quantity, std::span<const double> point, fast::Accuracy accuracy);

/// The digits of a reference value whose own error is 1e-5 of a double's unit in the last place.
inline constexpr int digits_beyond_double = 21;

/// ref's value at exactly these doubles, as fast takes them.
ref::Estimate ref_value(const Quantity& quantity, std::span<const double> point, int digits);

}  // namespace nipref::verify
