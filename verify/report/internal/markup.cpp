#include <fmt/format.h>

#include <cctype>

#include <nipref/verify/report/internal/markup.hpp>

namespace nipref::verify {
namespace {

/// Of text, or of an attribute in double quotes. Control characters, which XML does not have, become spaces.
std::string escaped_text(std::string_view text) {
  std::string html;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += static_cast<unsigned char>(letter) < ' ' && letter != '\n' ? ' ' : letter;
    }
  }
  return html;
}

std::string opening(std::string_view name, const Attributes& attributes) {
  std::string html = "<" + std::string(name);
  for (const auto& [key, value] : attributes)
    html += " " + std::string(key) + "=\"" + escaped_text(value) + "\"";
  return html;
}

/// Line breaks, of which gnuplot writes many, as single spaces.
std::string in_one_line(const std::string& svg) {
  std::string line;
  for (const char letter : svg) {
    const bool space = letter == '\n' || letter == '\t' || letter == ' ';
    if (!space) line += letter;
    if (space && !line.empty() && line.back() != ' ') line += ' ';
  }
  return line;
}

/// A text in a data URL in double quotes. Shorter than base64 where most of it is plain.
std::string percent_encoded(const std::string& text) {
  constexpr std::string_view plain = " !'()*+,-./:;=?@_|$[]";
  std::string url;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if ((std::isalnum(byte) != 0 && byte < 128) || plain.find(letter) != std::string_view::npos) {
      url += letter;
    } else {
      url += fmt::format("%{:02X}", byte);
    }
  }
  return url;
}

}  // namespace

Markup::Markup(std::string_view text) : html_(escaped_text(text)) {}

Markup Markup::raw(std::string html) {
  Markup markup;
  markup.html_ = std::move(html);
  return markup;
}

Markup& Markup::operator+=(const Markup& more) {
  html_ += more.html_;
  return *this;
}

Markup element(std::string_view name, const Attributes& attributes, const Markup& content) {
  // Not after words of a sentence.
  const bool ends_line = name == "tr" || name == "li" || name == "p" || name == "div" || name == "section";
  return Markup::raw(opening(name, attributes) + ">" + content.html() + "</" + std::string(name) +
                     (ends_line ? ">\n" : ">"));
}

Markup empty_element(std::string_view name, const Attributes& attributes) {
  return Markup::raw(opening(name, attributes) + "/>");
}

Markup link_to(std::string_view id, const Markup& content) {
  return Markup::raw(opening("a", {{"href", "#" + std::string(id)}}) + ">" + content.html() + "</a>");
}

Markup details(const Markup& summary, const Markup& content, const Attributes& attributes) {
  return element("details", attributes, element("summary", summary) + content);
}

TableCellMarkup number_cell(const Markup& content) { return {content, true}; }

TableMarkup::TableMarkup(std::string caption, const std::vector<std::string>& headings)
    : caption_(std::move(caption)) {
  for (const std::string& heading : headings) {
    const bool number = heading.starts_with('#');
    Attributes attributes{{"scope", "col"}};
    if (number) attributes.emplace_back("class", "n");
    head_ += element("th", attributes, heading.substr(number ? 1 : 0));
  }
}

void TableMarkup::row(const std::vector<TableCellMarkup>& cells, const std::string& id) {
  Markup row;
  for (const TableCellMarkup& cell : cells) {
    const bool heading = &cell == &cells.front();
    std::string style = cell.number ? "n" : "";
    if (!cell.style.empty()) style += (style.empty() ? "" : " ") + cell.style;
    Attributes attributes;
    if (heading) attributes.emplace_back("scope", "row");
    if (!style.empty()) attributes.emplace_back("class", style);
    row += element(heading ? "th" : "td", attributes, cell.content);
  }
  rows_ += element("tr", id.empty() ? Attributes{} : Attributes{{"id", id}}, row);
}

Markup TableMarkup::markup() const {
  return element("div",
                 {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", caption_}},
                 element("table", element("caption", caption_) + element("thead", element("tr", head_)) +
                                      element("tbody", rows_)));
}

Markup picture(const std::string& svg, const std::string& instead) {
  return empty_element(
      "img", {{"src", "data:image/svg+xml," + percent_encoded(in_one_line(svg))}, {"alt", instead}});
}

}  // namespace nipref::verify
