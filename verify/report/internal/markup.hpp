#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nipref::verify {

// HTML that is well-formed XML too. Text becomes markup by being escaped, and in no other way.

/// A piece of a page. What is inside is complete elements and text.
class Markup {
 public:
  Markup() = default;
  /// Text, escaped.
  Markup(std::string_view text);
  Markup(const std::string& text) : Markup(std::string_view(text)) {}
  Markup(const char* text) : Markup(std::string_view(text)) {}

  /// What is markup already.
  static Markup raw(std::string html);

  Markup& operator+=(const Markup& more);
  friend Markup operator+(Markup a, const Markup& b) { return a += b; }

  [[nodiscard]] const std::string& html() const { return html_; }

 private:
  std::string html_;
};

/// Names and texts of attributes.
using Attributes = std::vector<std::pair<std::string_view, std::string>>;

Markup element(std::string_view name, const Attributes& attributes, const Markup& content);
inline Markup element(std::string_view name, const Markup& content) { return element(name, {}, content); }
/// One that has no content: img, meta.
Markup empty_element(std::string_view name, const Attributes& attributes);

/// A link within the page.
Markup link_to(std::string_view id, const Markup& content);

/// What opens when it is asked for.
Markup details(const Markup& summary, const Markup& content, const Attributes& attributes = {});

/// A cell of a table.
struct TableCellMarkup {
  Markup content;
  bool number = false;     ///< set to the right
  std::string style = {};  ///< a class of the style sheet
};
TableCellMarkup number_cell(const Markup& content);

/// A table that scrolls in a box of its own; the first cell of a row is its heading.
class TableMarkup {
 public:
  /// Each heading; those that begin with '#' are of numbers.
  TableMarkup(std::string caption, const std::vector<std::string>& headings);
  /// `id`: what links lead to; may be empty.
  void row(const std::vector<TableCellMarkup>& cells, const std::string& id = "");
  [[nodiscard]] Markup markup() const;

 private:
  std::string caption_;
  Markup head_, rows_;
};

/// An SVG drawing as a picture, and what stands for it where it cannot be seen.
Markup picture(const std::string& svg, const std::string& instead);

}  // namespace nipref::verify
