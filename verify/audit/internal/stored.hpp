#pragma once
#include <concepts>

#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

// Findings as JSON in a run's folder. A struct names its parts once, for both directions: members(self, each) calls
// each(key, part, key, part, ...) with all parts that are stored.

/// Calls one(key, part) for each pair of what it is called with.
template <class One>
struct EachPart {
  One one;

  void operator()() const {}
  void operator()(std::string_view key, auto& part, auto&... more) const {
    one(key, part);
    (*this)(more...);
  }
};

inline Json stored(double number) { return exact_json(number); }
inline Json stored(std::integral auto count) { return count; }
inline Json stored(const std::string& text) { return text; }
template <class T>
Json stored(const std::optional<T>& part) {
  return part ? stored(*part) : Json();
}
template <class T>
Json stored(const std::vector<T>& list) {
  return json_list(list, [](const T& one) { return stored(one); });
}
template <class T>
requires std::is_class_v<T> Json stored(const T& parts) {
  if constexpr (requires { parts.json(); }) {
    return parts.json();
  } else {
    Json json = Json::object();
    T::members(parts, EachPart{[&](std::string_view key, const auto& part) { json.set(key, stored(part)); }});
    return json;
  }
}

inline void restore(double& number, const Json& json) { number = exact_double(json); }
template <std::integral Count>
void restore(Count& count, const Json& json) {
  count = static_cast<Count>(json.as_count());
}
inline void restore(std::string& text, const Json& json) { text = json.as_text(); }
template <class T>
void restore(std::optional<T>& part, const Json& json) {
  if (!json.is_null()) restore(part.emplace(), json);
}
template <class T>
void restore(std::vector<T>& list, const Json& json) {
  for (const Json& one : json.items()) restore(list.emplace_back(), one);
}
template <class T>
requires std::is_class_v<T>
void restore(T& parts, const Json& json) {
  if constexpr (requires { T::of(json); }) {
    parts = T::of(json);
  } else {
    T::members(parts, EachPart{[&](std::string_view key, auto& part) { restore(part, json.at(key)); }});
  }
}

/// What stored() has made of such a struct or list. JsonMisfit for anything else.
template <class T>
T restored(const Json& json) {
  T parts{};
  restore(parts, json);
  return parts;
}

}  // namespace nipref::verify
