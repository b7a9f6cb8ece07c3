#include <cstdlib>
#include <nlohmann/json.hpp>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

using Tree = nlohmann::ordered_json;

struct Json::Value {
  Tree tree;
};

namespace {

void erase_everywhere(Tree& value, const std::string& key) {
  if (value.is_object()) value.erase(key);
  if (!value.is_structured()) return;
  for (Tree& item : value) erase_everywhere(item, key);
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
  erase_everywhere(changed, std::string(key));
  return Json(Value{std::move(changed)});
}

std::string Json::text() const { return value_->tree.dump(2, ' ', false, Tree::error_handler_t::replace) + "\n"; }

}  // namespace nipref::verify
