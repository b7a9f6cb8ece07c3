#include <cstdlib>
#include <nlohmann/json.hpp>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

struct Json::Value : nlohmann::ordered_json {
  using nlohmann::ordered_json::ordered_json;
  Value(nlohmann::ordered_json json) : nlohmann::ordered_json(std::move(json)) {}
};

namespace {

void erase_everywhere(nlohmann::ordered_json& value, const std::string& key) {
  if (value.is_object()) value.erase(key);
  if (!value.is_structured()) return;
  for (nlohmann::ordered_json& item : value) erase_everywhere(item, key);
}

}  // namespace

Json::Json(std::nullptr_t) : value_(std::make_shared<Value>()) {}
Json::Json(bool value) : value_(std::make_shared<Value>(value)) {}
Json::Json(long value) : value_(std::make_shared<Value>(value)) {}
Json::Json(double value) : value_(std::make_shared<Value>(value)) {}
Json::Json(std::string_view text) : value_(std::make_shared<Value>(text)) {}

Json::Json(const std::vector<Json>& list) {
  Value value = Value::array();
  for (const Json& item : list) value.push_back(*item.value_);
  value_ = std::make_shared<Value>(std::move(value));
}

Json::Json(std::initializer_list<Member> members) {
  Value value = Value::object();
  for (const auto& [key, member] : members) value[std::string(key)] = *member.value_;
  value_ = std::make_shared<Value>(std::move(value));
}

void Json::set(std::string_view key, const Json& value) {
  Value changed = *value_;
  changed[std::string(key)] = *value.value_;
  value_ = std::make_shared<Value>(std::move(changed));
}

Json Json::number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

void Json::append(const Json& members) {
  Value changed = *value_;
  changed.update(*members.value_);
  value_ = std::make_shared<Value>(std::move(changed));
}

Json Json::without(std::string_view key) const {
  Value changed = *value_;
  erase_everywhere(changed, std::string(key));
  Json result;
  result.value_ = std::make_shared<Value>(std::move(changed));
  return result;
}

std::string Json::text() const { return value_->dump(2, ' ', false, Value::error_handler_t::replace) + "\n"; }

}  // namespace nipref::verify
