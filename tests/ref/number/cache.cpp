#include <atomic>
#include <thread>

#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/number/caches.hpp>
#include <nipref/ref/number/internal/cache.hpp>
#include <nipref/ref/sheet/kernels.hpp>

#include "support/test.hpp"

using namespace nipref::ref;

namespace {

std::atomic<int> made = 0;

/// As many zeros as the key says.
std::vector<char> make(const int& key) {
  ++made;
  if (key < 0) throw std::out_of_range("negative");
  return std::vector<char>(static_cast<std::size_t>(key));
}

std::size_t size(const std::vector<char>& value) { return value.size(); }

/// A kernel and a displacement that has a memory. Every cache of the reference takes part in one of them.
std::vector<std::string> values() {
  const Exact one(1.0);
  const Enclosure kernel = I1(Exact(0.75), 60);
  const Enclosure memory =
      MovingLoad(exact_solid(Solid::thesis, one, one), one, one).normal_displacement(one, Exact(2.0), 40);
  return {kernel.value_text(), kernel.error_text(), memory.value_text(), memory.error_text()};
}

}  // namespace

TEST_CASE("a memo computes a value once, and again after clear()") {
  Cache<int, std::vector<char>> memo(make, size);
  made = 0;
  const auto first = memo.at(10);
  CHECK(first->size() == 10);
  CHECK(memo.at(10) == first);
  CHECK(made == 1);
  CHECK(memo.bytes() == 10);
  memo.clear();
  CHECK(memo.bytes() == 0);
  CHECK(first->size() == 10);
  CHECK(memo.at(10) != first);
  CHECK(made == 2);
}

TEST_CASE("a full memo forgets what has not been asked for the longest") {
  Cache<int, std::vector<char>> memo(make, size, 100);
  memo.at(40);
  memo.at(50);
  memo.at(40);
  memo.at(30);
  CHECK(memo.bytes() == 70);
  made = 0;
  memo.at(40);
  memo.at(30);
  CHECK(made == 0);
  memo.at(50);
  CHECK(made == 1);
  CHECK(memo.bytes() == 80);
  CHECK(memo.at(200)->size() == 200);
  CHECK(memo.bytes() == 200);
}

TEST_CASE("a memo passes on what is thrown and tries again") {
  Cache<int, std::vector<char>> memo(make, size);
  made = 0;
  CHECK_THROWS_AS(memo.at(-1), std::out_of_range);
  CHECK_THROWS_AS(memo.at(-1), std::out_of_range);
  CHECK(made == 2);
  CHECK(memo.bytes() == 0);
}

TEST_CASE("threads that ask a memo at the same time share one value") {
  Cache<int, std::vector<char>> memo(make, size);
  made = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&memo] {
      for (int round = 0; round < 1000; ++round) memo.at(round % 10);
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(made == 10);
  CHECK(memo.bytes() == 45);
}

TEST_CASE("clear_caches() empties every cache of ref, and values after it are the same") {
  clear_caches();
  REQUIRE(cached_bytes() == 0);
  const auto before = values();
  const std::size_t bytes = cached_bytes();
  CHECK(bytes > 0);
  CHECK(values() == before);
  CHECK(cached_bytes() == bytes);
  clear_caches();
  CHECK(cached_bytes() == 0);
  CHECK(values() == before);
  CHECK(cached_bytes() == bytes);
}
