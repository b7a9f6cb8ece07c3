#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/support/internal/template.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

namespace mustache = kainjow::mustache;

std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::nullopt : std::optional(number);
}

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

std::string with_decimal_numbers(const std::string& text) {
  std::string decimal;
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    if (at[0] == '0' && at[1] == 'x') {
      decimal += fmt::format("{:.6g}", std::strtod(at, &end));
      at = end;
    } else {
      decimal += *at++;
    }
  }
  return decimal;
}

std::string word_of_shell(const std::string& text) {
  return text.find_first_of(" ()[]*?$\"") == std::string::npos ? text : "'" + text + "'";
}

using Format = std::function<std::string(const std::string&)>;

Format of_number(std::function<std::string(double)> format) {
  return [=](const std::string& text) {
    const auto number = number_in(text);
    return number ? format(*number) : "-";
  };
}

Format by_pattern(const char* pattern, double factor = 1) {
  return of_number([=](double number) { return fmt::format(fmt::runtime(pattern), factor * number); });
}

void add_formats(mustache::data& data) {
  const std::pair<const char*, Format> formats[]{{"g", by_pattern("{:g}")},
                                                 {"g2", by_pattern("{:.2g}")},
                                                 {"g3", by_pattern("{:.3g}")},
                                                 {"g4", by_pattern("{:.4g}")},
                                                 {"e1", by_pattern("{:.1e}")},
                                                 {"percent", by_pattern("{:.0f} %", 100)},
                                                 {"percent2", by_pattern("{:.2g} %", 100)},
                                                 {"signed", by_pattern("{:+.2g} %", 100)},
                                                 {"two_digits", of_number(two_digits)},
                                                 {"off", of_number(off_text)},
                                                 {"decimal", with_decimal_numbers},
                                                 {"shell", word_of_shell},
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
  switch (value.type()) {
    case TemplateData::value_t::object:
      return object_data(value);
    case TemplateData::value_t::array: {
      mustache::data list(mustache::data::type::list);
      for (const TemplateData& item : value) list << data_of(item);
      return list;
    }
    case TemplateData::value_t::string:
      return value.get<std::string>();
    case TemplateData::value_t::boolean:
      return value.get<bool>();
    case TemplateData::value_t::number_float:
      return fmt::format("{}", value.get<double>());
    default:
      return value.is_null() ? mustache::data(false) : mustache::data(value.dump());
  }
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
  mustache::mustache page(text);
  page.set_custom_escape(escape);
  mustache::data filling = data_of(data);
  add_formats(filling);
  std::string result = page.render(filling);
  if (!page.is_valid()) throw std::runtime_error("template: " + page.error_message());
  return result;
}

}  // namespace nipref::verify
