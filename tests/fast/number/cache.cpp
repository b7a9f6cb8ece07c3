#include <nipref/fast/number/caches.hpp>
#include <nipref/fast/number/internal/cache.hpp>

#include "support/test.hpp"

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
  Cache<int, int> cache(square);
  made = 0;
  const auto before = cache.at(7);
  CHECK(cache.at(7) == before);
  clear_caches();
  const auto after = cache.at(7);
  CHECK(made == 2);
  CHECK(after != before);
  CHECK(*after == *before);
}
