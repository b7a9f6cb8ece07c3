#include <stdexcept>

#include <nipref/verify/cli/drawing.hpp>
#include <nipref/verify/cli/output_of.hpp>

namespace nipref::verify {

std::optional<std::string> drawn_by_gnuplot(const std::string& script) {
  // Whatever the user has set up; by that name a script ends with its first error.
  const ProgramOutput drawn = output_of({"gnuplot", "-d", "/dev/stdin"}, script);
  if (drawn.status == status_not_found) return std::nullopt;
  if (drawn.status != 0) throw std::runtime_error("gnuplot does not draw: " + script.substr(0, 1000));
  return drawn.text;
}

}  // namespace nipref::verify
