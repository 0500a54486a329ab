#pragma once

#include <map>

namespace stokesbook::test {

/// Computes a value once for each key, so that the lines and controls of an experiment can use the
/// same expensive results.
template <class Key, class Value>
class Once {
 public:
  template <class Make>
  const Value& operator()(const Key& key, const Make& make) {
    const auto found = values_.find(key);
    return found != values_.end() ? found->second : values_.emplace(key, make()).first->second;
  }

 private:
  std::map<Key, Value> values_;
};

}  // namespace stokesbook::test
