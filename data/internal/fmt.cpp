// The code of fmt, compiled once into this library. Programs that link it need no libfmt, and sources that format save
// the seconds of compiling fmt. The build inlines nothing here, so that they find every function.
#define FMT_HEADER_ONLY
#include <fmt/format.h>

namespace {

[[gnu::used]] constexpr std::string (*whole)(fmt::string_view, fmt::format_args) = fmt::vformat;

}  // namespace
