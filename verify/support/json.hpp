#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {

/// Thrown if a text is not JSON, or a JSON value is not of the type that is read from it.
struct JsonMisfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A JSON value: null, a truth value, a number, text, a list, or an object whose keys keep their order. An empty
/// optional becomes null, and so does an infinite number or a NaN. This class hides nlohmann-json, because a file that
/// includes that library takes four times as long to compile. data/schema describes the answers of the verbs.
class Json {
 public:
  using Member = std::pair<std::string_view, Json>;

  Json(std::nullptr_t = nullptr);
  Json(bool value);
  Json(long value);
  Json(std::integral auto value) : Json(static_cast<long>(value)) {}
  Json(double value);
  Json(std::string_view text);
  Json(const std::string& text) : Json(std::string_view(text)) {}
  Json(const char* text) : Json(std::string_view(text)) {}
  Json(const std::vector<Json>& list);
  Json(std::initializer_list<Member> members);
  template <class T>
  Json(const std::optional<T>& value) : Json(value ? Json(*value) : Json()) {}

  static Json object() { return std::initializer_list<Member>{}; }

  /// The double nearest to a decimal text; null for "inf" and "nan".
  static Json number(const std::string& text);
  /// Null for an empty text.
  static Json unless_empty(std::string_view text) { return text.empty() ? Json() : Json(text); }

  /// Sets a member of an object.
  void set(std::string_view key, const Json& value);

  /// Sets all members of another object, in their order.
  void append(const Json& members);

  /// A copy without the members of this name at any depth.
  [[nodiscard]] Json without(std::string_view key) const;
  /// A copy without the members whose names begin with '_', at any depth. These members are for the text alone.
  [[nodiscard]] Json for_machines() const;

  /// The value in lines indented by two, with a line break at the end; invalid UTF-8 is replaced.
  [[nodiscard]] std::string text() const;
  /// The value in one line, without a line break; invalid UTF-8 is replaced.
  [[nodiscard]] std::string line() const;

  // Reading. These functions throw JsonMisfit if the value is of another type.
  static Json parse(std::string_view text);
  [[nodiscard]] Json at(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const;  ///< false if this is no object
  [[nodiscard]] std::vector<Json> items() const;
  [[nodiscard]] std::string as_text() const;
  [[nodiscard]] std::uint64_t as_count() const;
  [[nodiscard]] std::optional<double> as_number() const;  ///< nothing if this is no number
  [[nodiscard]] bool is_null() const;

 private:
  friend std::string filled_text(const std::string& text, const Json& data,
                                 const std::map<std::string, std::string>& partials,
                                 const std::function<std::string(const std::string&)>& escape);
  /// The value as nlohmann-json stores it.
  struct Value;
  explicit Json(Value value);
  std::shared_ptr<const Value> value_;
};

/// The list of to_json(item) for all items. By default an item is itself the JSON value.
template <class Items, class ToJson = std::identity>
Json json_list(Items&& items, ToJson to_json = {}) {
  return mapped<Json>(items, to_json);
}

/// The object with these pairs of a key and a value as members.
template <class Pairs>
Json json_object(const Pairs& pairs) {
  Json all = Json::object();
  for (const auto& [key, value] : pairs) all.set(key, value);
  return all;
}

/// A double as a hexadecimal text, which is exact; infinities are allowed.
Json exact_json(double number);
/// Reads the text of exact_json; throws JsonMisfit for another text.
double exact_double(const Json& json);

}  // namespace nipref::verify
