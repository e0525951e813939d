#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace rockslope::dda {

/// Uninitialised scalars, aligned to a cache line of 64 bytes. Growing discards the contents; a smaller size
/// keeps the memory until release().
template <class Scalar>
class AlignedBuffer {
  public:
    /// Makes room for at least `size` elements; the values are lost when it grows.
    void resize(std::size_t size) {
        if (size <= size_) return;
        data_.reset();
        data_.reset(static_cast<Scalar*>(::operator new(size * sizeof(Scalar), line)));
        size_ = size;
    }
    /// Gives the memory back.
    void release() {
        data_.reset();
        size_ = 0;
    }
    /// The first element.
    Scalar* data() { return data_.get(); }
    const Scalar* data() const { return data_.get(); }

  private:
    static constexpr std::align_val_t line{64};
    struct Release {
        void operator()(Scalar* data) const { ::operator delete(data, line); }
    };
    std::unique_ptr<Scalar, Release> data_;
    std::size_t size_ = 0;
};

}  // namespace rockslope::dda
