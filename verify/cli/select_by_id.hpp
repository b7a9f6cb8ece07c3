#pragma once
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>

namespace nipref::verify {

/// Keeps the rows whose `id` is one of the words, all of them if there are none. BadInput naming `what` for a word that
/// is no row's.
template <class Rows, class Id>
void select_by_id(Rows& rows, const std::vector<std::string>& words, std::string_view what, Id id) {
  if (words.empty()) return;
  std::vector<std::string_view> ids;
  for (const auto& row : rows) ids.push_back(row.*id);
  for (const std::string& word : words) {
    if (std::ranges::find(ids, word) == ids.end())
      throw data::BadInput(what, word,
                           data::did_you_mean(word, ids) + "must be one of those that are listed without it");
  }
  std::erase_if(rows, [&](const auto& row) { return std::ranges::find(words, row.*id) == words.end(); });
}

}  // namespace nipref::verify
