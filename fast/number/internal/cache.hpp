#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>

namespace nipref::fast {

/// A cache that fast::clear_caches() empties.
class ClearableCache {
 public:
  ClearableCache() = default;
  ClearableCache(const ClearableCache&) = delete;
  ClearableCache& operator=(const ClearableCache&) = delete;
  virtual void clear() = 0;

 protected:
  ~ClearableCache() = default;
  /// `enter` registers the cache with clear_caches() after its construction; `leave` removes it before its destruction.
  void enter();
  void leave();
};

/// The values of a function of `Key`, each computed at its first use. When there are `most` values, all are dropped before
/// the next is kept. Thread-safe: threads that need a value at once may each compute it, but all get the same one.
template <class Key, class Value>
class Cache final : public ClearableCache {
 public:
  static constexpr std::size_t usual_most = 256;

  explicit Cache(Value (*make)(const Key&), std::size_t most = usual_most) : make_(make), most_(most) {
    enter();
  }
  ~Cache() { leave(); }

  /// The value lives as long as the cache or a caller refers to it.
  std::shared_ptr<const Value> at(const Key& key) {
    {
      const std::lock_guard lock(mutex_);
      const auto found = kept_.find(key);
      if (found != kept_.end()) return found->second;
    }
    auto made = std::make_shared<const Value>(make_(key));
    const std::lock_guard lock(mutex_);
    if (kept_.size() >= most_) kept_.clear();
    return kept_.emplace(key, std::move(made)).first->second;
  }

  void clear() override {
    const std::lock_guard lock(mutex_);
    kept_.clear();
  }

 private:
  Value (*make_)(const Key&);
  std::size_t most_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const Value>> kept_;
};

}  // namespace nipref::fast
