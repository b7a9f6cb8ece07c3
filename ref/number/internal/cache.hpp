#pragma once
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

namespace nipref::ref {

/// What ref::clear_caches() empties.
class ClearableCache {
 public:
  ClearableCache() = default;
  ClearableCache(const ClearableCache&) = delete;
  ClearableCache& operator=(const ClearableCache&) = delete;
  virtual void clear() = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;

 protected:
  ~ClearableCache() = default;
  /// From `enter`, when it is whole, to `leave`, while it still is, a cache is known to clear_caches().
  void enter();
  void leave();
};

/// The values of a function of `Key`, each computed when it is first asked for and kept. When they take more
/// than `capacity` bytes those that have not been asked for the longest go, the latest excepted. One policy
/// for everything that this room keeps. Thread-safe: a value is computed once while others wait for it, and
/// other keys do not wait.
template <class Key, class Value>
class Cache final : public ClearableCache {
 public:
  using Make = Value (*)(const Key&);
  using Size = std::size_t (*)(const Value&);  ///< in bytes

  static constexpr std::size_t usual_capacity = std::size_t{1} << 30;

  explicit Cache(Make make, Size size, std::size_t capacity = usual_capacity)
      : make_(make), size_(size), capacity_(capacity) {
    enter();
  }
  ~Cache() { leave(); }

  /// Lives as long as it is held here or by a caller. What `make` throws is passed on; the next call tries again.
  std::shared_ptr<const Value> at(const Key& key) {
    const std::shared_ptr<Slot> slot = slot_of(key);
    const std::lock_guard lock(slot->making);
    if (!slot->value) {
      slot->value = std::make_shared<const Value>(make_(key));
      keep(key, slot);
    }
    return slot->value;
  }

  void clear() override {
    const std::lock_guard lock(mutex_);
    slots_.clear();
    bytes_ = 0;
  }

  [[nodiscard]] std::size_t bytes() const override {
    const std::lock_guard lock(mutex_);
    return bytes_;
  }

 private:
  struct Slot {
    std::mutex making;  ///< guards the value
    std::shared_ptr<const Value> value;
    std::size_t bytes = 0;  ///< this and last_use are guarded by the cache's mutex
    long last_use = 0;
  };

  std::shared_ptr<Slot> slot_of(const Key& key) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Slot>& slot = slots_[key];
    if (!slot) slot = std::make_shared<Slot>();
    slot->last_use = ++uses_;
    return slot;
  }

  /// Counts a value just made, unless the cache has been cleared in the meantime, and lets others go for it.
  void keep(const Key& key, const std::shared_ptr<Slot>& slot) {
    const std::lock_guard lock(mutex_);
    const auto kept = slots_.find(key);
    if (kept == slots_.end() || kept->second != slot) return;
    slot->bytes = size_(*slot->value);
    bytes_ += slot->bytes;
    while (bytes_ > capacity_ && slots_.size() > 1) {
      const auto oldest =
          std::ranges::min_element(slots_, {}, [](const auto& entry) { return entry.second->last_use; });
      bytes_ -= oldest->second->bytes;
      slots_.erase(oldest);
    }
  }

  Make make_;
  Size size_;
  std::size_t capacity_;
  mutable std::mutex mutex_;
  std::map<Key, std::shared_ptr<Slot>> slots_;
  std::size_t bytes_ = 0;
  long uses_ = 0;
};

}  // namespace nipref::ref
