#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <variant>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/grade/internal/answers.hpp>
#include <nipref/verify/grade/kernel.h>

namespace nipref::verify {

using data::BadInput;
using protocol::Message;
using protocol::Noticed;

std::vector<Trouble> troubles_of(const Noticed& noticed) {
  std::vector<Trouble> troubles;
  const auto add = [&](std::uint32_t bits, std::uint32_t bit, FaultKind kind, const char* words) {
    if ((bits & bit) == 0) return;
    if (troubles.empty() || troubles.back().kind != kind)
      troubles.push_back({kind, words});
    else
      troubles.back().words += std::string(" and ") + words;
  };
  add(noticed.offences, protocol::output_overrun, FaultKind::overrun,
      "touches memory before or behind its output");
  add(noticed.offences, protocol::arguments_overrun, FaultKind::overrun,
      "touches memory before or behind its arguments");
  add(noticed.offences, protocol::arguments_changed, FaultKind::arguments, "writes to its arguments");
  add(noticed.changes, protocol::rounding, FaultKind::environment, "leaves another rounding mode");
  add(noticed.changes, protocol::flush_to_zero, FaultKind::environment,
      "leaves small results flushed to zero (FTZ, as -ffast-math has it)");
  add(noticed.changes, protocol::denormals_are_zero, FaultKind::environment,
      "leaves small arguments taken for zero (DAZ, as -ffast-math has it)");
  add(noticed.changes, protocol::traps, FaultKind::environment, "leaves floating-point exceptions unmasked");
  add(noticed.changes, protocol::x87_precision, FaultKind::environment,
      "leaves another precision of the x87 unit");
  add(noticed.offences, protocol::printed, FaultKind::output, "writes to standard output");
  return troubles;
}

namespace {

Greeting read_greeting(const Plugin& plugin, Message& message) {
  const std::string failure = message.take_text();
  if (!failure.empty()) throw BadInput("plugin", plugin.file.string(), failure);
  Greeting greeting;
  greeting.noticed = message.take<Noticed>();
  const auto count = message.take<std::size_t>();
  for (std::size_t i = 0; i < count; ++i) {
    KernelInfo info;
    info.name = message.take_text();
    info.quantity = message.take_text();
    info.arity = message.take<std::uint32_t>();
    info.thread_safe = (message.take<std::uint32_t>() & nipref_kernel_thread_safe) != 0;
    greeting.kernels.push_back(std::move(info));
  }
  const bool is_the_hosts = count > 0 && std::ranges::all_of(greeting.kernels, [](const KernelInfo& kernel) {
                              return kernel.arity > 0 && kernel.arity <= protocol::most_arguments;
                            });
  if (!is_the_hosts) throw std::length_error("a greeting of no kernels, or of no kernel's arity");
  return greeting;
}

}  // namespace

Greeting greeting_of(const Plugin& plugin, Child& child) {
  Child::Answer answer = child.greeting();
  if (const Death* const death = std::get_if<Death>(&answer))
    throw BadInput("plugin", plugin.file.string(),
                   fmt::format("must be loaded without harm: {}, {}", name_of(death->kind), death->words));
  try {
    return read_greeting(plugin, std::get<Message>(answer));
  } catch (const std::length_error&) {
    throw BadInput("plugin", plugin.file.string(), "must not write to a descriptor that is not its own");
  }
}

Message with_points(Message request, std::span<const Point> points, std::size_t arity) {
  request.put(points.size());
  std::vector<double> column(points.size());
  for (std::size_t j = 0; j < arity; ++j) {
    std::ranges::transform(points, column.begin(), [j](const Point& point) { return point[j]; });
    request.put_column(column);
  }
  return request;
}

Outcome read_outcome(Message& message, std::size_t count) {
  Outcome outcome{.troubles = troubles_of(message.take<Noticed>())};
  const int status = message.take<int>();
  if (status != 0) outcome.troubles.push_back({FaultKind::refused, fmt::format("returns {}", status)});
  outcome.has_values = status == 0;
  for (std::vector<double>* const column : {&outcome.values, &outcome.permuted, &outcome.threaded}) {
    column->resize(count);
    message.take_column(*column);
  }
  return outcome;
}

}  // namespace nipref::verify
