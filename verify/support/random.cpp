#include <cmath>

#include <nipref/verify/support/random.hpp>

namespace nipref::verify {
namespace {

/// FNV-1a, because std::hash may differ between libraries.
std::uint64_t hash(std::string_view text) {
  std::uint64_t state = 0xcbf29ce484222325U;
  for (const char letter : text) state = (state ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  return state;
}

}  // namespace

Random::Random(std::string_view seed) : engine_(hash(seed)) {}

double Random::uniform() { return std::ldexp(static_cast<double>(engine_() >> 11U), -53); }

double Random::uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }

double Random::log_uniform(double lower, double upper) {
  return std::exp(uniform(std::log(lower), std::log(upper)));
}

bool Random::chance(double probability) { return uniform() < probability; }

std::size_t Random::index(std::size_t count) {
  return static_cast<std::size_t>(uniform() * static_cast<double>(count));
}

}  // namespace nipref::verify
