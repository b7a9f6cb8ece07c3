#include <array>

#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

const SymbolBounds& bounds(Symbol symbol) {
  static constexpr std::array<SymbolBounds, 7> all{{
      {"I1", false, 0, 1.5, 1.5, -0.25, 7, 0},
      {"I3", true, 1, 2, 4.25, 0, 4, 8},
      {"I4", true, 1, 1, 2.5, 0, 3, 6},
      {"I5", true, 1, 1, 2.5, 0, 5, 12},
      {"I6_alpha_part", false, 2, 2, 2.75, -1.0 / 6, 2, 0},
      {"I6_eta_part", false, 2, 1, 1.75, 1.0 / 12, 2, 0},
      {"I7", false, 0, 1, 2.25, 0.5, 6, 0},
  }};
  return all[static_cast<std::size_t>(symbol)];
}

}  // namespace nipref::ref
