#pragma once
#include <functional>
#include <map>
#include <string>

#include <nipref/verify/seeds/limits.hpp>

namespace nipref::verify {

/// The contact and the closed form at one size, by the name of the limit in data/statements/limits.csv.
using LimitSamples = std::map<std::string, std::function<LimitSample(double size)>>;

/// A limit by the solver's number at a size and the closed form there.
auto limit(const auto& found, const auto& closed_form) {
  return [=](double size) { return LimitSample{size, found(size), closed_form(Propagated::exact(size))}; };
}

LimitSamples elastic_limits();
LimitSamples rolling_limits();

}  // namespace nipref::verify
