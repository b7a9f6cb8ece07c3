#include <nlohmann/json.hpp>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

struct Json::Value : nlohmann::ordered_json {
  using nlohmann::ordered_json::ordered_json;
  Value(nlohmann::ordered_json json) : nlohmann::ordered_json(std::move(json)) {}
};

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

std::string Json::text() const { return value_->dump(2) + "\n"; }

}  // namespace nipref::verify
