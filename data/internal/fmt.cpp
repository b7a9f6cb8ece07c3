// fmt's own code, compiled once into this library: who links it needs no libfmt, and fmt as a header in every source
// that formats would cost seconds each. Not inlined, so that they find all of it here.
#define FMT_HEADER_ONLY
#include <fmt/format.h>

namespace {

[[gnu::used]] constexpr std::string (*whole)(fmt::string_view, fmt::format_args) = fmt::vformat;

}  // namespace
