#pragma once
#include <algorithm>
#include <functional>
#include <iterator>
#include <ranges>
#include <type_traits>
#include <vector>

namespace nipref::verify {

/// Applies `function`, which may be a pointer to a member, to all items of a range and returns the results in order,
/// converted to `Result` if this type is given.
template <class Result = void, class Items, class Function>
auto mapped(Items&& items, const Function& function) {
  using Found = std::invoke_result_t<const Function&, std::ranges::range_reference_t<Items>>;
  std::vector<std::conditional_t<std::is_void_v<Result>, std::remove_cvref_t<Found>, Result>> results;
  for (auto&& item : items) results.push_back(std::invoke(function, item));
  return results;
}

/// The items in their order, without repetitions.
template <class Item>
std::vector<Item> each_once(const std::vector<Item>& items) {
  std::vector<Item> kept;
  std::ranges::copy_if(items, std::back_inserter(kept),
                       [&](const Item& item) { return std::ranges::find(kept, item) == kept.end(); });
  return kept;
}

/// The first item of a range whose `member` is `value`; null if there is none.
template <class Items>
auto* item_with(Items&& items, const auto& member, const auto& value) {
  const auto found = std::ranges::find(items, value, member);
  return found == std::ranges::end(items) ? nullptr : &*found;
}

}  // namespace nipref::verify
