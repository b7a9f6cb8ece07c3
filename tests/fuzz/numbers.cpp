#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ranges.hpp>
#include <nipref/verify/cli/run_folder.hpp>

#include "reading.hpp"

using namespace nipref;

/// What stands behind a name and '=' on a command line.
void read_given(const std::string& text, const GivenFile&) {
  constexpr double a_third = 1.0 / 3;
  take_or_refuse([&] { static_cast<void>(verify::parse_range("alpha", text).at(a_third)); });
  take_or_refuse([&] { static_cast<void>(verify::axis_of("alpha", text, 5)); });
  take_or_refuse([&] { static_cast<void>(verify::parse_integer("digits", text)); });
  take_or_refuse([&] { static_cast<void>(verify::parse_real("rtol", text)); });
  take_or_refuse([&] { static_cast<void>(verify::parse_shard(text)); });
  take_or_refuse([&] {
    const verify::Quantity& quantity = verify::find_quantity("I6");
    const verify::ParsedArguments arguments =
        verify::parse_arguments(quantity, {{"alpha", text}, {"eta", text}});
    static_cast<void>(arguments.exact.front().text());
    static_cast<void>(arguments.exact.front().log2_magnitude());
    static_cast<void>(arguments.nearest(quantity));
  });
}
