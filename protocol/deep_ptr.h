// A unique_ptr whose copy is a copy of what it owns.
#pragma once

#include <memory>
#include <utility>

namespace hazer::protocol {

/// Lets a structure that owns a part on the heap be copied as a whole, as a player of recordings does.
template <class T>
class DeepPtr {
 public:
    DeepPtr() = default;
    explicit DeepPtr(std::unique_ptr<T> owned) : owned_(std::move(owned)) {}
    DeepPtr(const DeepPtr& other) : owned_(other.owned_ ? std::make_unique<T>(*other.owned_) : nullptr) {}
    DeepPtr(DeepPtr&&) noexcept = default;
    DeepPtr& operator=(const DeepPtr& other) { return *this = DeepPtr(other); }
    DeepPtr& operator=(DeepPtr&&) noexcept = default;
    ~DeepPtr() = default;

    explicit operator bool() const { return owned_ != nullptr; }
    T& operator*() const { return *owned_; }
    T* operator->() const { return owned_.get(); }
    T* get() const { return owned_.get(); }

 private:
    std::unique_ptr<T> owned_;
};

template <class T, class... Arguments>
DeepPtr<T> makeDeep(Arguments&&... arguments) {
    return DeepPtr<T>(std::make_unique<T>(std::forward<Arguments>(arguments)...));
}

}  // namespace hazer::protocol
