#include <nipref/data/bad_input.hpp>
#include <nipref/data/internal/common.hpp>

namespace nipref::data {
namespace {

/// Returns the text with a blank in place of each control character.
std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char letter) { return letter < ' '; }, ' ');
  return text;
}

}  // namespace

BadInput::BadInput(std::string_view argument, std::string_view value, std::string_view allowed)
    : std::invalid_argument(in_one_line(fmt::format("{} = {}: {}", argument, value, allowed))),
      argument_(argument),
      value_(value),
      allowed_(allowed) {}

BadInput::BadInput(std::string_view argument, double value, std::string_view allowed)
    : BadInput(argument, fmt::format("{}", value), allowed) {}

}  // namespace nipref::data
