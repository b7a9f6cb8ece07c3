#pragma once
#include <string>
#include <vector>

#include <nipref/verify/report/internal/markup.hpp>
#include <nipref/verify/report/page.hpp>

namespace nipref::verify {

/// The plots of a page: sections keep places for them, then all are drawn at once.
class Plots {
 public:
  /// The place of a plot; `instead` tells it to who does not see it.
  Markup place(std::string script, std::string instead);

  /// The page with what was drawn in all places.
  [[nodiscard]] std::string filled(const std::string& page, const Drawer& draw) const;

 private:
  struct Plot {
    std::string script, instead;
  };
  std::vector<Plot> plots_;
};

}  // namespace nipref::verify
