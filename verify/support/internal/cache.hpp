#pragma once
#include <mutex>

#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A thread-safe cache of solutions from which several quantities, or several columns of a figure, are read. The cache is
/// emptied when it has `most` keys. A value that two threads need at the same time may be computed twice.
template <class Key, class Value>
class Cache {
 public:
  /// The value for a key, computed by `make` if it is not in the cache.
  template <class Make>
  std::shared_ptr<const Value> at(const Key& key, const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = values_.find(key); found != values_.end()) return found->second;
    }
    auto made = std::make_shared<const Value>(make());
    const std::lock_guard lock(mutex_);
    if (values_.size() >= most) values_.clear();
    values_.insert_or_assign(key, made);
    return made;
  }

 private:
  static constexpr std::size_t most = 2000;

  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const Value>> values_;
};

}  // namespace nipref::verify
