#include <list>
#include <mutex>

#include <nipref/ref/sheet/internal/nodes.hpp>

namespace nipref::ref {
namespace {

constexpr std::size_t capacity_bytes = std::size_t{1} << 30;

std::size_t size_in_bytes(const Nodes& nodes) {
  std::size_t bytes = 0;
  for (const NodeBlock& block : nodes.blocks)
    bytes += (block.real.size() + block.imag.size()) * sizeof(mp_limb_t);
  return bytes;
}

/// The sets in order of use, the latest first; the oldest go when the memory is used up.
class Store {
 public:
  std::shared_ptr<const Nodes> get(const NodeKey& key) {
    const std::lock_guard lock(mutex_);
    for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
      if (kept->nodes->key != key) continue;
      kept_.splice(kept_.begin(), kept_, kept);
      return kept_.front().nodes;
    }
    auto made = std::make_shared<const Nodes>(make_nodes(key));
    kept_.push_front({made, size_in_bytes(*made)});
    bytes_ += kept_.front().bytes;
    while (bytes_ > capacity_bytes && kept_.size() > 1) {
      bytes_ -= kept_.back().bytes;
      kept_.pop_back();
    }
    return made;
  }

 private:
  struct Kept {
    std::shared_ptr<const Nodes> nodes;
    std::size_t bytes;
  };
  std::mutex mutex_;
  std::list<Kept> kept_;
  std::size_t bytes_ = 0;
};

}  // namespace

std::shared_ptr<const Nodes> nodes(const NodeKey& key) {
  static Store store;
  return store.get(key);
}

}  // namespace nipref::ref
