#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/internal/template.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

using Keys = std::vector<const char*>;

TemplateData* row_like(TemplateData& rows, const TemplateData& row, const Keys& keys) {
  const auto found = std::ranges::find_if(rows, [&](const TemplateData& one) {
    return std::ranges::all_of(keys, [&](const char* key) { return one.at(key) == row.at(key); });
  });
  return found == rows.end() ? nullptr : &*found;
}

/// Adds to each row the members of that row of `more` which has the same keys.
void join(TemplateData& rows, TemplateData& more, const Keys& keys) {
  for (TemplateData& row : rows) {
    if (const TemplateData* const other = row_like(more, row, keys)) row.update(*other);
  }
}

/// Groups rows with the same keys: a group has these keys, and its rows as `rows`.
TemplateData grouped(const TemplateData& rows, const Keys& keys) {
  TemplateData groups = TemplateData::array();
  for (const TemplateData& row : rows) {
    TemplateData* group = row_like(groups, row, keys);
    if (group == nullptr) {
      TemplateData empty{{"rows", TemplateData::array()}};
      for (const char* key : keys) empty[key] = row[key];
      group = &groups.emplace_back(std::move(empty));
    }
    (*group)["rows"].push_back(row);
  }
  return groups;
}

/// Percent-encoded by RFC 3986; runs of white space, of which gnuplot writes many, become single spaces.
std::string percent_encoded(const std::string& svg) {
  constexpr std::string_view plain = "!'()*+,-./:;=?@_|$[]";
  std::string url;
  for (const char letter : svg) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isspace(byte) != 0) {
      if (!url.empty() && url.back() != ' ') url += ' ';
    } else if ((std::isalnum(byte) != 0 && byte < 128) || plain.find(letter) != std::string_view::npos) {
      url += letter;
    } else {
      url += fmt::format("%{:02X}", byte);
    }
  }
  return url;
}

/// Replaces the plots in the rows by pictures, drawn in several threads.
void draw_all(TemplateData& rows, const Drawer& draw) {
  std::vector<TemplateData*> plotted;
  for (TemplateData& row : rows) {
    if (row.contains("plot") && !row["plot"].is_null()) plotted.push_back(&row);
  }
  parallel_for(plotted.size(),
               [&](std::size_t i) {
                 TemplateData& row = *plotted[i];
                 const auto svg = draw(gnuplot_script(Json::parse(row["plot"].dump())));
                 row["picture"] = svg ? TemplateData(percent_encoded(*svg)) : TemplateData();
                 row.erase("plot");
               },
               {});
}

/// The answer, rearranged for the page's template.
TemplateData arranged(const std::string& answer, const Drawer& draw) {
  TemplateData page = TemplateData::parse(answer);
  TemplateData& rows = page["audit"]["rows"];
  join(rows, page["quantities"], {"quantity"});
  join(page["golden"], page["golden_values"], {"quantity"});
  join(page["tables"]["tables"], page["summary"]["tables"], {"id"});
  // No reference to a member of the page is held over the insertion of another, which moves the members.
  page["ways"] = grouped(page["bench"]["rows"], {"quantity", "range"});
  if (page.contains("times")) join(page["ways"], page["times"]["plots"], {"quantity", "range"});
  for (TemplateData& figure : page["figures"])
    figure = {{"id", figure["id"]},
              {"title", figure["title"]},
              {"parameters", figure["parameters"]},
              {"plot", figure}};
  for (TemplateData& table : page["tables"]["tables"]) {
    for (TemplateData& cell : table["cells"]) cell["judged"] = cell["verdict"] != "input";
    table["rows"] = grouped(table["cells"], {"row"});
    table["columns"] = table["rows"].empty() ? TemplateData() : table["rows"].front()["rows"];
  }
  for (const char* list : {"ways", "figures"}) draw_all(page[list], draw);
  draw_all(rows, draw);
  TemplateData drawn = TemplateData::array();
  std::ranges::copy_if(rows, std::back_inserter(drawn),
                       [](const TemplateData& row) { return row.contains("picture"); });
  page["subjects"] = grouped(drawn, {"subject"});
  for (TemplateData& subject : page["subjects"]) subject["count"] = subject["rows"].size();
  for (TemplateData& row : rows) row.erase("picture");
  for (TemplateData& one : page["ways"]) one["drawn"] = one.contains("picture");
  for (const char* list : {"subjects", "ways"}) {
    if (!page[list].empty()) page[list].front()["first"] = true;
  }
  return page;
}

}  // namespace

std::string report_page(const std::string& answer, const Drawer& draw) {
  return filled(template_text("report.html"), arranged(answer, draw), escaped_for_html);
}

std::string report_text(const std::string& answer, const std::string& where_more_is) {
  TemplateData data = TemplateData::parse(answer);
  data["page"] = where_more_is;
  return folded(filled(template_text("report.txt"), data, [](const std::string& text) { return text; }));
}

}  // namespace nipref::verify
