#include <string>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/internal/argument_checks.hpp>

namespace nipref::fast::internal {

void refuse_argument(std::string_view name, double value) {
  if (std::isfinite(value))
    throw data::BadInput(name, value, "must be nonzero: the kernel is infinite there");
  throw data::BadInput(name, value, "must be a finite number");
}

void check_arguments(std::string_view name, std::span<const double> arguments, std::size_t value_count,
                     Domain domain) {
  if (value_count != arguments.size()) {
    throw data::BadInput("value.size()", std::to_string(value_count),
                         "must equal " + std::string(name) + ".size() = " + std::to_string(arguments.size()));
  }
  if (sheet_code().all_in_domain(arguments.data(), arguments.size(), domain)) return;
  std::size_t first = 0;
  while (in_domain(arguments[first], domain)) ++first;
  refuse_argument(std::string(name) + "[" + std::to_string(first) + "]", arguments[first]);
}

}  // namespace nipref::fast::internal
