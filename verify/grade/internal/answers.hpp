#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/grade/internal/child.hpp>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {

/// A fault of a call.
struct Trouble {
  FaultKind kind;
  std::string words;
};

std::vector<Trouble> troubles_of(const protocol::Noticed& noticed);

/// The first message of a child.
struct Greeting {
  std::vector<KernelInfo> kernels;
  protocol::Noticed noticed;
};

/// Reads the first message. BadInput if loading the plugin ended the process.
Greeting greeting_of(const Plugin& plugin, Child& child);

/// The result of a batch.
struct Outcome {
  std::vector<Trouble> troubles = {};
  bool has_values = false;
  std::vector<double> values = {}, permuted = {}, threaded = {};
};

/// Reads the result of `count` points. std::length_error if the message is too short.
Outcome read_outcome(protocol::Message& message, std::size_t count);

/// A request for values at points of `arity` arguments.
protocol::Message with_points(protocol::Message request, std::span<const Point> points, std::size_t arity);

}  // namespace nipref::verify
