#pragma once
#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

namespace nipref::ref {

/// A cache that ref::clear_caches() empties.
class ClearableCache {
 public:
  ClearableCache() = default;
  ClearableCache(const ClearableCache&) = delete;
  ClearableCache& operator=(const ClearableCache&) = delete;
  virtual void clear() = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;

 protected:
  ~ClearableCache() = default;
  /// enter() registers the cache with clear_caches(), leave() removes it. The derived class calls enter() at the end of
  /// its constructor and leave() at the start of its destructor, so that clear() is only called on a complete object.
  void enter();
  void leave();
};

/// A cache of the values of a function of `Key`, each computed at its first request. When the values take more than
/// `capacity` bytes, the least recently requested ones are dropped, but never the latest. All caches of the reference
/// are of this type. Thread-safe: one thread computes a value; requests for the same key wait for it, requests for
/// other keys do not.
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

  /// The value of the function at `key`. It lives as long as the cache or a caller holds it. An exception thrown by
  /// `make` is passed on, and the next call tries again.
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
    std::size_t bytes = 0;  ///< size of the value; the cache's mutex guards it and last_use
    long last_use = 0;
  };

  std::shared_ptr<Slot> slot_of(const Key& key) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<Slot>& slot = slots_[key];
    if (!slot) slot = std::make_shared<Slot>();
    slot->last_use = ++uses_;
    return slot;
  }

  /// Adds the size of a new value, unless the cache has been cleared in the meantime, and drops old values for it.
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
