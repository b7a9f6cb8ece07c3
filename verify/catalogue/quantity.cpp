#include <stdexcept>

#include <nipref/verify/catalogue/named_point.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

namespace {

constexpr auto kinds = [] {
  using enum ArgumentKind;
  constexpr double above_minus_1 = -1 + 0x1p-53;
  return std::to_array<KindOfNumber>(
      {{nonzero_position, "nonzero_position", "a finite nonzero number", -700, 700, 1e-300, 700},
       {position, "position", "a finite number", -700, 700, 1e-300, 700},
       {depth, "depth", "a number from -1 to 1", -1, 1},
       {young, "young", "a finite number > 0", 1e-6, 1e12, 1e-6, 1e12},
       {poisson, "poisson", "a number > -1 and <= 0.5", above_minus_1, 0.5, 0.5, -1},
       {index, "index", "a whole number from 1 to 1000000", 1, 1e6, 1, 1e6},
       {rate, "rate", "a finite number >= 0"},
       {amplitude, "amplitude", "a finite number"},
       {time, "time", "a finite number >= 0"},
       {passing_time, "passing_time", "a finite number"},
       {positive, "positive", "a finite number > 0"},
       {nonnegative, "nonnegative", "a finite number >= 0"},
       {degrees, "degrees", "a finite number"},
       {choice, "choice", ""}});
}();

}  // namespace

ArgumentKind argument_kind(std::string_view name) {
  const auto found = std::ranges::find(kinds, name, &KindOfNumber::name);
  if (found == kinds.end()) throw std::logic_error(fmt::format("there is no kind '{}' of arguments", name));
  return found->kind;
}

const KindOfNumber& kind_of_number(ArgumentKind kind) {
  return *std::ranges::find(kinds, kind, &KindOfNumber::kind);
}

std::string domain(const Argument& argument) {
  if (argument.kind != ArgumentKind::choice) return std::string(kind_of_number(argument.kind).domain);
  std::vector<std::string> names = argument.choices;
  // If models share a name, the later ones have numbered names as choices.
  std::erase_if(names, [](const std::string& name) { return name.find('/') != std::string::npos; });
  return fmt::format("{}", fmt::join(names, " or "));
}

const ModelKey* MaterialModel::key(std::string_view wanted) const {
  return item_with(keys, &ModelKey::name, wanted);
}

bool MaterialModel::holds(std::string_view argument_or_key) const {
  return key(argument_or_key) != nullptr || std::ranges::any_of(keys, [&](const ModelKey& one) {
           return std::ranges::find(one.arguments, argument_or_key) != one.arguments.end();
         });
}

double choice_number(const Argument& argument, const std::string& name) {
  const auto found = std::ranges::find(argument.choices, name);
  if (found == argument.choices.end())
    throw data::BadInput(argument.name, name, "must be " + domain(argument));
  return static_cast<double>(found - argument.choices.begin());
}

double default_number(const Argument& argument) {
  if (!argument.default_text) return 0;
  if (argument.kind != ArgumentKind::choice) return std::stod(*argument.default_text);
  return choice_number(argument, *argument.default_text);
}

Point point_of(const Quantity& quantity, const std::vector<std::pair<std::string_view, double>>& given) {
  Point point = mapped(quantity.arguments, default_number);
  for (const auto& [name, number] : given) point[argument_number(quantity.arguments, name)] = number;
  return point;
}

double fast_value(const Quantity& quantity, std::span<const double> point, fast::Accuracy accuracy) {
  return unless_refused([&] { return quantity.by_fast(point, accuracy); })
      .value_or(std::numeric_limits<double>::quiet_NaN());
}

ref::Estimate ref_value(const Quantity& quantity, std::span<const double> point, int digits) {
  std::vector<ref::Exact> exact;
  exact.reserve(point.size());
  for (std::size_t i = 0; i < point.size(); ++i) exact.emplace_back(point[i], quantity.arguments[i].name);
  return quantity.by_ref(exact, digits);
}

}  // namespace nipref::verify
