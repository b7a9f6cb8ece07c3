#include <cstring>

#include <nipref/data/scene/file.hpp>
#include <nipref/fast/number/c_call.hpp>
#include <nipref/nipref.h>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/common.hpp>

using namespace nipref;
using data::BadInput;

namespace {

/// A nipref_quantity of the interface is a verify::Quantity.
const nipref_quantity* handle(const verify::Quantity* quantity) {
  return reinterpret_cast<const nipref_quantity*>(quantity);
}

const verify::Quantity* known(const nipref_quantity* quantity) {
  return reinterpret_cast<const verify::Quantity*>(quantity);
}

void refuse_null(const char* name, const void* pointer) {
  if (pointer == nullptr) throw BadInput(name, "null", "must be no null pointer");
}

const verify::Quantity& given(const nipref_quantity* quantity) {
  refuse_null("quantity", quantity);
  return *known(quantity);
}

fast::Accuracy accuracy_of(double rtol) { return rtol == 0 ? fast::Accuracy() : fast::Accuracy(rtol); }

/// Checks, like the command line, the domains of arguments that the catalogue's evaluators do not check.
void check_choices(const verify::Quantity& quantity, verify::Quantity::Columns columns) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const verify::Argument& argument = quantity.arguments[i];
    if (argument.kind != verify::ArgumentKind::choice) continue;
    const double last = static_cast<double>(argument.choices.size()) - 1;
    for (const double value : columns[i])
      if (!(value >= 0 && value <= last && value == std::floor(value)))
        verify::refuse(argument.name, value, "must be the number of a choice, 0 to {}", last);
  }
}

void check_room(const char* name, const std::string& text, std::size_t size) {
  if (text.size() >= size)
    verify::refuse(name, std::to_string(size), "must be {} or more here", text.size() + 1);
}

verify::Assignments assignments_of(const verify::Quantity& quantity, const char* const* arguments) {
  refuse_null("arguments", arguments);
  verify::Assignments assignments;
  for (std::size_t i = 0; i < quantity.arguments.size(); ++i)
    if (arguments[i] != nullptr) assignments.emplace_back(quantity.arguments[i].name, arguments[i]);
  return assignments;
}

/// The pairs of name=value texts up to a null pointer.
verify::Assignments pairs_of(const char* name, const char* const* texts) {
  verify::Assignments pairs;
  for (; *texts != nullptr; ++texts) {
    const std::string text = *texts;
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos) throw BadInput(name, text, "must be texts name=value");
    pairs.emplace_back(text.substr(0, sign), text.substr(sign + 1));
  }
  return pairs;
}

data::SceneText scene_text(const std::string& scene) {
  return scene.find('\n') != std::string::npos ? data::SceneText{"scene", scene}
                                               : data::read_scene_or_example(scene);
}

double rounded_upwards(long double error) {
  const double nearest = static_cast<double>(error);
  return static_cast<long double>(nearest) < error ? std::nextafter(nearest, INFINITY) : nearest;
}

}  // namespace

struct nipref_solution {
  struct Numbers {
    std::string_view name;
    std::vector<double> values, errors;
  };
  std::string json;
  std::vector<Numbers> numbers;

  template <class Number>
  explicit nipref_solution(const verify::SceneSolution<Number>& solved)
      : json(verify::solution_json(solved).for_machines().text()),
        numbers{{"positions", solved.positions, {}},
                {"field.positions", solved.field.positions, {}},
                {"field.depths", solved.field.depths, {}}} {
    for (const auto& result : solved.results) {
      Numbers& of_result = numbers.emplace_back(Numbers{result.what->name, {}, {}});
      for (const Number& number : result.numbers) {
        of_result.values.push_back(verify::value_of(number));
        of_result.errors.push_back(rounded_upwards(verify::error_of(number)));
      }
    }
  }
};

const char* nipref_version(void) { return NIPREF_VERSION; }

std::size_t nipref_quantity_count(void) { return verify::catalogue().size(); }

const nipref_quantity* nipref_quantity_at(std::size_t number) {
  return number < nipref_quantity_count() ? handle(&verify::catalogue()[number]) : nullptr;
}

const nipref_quantity* nipref_find(const char* name) {
  const verify::Quantity* found = nullptr;
  fast::c_call([&] {
    refuse_null("quantity", name);
    found = &verify::find_quantity(name);
  });
  return handle(found);
}

const char* nipref_name(const nipref_quantity* quantity) {
  return quantity == nullptr ? "" : known(quantity)->name.c_str();
}

const char* nipref_definition(const nipref_quantity* quantity) {
  return quantity == nullptr ? "" : known(quantity)->definition.c_str();
}

std::size_t nipref_arity(const nipref_quantity* quantity) {
  return quantity == nullptr ? 0 : known(quantity)->arguments.size();
}

const char* nipref_argument(const nipref_quantity* quantity, std::size_t number) {
  return number < nipref_arity(quantity) ? known(quantity)->arguments[number].name.c_str() : "";
}

double nipref_promise(const nipref_quantity* quantity) {
  return quantity == nullptr ? 0 : known(quantity)->promise;
}

int nipref_fast(const nipref_quantity* quantity, const double* arguments, double rtol, double* value) {
  return fast::c_call([&] {
    const verify::Quantity& wanted = given(quantity);
    refuse_null("arguments", arguments);
    refuse_null("value", value);
    const std::span<const double> point(arguments, wanted.arguments.size());
    check_choices(wanted, verify::mapped(point, [](const double& x) { return std::span(&x, 1); }));
    *value = wanted.by_fast(point, accuracy_of(rtol));
  });
}

int nipref_fast_batch(const nipref_quantity* quantity, std::size_t points, const double* const* columns,
                      double rtol, double* values) {
  return fast::c_call([&] {
    const verify::Quantity& wanted = given(quantity);
    refuse_null("columns", columns);
    refuse_null("values", values);
    std::vector<std::span<const double>> spans;
    for (std::size_t i = 0; i < wanted.arguments.size(); ++i) {
      refuse_null("columns", columns[i]);
      spans.emplace_back(columns[i], points);
    }
    check_choices(wanted, spans);
    std::vector<double> found(points);
    (wanted.by_fast_batch ? wanted.by_fast_batch : wanted.by_fast_loop)(spans, found, accuracy_of(rtol));
    if (points > 0) std::memcpy(values, found.data(), points * sizeof(double));
  });
}

int nipref_ref(const nipref_quantity* quantity, const char* const* arguments, int digits, char* value,
               std::size_t value_size, char* error, std::size_t error_size, int* proven) {
  bool met = true;
  const int status = fast::c_call([&] {
    const verify::Quantity& wanted = given(quantity);
    refuse_null("value", value);
    refuse_null("error", error);
    refuse_null("proven", proven);
    ref::check_digits(digits);
    const verify::ParsedArguments exact = verify::parse_arguments(wanted, assignments_of(wanted, arguments));
    const ref::Estimate found = wanted.by_ref(exact.exact, digits);
    const std::string value_text = found.value_text(), error_text = found.error_text();
    check_room("value_size", value_text, value_size);
    check_room("error_size", error_text, error_size);
    met = verify::is_met(wanted, exact, found, digits);
    std::memcpy(value, value_text.c_str(), value_text.size() + 1);
    std::memcpy(error, error_text.c_str(), error_text.size() + 1);
    *proven = found.proven ? 1 : 0;
  });
  return status == 0 && !met ? nipref_missed : status;
}

int nipref_parse(const nipref_quantity* quantity, const char* const* assignments, double* arguments,
                 char* texts, std::size_t texts_size) {
  return fast::c_call([&] {
    const verify::Quantity& wanted = given(quantity);
    refuse_null("assignments", assignments);
    refuse_null("arguments", arguments);
    refuse_null("texts", texts);
    const verify::ParsedArguments parsed = verify::parse_arguments(
        wanted, verify::with_material_numbers(wanted, pairs_of("assignments", assignments)));
    const verify::Point point = parsed.nearest(wanted);
    const std::string lines = fmt::format("{}\n", fmt::join(parsed.text, "\n"));
    check_room("texts_size", lines, texts_size);
    std::ranges::copy(point, arguments);
    std::memcpy(texts, lines.c_str(), lines.size() + 1);
  });
}

int nipref_solve(const char* scene, const char* const* overrides, int digits, nipref_solution** solution) {
  return fast::c_call([&] {
    refuse_null("scene", scene);
    refuse_null("solution", solution);
    const data::Scene wanted = data::load_scene(
        scene_text(scene), overrides == nullptr ? data::SceneOverrides{} : pairs_of("overrides", overrides));
    *solution = digits == 0 ? new nipref_solution(verify::solve(wanted))
                            : new nipref_solution(verify::solve_by_ref(wanted, digits));
  });
}

void nipref_solution_free(nipref_solution* solution) { delete solution; }

const char* nipref_solution_json(const nipref_solution* solution) {
  return solution == nullptr ? "" : solution->json.c_str();
}

std::size_t nipref_solution_numbers(const nipref_solution* solution, const char* result,
                                    const double** values, const double** errors) {
  nipref_solution::Numbers none;
  const nipref_solution::Numbers* found = &none;
  if (solution != nullptr && result != nullptr) {
    const auto named = std::ranges::find(solution->numbers, result, &nipref_solution::Numbers::name);
    if (named != solution->numbers.end()) found = &*named;
  }
  const auto start = [](const std::vector<double>& numbers) {
    return numbers.empty() ? nullptr : numbers.data();
  };
  if (values != nullptr) *values = start(found->values);
  if (errors != nullptr) *errors = start(found->errors);
  return found->values.size();
}
