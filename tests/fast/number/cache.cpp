#include <doctest/doctest.h>

#include <nipref/fast/number/caches.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/viscoelastic_nip/internal/basis.hpp>

using namespace nipref::fast;

namespace {

int made = 0;

int square(const int& key) {
  ++made;
  return key * key;
}

}  // namespace

TEST_CASE("fast's memo computes a value once, and again after clear() and after too many others") {
  Cache<int, int> memo(square, 2);
  made = 0;
  CHECK(*memo.at(3) == 9);
  CHECK(*memo.at(3) == 9);
  CHECK(made == 1);
  memo.clear();
  CHECK(*memo.at(3) == 9);
  CHECK(made == 2);
  memo.at(4);
  memo.at(5);
  memo.at(3);
  CHECK(made == 5);
}

TEST_CASE("clear_caches() empties fast's caches, and what is computed after it is the same") {
  const auto before = viscoelastic_basis(7, true);
  CHECK(viscoelastic_basis(7, true) == before);
  clear_caches();
  const auto after = viscoelastic_basis(7, true);
  CHECK(after != before);
  CHECK(after->xi == before->xi);
  CHECK(after->slope == before->slope);
  CHECK(after->chebyshev == before->chebyshev);
  CHECK(after->pressure == before->pressure);
  CHECK(after->integral == before->integral);
  CHECK(after->moment == before->moment);
}
