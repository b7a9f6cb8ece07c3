#include <mutex>
#include <vector>

#include <nipref/fast/number/caches.hpp>
#include <nipref/fast/number/internal/memo.hpp>

namespace nipref::fast {
namespace {

struct Registry {
  std::mutex mutex;
  std::vector<Cache*> caches;
};

Registry& registry() {
  static Registry all;
  return all;
}

}  // namespace

void Cache::enter() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  all.caches.push_back(this);
}

void Cache::leave() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  std::erase(all.caches, this);
}

void clear_caches() {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  for (Cache* cache : all.caches) cache->clear();
}

}  // namespace nipref::fast
