#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace nipref::verify {

/// What was computed for a key, for those who ask for it again: several quantities come out of one solution, several
/// columns of a figure too. The whole is forgotten when it has grown to `most` keys. Thread-safe; what two threads ask for
/// at once may be computed twice.
template <class Key, class Value>
class Cache {
 public:
  /// `make` computes it; what that throws is passed on.
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
