#include <cctype>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/support/formula.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/internal/template.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

namespace mustache = kainjow::mustache;

std::string two_digits(double number) {
  if (!(number >= 10 && number < 1e6)) return fmt::format("{:.2g}", number);
  const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
  return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

std::string off_text(double relative) {
  const double percent = std::fabs(100 * relative);
  return fmt::format("{} % {}", percent < 1 ? fmt::format("{:.1g}", percent) : fmt::format("{:.0f}", percent),
                     relative < 0 ? "low" : "high");
}

/// Replaces each hexadecimal number of the text by written(number, its text).
template <class Write>
std::string with_decimals(const std::string& text, Write written) {
  std::string decimal;
  for (const char* at = text.c_str(); *at != '\0';) {
    const bool signed_hex = at[0] == '-' && at[1] == '0' && at[2] == 'x';
    if (signed_hex || (at[0] == '0' && at[1] == 'x')) {
      char* end = nullptr;
      const double number = std::strtod(at, &end);
      decimal += written(number, std::string_view(at, end));
      at = end;
    } else {
      decimal += *at++;
    }
  }
  return decimal;
}

std::string decimal_text(const std::string& text) {
  return with_decimals(text, [](double number, std::string_view) { return fmt::format("{:.6g}", number); });
}

std::string exact_text(const std::string& text) {
  return with_decimals(text, [](double number, std::string_view hexadecimal) {
    return fmt::format("{:.6g} ({})", number, hexadecimal);
  });
}

std::string word_of_shell(const std::string& text) {
  return text.find_first_of(" ()[]*?$\"") == std::string::npos ? text : "'" + text + "'";
}

/// Formats the text of "SPECIFICATION TEXT", as a number if the specification ends with a letter or %.
std::string formatted(const std::string& text) {
  const std::size_t space = text.find(' ');
  std::string specification = text.substr(0, space);
  const std::string value = text.substr(std::min(space, text.size() - 1) + 1);
  if (std::isdigit(static_cast<unsigned char>(specification.back())) != 0)
    return fmt::format(fmt::runtime("{:" + specification + "}"), value);
  const double factor = specification.back() == '%' ? 100 : 1;
  if (factor != 1) specification.pop_back();
  const auto number = number_in(value);
  return number ? fmt::format(fmt::runtime("{:" + specification + "}"), factor * *number) : "-";
}

std::string without_end(std::string text) {
  text.erase(text.find_last_not_of(",; \n") + 1);
  return text;
}

// Mustache removes the line of a section's tag that stands alone, but the library leaves an empty line if the section is
// left out. Such lines are therefore joined here. The library sees this character in place of other line breaks.
constexpr char line_break = '\x1e';
/// Replaces a bar in a value, so that it does not separate the cells of a table.
constexpr char bar_of_value = '\x1f';

bool is_lone_tag(std::string_view line) {
  constexpr std::string_view kinds = "#^/!>";
  return line.starts_with("{{") && line.find("}}") + 2 == line.size() && kinds.find(line[2]) != kinds.npos;
}

std::string with_joined_lines(const std::string& text) {
  std::string joined;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
    const bool lone = is_lone_tag(line.substr(start));
    joined += lone ? line.substr(start) : line;
    if (!lone && end < text.size()) joined += line_break;
    at = end + 1;
  }
  return joined;
}

/// The text of a partial. If it is one line, it has no line break, because it may stand in the middle of a line.
std::string inlined(const std::string& partial) {
  std::string text = with_joined_lines(partial);
  if (text.find(line_break) + 1 == text.size()) text.pop_back();
  return text;
}

std::string restored(std::string text) {
  std::ranges::replace(text, line_break, '\n');
  std::ranges::replace(text, bar_of_value, '|');
  return text;
}

/// The text as a table.
std::string laid_out(const std::string& text) {
  std::vector<std::string> lines = parts_of(text, std::string_view(&line_break, 1));
  std::erase(lines, "");
  return table_text(lines);
}

using Format = std::function<std::string(const std::string&)>;

Format of_number(std::function<std::string(double)> format) {
  return [=](const std::string& text) {
    const auto number = number_in(text);
    return number ? format(*number) : "-";
  };
}

void add_formats(mustache::data& data) {
  const std::pair<const char*, Format> formats[]{{"as", formatted},
                                                 {"two_digits", of_number(two_digits)},
                                                 {"off", of_number(off_text)},
                                                 {"upward", of_number(upward_text)},
                                                 {"decimal", decimal_text},
                                                 {"exact", exact_text},
                                                 {"shell", word_of_shell},
                                                 {"mathml", with_mathml},
                                                 {"trimmed", without_end},
                                                 {"table", laid_out},
                                                 {"good", good},
                                                 {"bad", bad}};
  for (const auto& [name, format] : formats)
    data.set(name, mustache::lambda2([format = format](const std::string& text, const auto& render) {
               return format(render(text));
             }));
}

mustache::data data_of(const TemplateData& value);

mustache::data object_data(const TemplateData& value) {
  mustache::data object, each(mustache::data::type::list);
  const auto objects =
      std::ranges::count_if(value, [](const TemplateData& one) { return one.is_structured(); });
  const bool alike = objects == 0 || objects == static_cast<std::ptrdiff_t>(value.size());
  for (const auto& [key, member] : value.items()) {
    const mustache::data converted = data_of(member);
    object.set(key, converted);
    if (!alike) continue;
    mustache::data pair("key", key);
    pair.set("value", converted);
    each << pair;
  }
  if (alike) object.set("each", each);
  return object;
}

mustache::data data_of(const TemplateData& value) {
  if (value.is_object()) return object_data(value);
  if (value.is_string()) return value.get<std::string>();
  if (value.is_null() || value.is_boolean()) return value == true;
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_array()) return value.dump();
  mustache::data list(mustache::data::type::list);
  for (const TemplateData& item : value) list << data_of(item);
  return list;
}

/// A context that remembers the name that the data does not have.
class Context : public mustache::context<std::string> {
 public:
  using mustache::context<std::string>::context;
  const mustache::data* get(const std::string& name) const override {
    const mustache::data* found = mustache::context<std::string>::get(name);
    if (found == nullptr) missing_ = name;
    return found;
  }
  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  mutable std::string missing_;
};

std::string filled(const std::string& text, const TemplateData& data, const Escape& escape,
                   const Partials& partials, bool may_lack_names) {
  mustache::mustache page(with_joined_lines(text));
  page.set_custom_escape(escape);
  mustache::data filling = data_of(data);
  add_formats(filling);
  for (const auto& [name, partial] : partials)
    filling.set(name, mustache::partial([&text = partial] { return inlined(text); }));
  Context context(&filling);
  std::string result = page.render(context);
  if (!page.is_valid()) throw std::runtime_error("template: " + page.error_message());
  if (!may_lack_names && !context.missing().empty())
    throw std::runtime_error("template: there is no " + context.missing());
  return restored(std::move(result));
}

}  // namespace

std::string escaped_for_html(std::string text) {
  const auto is_control = [](char letter) {
    return static_cast<unsigned char>(letter) < ' ' && letter != '\n';
  };
  std::ranges::replace_if(text, is_control, ' ');
  return mustache::html_escape(text);
}

std::string template_text(const std::string& name) {
  return data::text_of_input_file(data::templates_directory() / name, "template");
}

std::string filled(const std::string& text, const TemplateData& data, const Escape& escape) {
  return filled(text, data, escape, {}, true);
}

std::string filled_text(const std::string& text, const TemplateData& data, const Partials& partials,
                        const Escape& escape) {
  const auto without_bars = [&](const std::string& value) {
    std::string escaped = escape(value);
    std::ranges::replace(escaped, '|', bar_of_value);
    return escaped;
  };
  return filled(text, data, without_bars, partials, false);
}

}  // namespace nipref::verify
