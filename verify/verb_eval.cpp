#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "data/bad_input.hpp"
#include "verify/catalogue.hpp"
#include "verify/stopwatch.hpp"
#include "verify/ulp.hpp"
#include "verify/verb_options.hpp"
#include "verify/verbs.hpp"

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr long default_digits = 50;

/// One path's answer, as it is printed.
struct Answer {
  std::string path;
  std::string value;
  std::string error_bound;
  int digits;  ///< ref: as asked for; fast: as promised
  double seconds;
};

/// What was asked for, checked as far as it can be without evaluating anything.
struct Request {
  const Quantity* quantity;
  ParsedArguments arguments;
  bool by_ref;
  bool by_fast;
  int digits;
  fast::Accuracy accuracy;
};

const Quantity& quantity_of(const CommandLine& line) {
  if (line.words.size() > 1) {
    throw BadInput("argument", line.words[1], "unexpected: eval takes one quantity and name=value pairs");
  }
  return find_quantity(line.words.empty() ? "(missing)" : line.words.front());
}

std::string path_of(const CommandLine& line) {
  const std::string path = line.option("path").value_or("both");
  if (path != "ref" && path != "fast" && path != "both")
    throw BadInput("path", path, "must be ref, fast or both");
  return path;
}

int digits_of(const CommandLine& line) {
  const auto text = line.option("digits");
  const long digits = text ? parse_integer("digits", *text) : default_digits;
  ref::check_digits(static_cast<int>(std::clamp(digits, -1L, 1'000'000'000L)));
  return static_cast<int>(digits);
}

Request request_of(const CommandLine& line) {
  const Quantity& quantity = quantity_of(line);
  const std::string path = path_of(line);
  return {&quantity,       parse_arguments(quantity, line.assignments),
          path != "fast",  path != "ref",
          digits_of(line), accuracy_option(line)};
}

Answer answer_of_ref(const Request& request) {
  std::optional<ref::Enclosure> found;
  const double seconds =
      seconds_of([&] { found = request.quantity->by_ref(request.arguments.exact, request.digits); });
  return {"ref", found->value_text(), found->bound_text(), request.digits, seconds};
}

Answer answer_of_fast(const Request& request) {
  const Quantity& quantity = *request.quantity;
  const Point point = request.arguments.nearest(quantity);
  double value = 0;
  const double seconds = seconds_of([&] { value = quantity.by_fast(point, request.accuracy); });
  const double scale = std::max(std::fabs(value), quantity.envelope(point));
  const double rtol = request.accuracy.rtol();
  const double tolerated = rtol > fast::Accuracy::kBest ? rtol * scale : 0;
  const double bound = std::max(quantity.promise * ulp_of(scale), tolerated);
  return {"fast", fmt::format("{}", value), fmt::format("{:.1e}", bound), static_cast<int>(-std::log10(rtol)),
          seconds};
}

std::vector<Answer> answers_to(const Request& request) {
  std::vector<Answer> answers;
  if (request.by_ref) answers.push_back(answer_of_ref(request));
  if (request.by_fast) answers.push_back(answer_of_fast(request));
  return answers;
}

nlohmann::ordered_json to_json(const Request& request, const std::vector<Answer>& answers) {
  nlohmann::ordered_json json{{"quantity", request.quantity->name}};
  json["arguments"] = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < request.arguments.text.size(); ++i) {
    json["arguments"][request.quantity->arguments[i].name] = request.arguments.text[i];
  }
  json["results"] = nlohmann::ordered_json::array();
  for (const Answer& answer : answers) {
    json["results"].push_back({{"path", answer.path},
                               {"value", answer.value},
                               {"error_bound", answer.error_bound},
                               {"digits", answer.digits},
                               {"seconds", answer.seconds}});
  }
  return json;
}

void print_text(const Request& request, const std::vector<Answer>& answers, std::ostream& out) {
  fmt::print(out, "{} = {}\n", request.quantity->name, request.quantity->definition);
  for (std::size_t i = 0; i < request.arguments.text.size(); ++i) {
    fmt::print(out, "  {} = {}\n", request.quantity->arguments[i].name, request.arguments.text[i]);
  }
  for (const Answer& answer : answers) {
    fmt::print(out, "{:4} ({} digits, {:.2g} s)\n  value        {}\n  error bound  {}\n", answer.path,
               answer.digits, answer.seconds, answer.value, answer.error_bound);
  }
  if (request.by_fast)
    fmt::print(out,
               "fast takes each argument rounded to the nearest double; its bound is for that argument.\n");
}

}  // namespace

int eval_verb(const CommandLine& line, std::ostream& out) {
  const Request request = request_of(line);
  const std::vector<Answer> answers = answers_to(request);
  if (line.json) {
    fmt::print(out, "{}\n", to_json(request, answers).dump(2));
  } else {
    print_text(request, answers, out);
  }
  return 0;
}

}  // namespace nipref::verify
