#pragma once
#include <gmpxx.h>

#include <concepts>

#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

// Findings as JSON in a run's folder. A struct names its stored parts once, for writing and reading: members(self,
// each) calls each(key, part, key, part, ...).

/// A function that calls one(key, part) for each pair of its arguments.
template <class One>
struct EachPart {
  One one;

  void operator()() const {}
  void operator()(std::string_view key, auto& part, auto&... more) const {
    one(key, part);
    (*this)(more...);
  }
};
/// Clang 16 does not deduce the argument of an aggregate by itself.
template <class One>
EachPart(One) -> EachPart<One>;

inline Json stored(double number) { return exact_json(number); }
inline Json stored(std::integral auto count) { return count; }
inline Json stored(const std::string& text) { return text; }
inline Json stored(const mpz_class& count) { return count.get_str(); }
template <class T>
Json stored(const std::optional<T>& part) {
  return part ? stored(*part) : Json();
}
template <class T>
Json stored(const std::vector<T>& list) {
  return json_list(list, [](const T& one) { return stored(one); });
}
/// A map is stored as a list in which keys and values alternate.
template <class Key, class Value>
Json stored(const std::map<Key, Value>& pairs) {
  std::vector<Json> all;
  for (const auto& [key, value] : pairs) all.insert(all.end(), {stored(key), stored(value)});
  return all;
}
template <class T>
requires std::is_class_v<T> Json stored(const T& parts) {
  Json json = Json::object();
  T::members(parts, EachPart{[&](std::string_view key, const auto& part) { json.set(key, stored(part)); }});
  return json;
}

inline void restore(double& number, const Json& json) { number = exact_double(json); }
template <std::integral Count>
void restore(Count& count, const Json& json) {
  count = static_cast<Count>(json.as_count());
}
inline void restore(std::string& text, const Json& json) { text = json.as_text(); }
inline void restore(mpz_class& count, const Json& json) {
  const std::string digits = json.as_text();
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos) throw JsonMisfit(digits);
  count = mpz_class(digits, 10);
}
template <class T>
void restore(std::optional<T>& part, const Json& json) {
  if (!json.is_null()) restore(part.emplace(), json);
}
template <class T>
void restore(std::vector<T>& list, const Json& json) {
  for (const Json& one : json.items()) restore(list.emplace_back(), one);
}
template <class Key, class Value>
void restore(std::map<Key, Value>& pairs, const Json& json) {
  const std::vector<Json> all = json.items();
  if (all.size() % 2 != 0) throw JsonMisfit("a key without a value");
  for (std::size_t i = 0; i < all.size(); i += 2) {
    Key key{};
    restore(key, all[i]);
    restore(pairs[key], all[i + 1]);
  }
}
template <class T>
requires std::is_class_v<T>
void restore(T& parts, const Json& json) {
  T::members(parts, EachPart{[&](std::string_view key, auto& part) { restore(part, json.at(key)); }});
}

/// Returns the struct or list from which stored() made the JSON. JsonMisfit for any other JSON.
template <class T>
T restored(const Json& json) {
  T parts{};
  restore(parts, json);
  return parts;
}

}  // namespace nipref::verify
