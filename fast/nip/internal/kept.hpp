#pragma once
#include <map>

namespace nipref::fast {

/// What is made once for each key. To be emptied when the solutions change that it was made of.
template <class Key, class Value>
class Kept {
 public:
  template <class Make>
  const Value& of(const Key& key, const Make& make) {
    const auto found = kept_.find(key);
    return found != kept_.end() ? found->second : kept_.emplace(key, make()).first->second;
  }

 private:
  std::map<Key, Value> kept_;
};

}  // namespace nipref::fast
