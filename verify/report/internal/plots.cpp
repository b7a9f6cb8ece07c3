#include <nipref/verify/report/internal/plots.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr char place_mark = '\x01';  // in no text, see markup.cpp

}  // namespace

Markup Plots::place(std::string script, std::string instead) {
  plots_.push_back({std::move(script), std::move(instead)});
  return Markup::raw(place_mark + std::to_string(plots_.size() - 1) + place_mark);
}

std::string Plots::filled(const std::string& page, const Drawer& draw) const {
  std::vector<Markup> drawn(plots_.size());
  parallel_for(plots_.size(),
               [&](std::size_t i) {
                 const auto svg = draw(plots_[i].script);
                 drawn[i] = svg ? picture(*svg, plots_[i].instead)
                                : element("p", {{"class", "missing"}},
                                          "Not drawn: gnuplot is not installed (Debian's gnuplot-nox). " +
                                              plots_[i].instead);
               },
               {});
  std::string text;
  for (std::size_t at = 0; at < page.size();) {
    const std::size_t start = page.find(place_mark, at);
    text.append(page, at, start - at);
    if (start == std::string::npos) break;
    const std::size_t end = page.find(place_mark, start + 1);
    text += drawn.at(std::stoul(page.substr(start + 1, end - start - 1))).html();
    at = end + 1;
  }
  return text;
}

}  // namespace nipref::verify
