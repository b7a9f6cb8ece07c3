#include <mutex>
#include <vector>

#include <nipref/fast/number/caches.hpp>
#include <nipref/fast/number/internal/cache.hpp>

namespace nipref::fast {
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
}

}  // namespace nipref::fast
