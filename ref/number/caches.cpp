#include <mpfr.h>

#include <mutex>
#include <vector>

#include <nipref/ref/number/caches.hpp>
#include <nipref/ref/number/internal/cache.hpp>

namespace nipref::ref {
namespace {

struct Registry {
  std::mutex mutex;
  std::vector<ClearableCache*> caches;
};

Registry& registry() {
  static Registry all;
  return all;
}

}  // namespace

void ClearableCache::enter() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  all.caches.push_back(this);
}

void ClearableCache::leave() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  std::erase(all.caches, this);
}

void clear_caches() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  for (ClearableCache* cache : all.caches) cache->clear();
  mpfr_free_cache();
}

std::size_t cached_bytes() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  std::size_t sum = 0;
  for (const ClearableCache* cache : all.caches) sum += cache->bytes();
  return sum;
}

}  // namespace nipref::ref
