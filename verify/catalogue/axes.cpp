#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr std::size_t most_combinations = 10'000'000;

bool is_range(const std::string& text) { return text.find("..") != std::string::npos; }

std::vector<AxisValue> values_of_range(const Range& range, std::size_t points) {
  std::vector<double> doubles;
  for (std::size_t i = 0; i < points; ++i)
    doubles.push_back(range.at(points == 1 ? 0 : static_cast<double>(i) / static_cast<double>(points - 1)));
  doubles.erase(std::ranges::unique(doubles).begin(), doubles.end());
  return mapped(doubles, [](double x) { return AxisValue{fmt::format("{}", x), fmt::format("{:a}", x)}; });
}

/// Whether the comma between the two texts may be a decimal comma: in many languages 1,5 means 1.5.
bool may_be_one_number(std::string_view before, std::string_view after) {
  before.remove_prefix(std::min(before.find_first_not_of(" +-"), before.size()));
  after = after.substr(0, after.find_first_of("eE "));
  const auto is_whole = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  };
  return is_whole(before) && is_whole(after);
}

std::vector<AxisValue> values_of_list(const std::string& name, const std::string& text) {
  std::vector<AxisValue> values;
  std::string before;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    const std::string raw = text.substr(start, comma - start), item = trimmed(raw);
    if (item.empty()) throw BadInput(name, text, "must be a list of values with one comma between two");
    if (may_be_one_number(before, raw))
      refuse(name, text, "must be {0}.{1} if that is one number, or '{0}, {1}', with a blank, if it is two",
             trimmed(before), item);
    values.push_back({item, item});
    before = raw;
    start = comma + 1;
  }
  return values;
}

}  // namespace

bool is_swept(const std::string& text) { return is_range(text) || text.find(',') != std::string::npos; }

Axis axis_of(const std::string& name, const std::string& text, std::size_t points) {
  if (is_range(text) && (points == 0 || points > most_combinations))
    refuse("points", std::to_string(points), "must be 1 to {} for {}", most_combinations, name);
  return {name,
          is_range(text) ? values_of_range(parse_range(name, text), points) : values_of_list(name, text)};
}

AxesProduct::AxesProduct(std::vector<Axis> axes) : axes_(std::move(axes)) {
  for (const Axis& axis : axes_) {
    if (axis.values.size() > most_combinations / size_)
      refuse(axis.name, fmt::format("{} values", axis.values.size()),
             "must be few enough for {} combinations at most", most_combinations);
    size_ *= axis.values.size();
  }
}

std::vector<const AxisValue*> AxesProduct::at(std::size_t number) const {
  std::vector<const AxisValue*> values(axes_.size());
  for (std::size_t i = axes_.size(); i-- > 0; number /= axes_[i].values.size())
    values[i] = &axes_[i].values[number % axes_[i].values.size()];
  return values;
}

Assignments AxesProduct::assignments(std::size_t number, std::string AxisValue::*form) const {
  Assignments assignments;
  const std::vector<const AxisValue*> values = at(number);
  for (std::size_t i = 0; i < axes_.size(); ++i) assignments.emplace_back(axes_[i].name, values[i]->*form);
  return assignments;
}

}  // namespace nipref::verify
