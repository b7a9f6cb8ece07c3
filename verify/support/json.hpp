#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nipref::verify {

/// Thrown where text is no JSON, or JSON is not what is read from it: what, in a word or two.
struct JsonMisfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a verb answers to machines: null, a truth value, a number, text, a list, or an object whose keys keep
/// their order. What is not known is null: an empty optional, and a number that is infinite or none. A wall
/// around nlohmann-json: a file that includes all of that takes four times as long to compile. What the verbs'
/// answers look like is written down in data/schema.
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

  /// The double that a decimal text means; of "inf" and "nan" null.
  static Json number(const std::string& text);
  /// Null if there is none.
  static Json unless_empty(std::string_view text) { return text.empty() ? Json() : Json(text); }

  /// Sets a member of an object.
  void set(std::string_view key, const Json& value);

  /// Sets all members of another object, in their order.
  void append(const Json& members);

  /// Itself, but at no depth with a member of that name.
  [[nodiscard]] Json without(std::string_view key) const;

  /// Indented by two, with a line break at the end; what is no UTF-8 is replaced.
  [[nodiscard]] std::string text() const;
  /// The same in one line, with no line break.
  [[nodiscard]] std::string line() const;

  // Reading: JsonMisfit where it is something else.
  static Json parse(std::string_view text);
  [[nodiscard]] Json at(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const;  ///< false for what is no object
  [[nodiscard]] std::vector<Json> items() const;
  [[nodiscard]] std::string as_text() const;
  [[nodiscard]] std::uint64_t as_count() const;
  [[nodiscard]] bool is_null() const;

 private:
  struct Value;
  explicit Json(Value value);
  std::shared_ptr<const Value> value_;
};

/// A list with what `to_json` makes of each item.
template <class Items, class ToJson>
Json json_list(const Items& items, ToJson to_json) {
  std::vector<Json> list;
  for (const auto& item : items) list.push_back(to_json(item));
  return list;
}

/// A double as text that stands for it to the last bit, infinities too.
Json exact_json(double number);
/// JsonMisfit for what is no such text.
double exact_double(const Json& json);

}  // namespace nipref::verify
