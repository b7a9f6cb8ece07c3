#pragma once
#include <functional>
#include <map>
#include <mutex>

namespace nipref::verify {

/// Keeps what was computed, for figures that draw other columns of the same. May be asked from several threads, which
/// then compute the same twice at worst.
template <class Key, class Value>
class Memo {
 public:
  Value get(const Key& key, const std::function<Value()>& compute) {
    {
      const std::scoped_lock lock(mutex_);
      if (const auto known = values_.find(key); known != values_.end()) return known->second;
    }
    Value value = compute();
    const std::scoped_lock lock(mutex_);
    return values_.insert_or_assign(key, std::move(value)).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<Key, Value> values_;
};

}  // namespace nipref::verify
