#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/grade/internal/child.hpp>
#include <nipref/verify/grade/plugin.hpp>

namespace nipref::verify {

/// What went wrong in a call.
struct Trouble {
  FaultKind kind;
  std::string words;
};

std::vector<Trouble> troubles_of(const protocol::Noticed& noticed);

/// What a child says first.
struct Greeting {
  std::vector<KernelInfo> kernels;
  protocol::Noticed noticed;
};

/// BadInput if the plugin does not live to say it.
Greeting greeting_of(const Plugin& plugin, Child& child);

/// What came of a batch.
struct Outcome {
  std::vector<Trouble> troubles = {};
  bool has_values = false;
  std::vector<double> values = {}, permuted = {}, threaded = {};
};

/// std::length_error if the message is too short for `count` points.
Outcome read_outcome(protocol::Message& message, std::size_t count);

/// A request for values at points of `arity` arguments.
protocol::Message with_points(protocol::Message request, std::span<const Point> points, std::size_t arity);

}  // namespace nipref::verify
