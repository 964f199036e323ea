#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace bosk {

// The newest value that a worker has put for the window to see; what nobody took is replaced.
template <class T>
class Mailbox {
 public:
  void put(T value) {
    auto fresh = std::make_shared<const T>(std::move(value));
    const std::lock_guard lock(mutex_);
    value_ = std::move(fresh);
  }
  // Null where nothing new came since the last call.
  std::shared_ptr<const T> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(value_, nullptr);
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

}  // namespace bosk
