#include <nlohmann/json.hpp>

#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/internal/template.hpp>

namespace nipref::verify {

using Tree = nlohmann::ordered_json;

struct Json::Value {
  Tree tree;
};

namespace {

/// Erases the members at any depth whose key satisfies `is_erased`.
template <class IsErased>
void erase_everywhere(Tree& value, IsErased is_erased) {
  if (!value.is_structured()) return;
  std::vector<std::string> erased;
  if (value.is_object()) {
    for (const auto& [name, member] : value.items())
      if (is_erased(name)) erased.push_back(name);
  }
  for (const std::string& name : erased) value.erase(name);
  for (Tree& item : value) erase_everywhere(item, is_erased);
}

}  // namespace

Json::Json(Value value) : value_(std::make_shared<const Value>(std::move(value))) {}
Json::Json(std::nullptr_t) : Json(Value{nullptr}) {}
Json::Json(bool value) : Json(Value{value}) {}
Json::Json(long value) : Json(Value{value}) {}
Json::Json(double value) : Json(Value{value}) {}
Json::Json(std::string_view text) : Json(Value{text}) {}

Json::Json(const std::vector<Json>& list) {
  Tree tree = Tree::array();
  for (const Json& item : list) tree.push_back(item.value_->tree);
  *this = Json(Value{std::move(tree)});
}

Json::Json(std::initializer_list<Member> members) {
  Tree tree = Tree::object();
  for (const auto& [key, member] : members) tree[std::string(key)] = member.value_->tree;
  *this = Json(Value{std::move(tree)});
}

void Json::set(std::string_view key, const Json& value) {
  Tree changed = value_->tree;
  changed[std::string(key)] = value.value_->tree;
  *this = Json(Value{std::move(changed)});
}

Json Json::number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

void Json::append(const Json& members) {
  Tree changed = value_->tree;
  changed.update(members.value_->tree);
  *this = Json(Value{std::move(changed)});
}

Json Json::without(std::string_view key) const {
  Tree changed = value_->tree;
  erase_everywhere(changed, [&](const std::string& name) { return name == key; });
  return Json(Value{std::move(changed)});
}

Json Json::for_machines() const {
  Tree changed = value_->tree;
  erase_everywhere(changed, [](const std::string& name) { return name.starts_with('_'); });
  return Json(Value{std::move(changed)});
}

std::string Json::text() const {
  return value_->tree.dump(2, ' ', false, Tree::error_handler_t::replace) + "\n";
}
std::string Json::line() const { return value_->tree.dump(-1, ' ', false, Tree::error_handler_t::replace); }

Json Json::parse(std::string_view text) {
  Tree tree = Tree::parse(text, nullptr, false);
  if (tree.is_discarded()) throw JsonMisfit("no JSON");
  return Json(Value{std::move(tree)});
}

Json Json::at(std::string_view key) const {
  const auto found = value_->tree.find(std::string(key));
  if (!value_->tree.is_object() || found == value_->tree.end()) throw JsonMisfit(std::string(key));
  return Json(Value{*found});
}

bool Json::has(std::string_view key) const {
  return value_->tree.is_object() && value_->tree.contains(std::string(key));
}

std::vector<Json> Json::items() const {
  if (!value_->tree.is_array()) throw JsonMisfit("no list");
  return mapped(value_->tree, [](const Tree& item) { return Json(Value{item}); });
}

std::string Json::as_text() const {
  if (!value_->tree.is_string()) throw JsonMisfit("no text");
  return value_->tree.get<std::string>();
}

std::uint64_t Json::as_count() const {
  if (!value_->tree.is_number_unsigned() &&
      !(value_->tree.is_number_integer() && value_->tree.get<long>() >= 0))
    throw JsonMisfit("no count");
  return value_->tree.get<std::uint64_t>();
}

std::optional<double> Json::as_number() const {
  return value_->tree.is_number() ? std::optional(value_->tree.get<double>()) : std::nullopt;
}

bool Json::is_null() const { return value_->tree.is_null(); }

Json exact_json(double number) { return fmt::format("{:a}", number); }

double exact_double(const Json& json) {
  if (const auto number = number_in(json.as_text())) return *number;
  throw JsonMisfit("no number");
}

std::string filled_text(const std::string& text, const Json& data, const Partials& partials,
                        const Escape& escape) {
  return filled_text(text, data.value_->tree, partials, escape);
}

}  // namespace nipref::verify
