/// \file
/// Scratch memory of a function that is called too often for the heap.
#pragma once

#include <array>
#include <cstddef>
#include <memory>

namespace eliminant::field {

/// `size` elements, on the stack if there are at most N. They are not initialised unless their type does it.
template <class T, std::size_t N>
class SmallBuffer {
  public:
    explicit SmallBuffer(std::size_t size) {
        if (size <= N) return;
        heap_ = std::make_unique_for_overwrite<T[]>(size);
        data_ = heap_.get();
    }
    SmallBuffer(const SmallBuffer&) = delete;
    SmallBuffer& operator=(const SmallBuffer&) = delete;

    T* data() { return data_; }
    T& operator[](std::size_t i) { return data_[i]; }
    const T& operator[](std::size_t i) const { return data_[i]; }

  private:
    std::array<T, N> stack_; // NOLINT: left uninitialised on purpose
    std::unique_ptr<T[]> heap_;
    T* data_ = stack_.data();
};

} // namespace eliminant::field
