#pragma once

#include "dda/linear/symbolic_factor.hpp"

namespace rockslope::dda {

/// Kernels are inlined into functions that are compiled for one kind of processor each.
#define DDA_KERNEL [[gnu::always_inline]] inline

/// A panel's rows in strips, see front_kernels.hpp, as vectors of Bytes bytes.
template <class Scalar, int Bytes>
struct Strips {
    typedef Scalar Vector __attribute__((vector_size(Bytes), may_alias));
    /// Of any place: the sanitizer's stack frames do not keep to the alignment that wide vectors ask for, and
    /// where the place is aligned it costs the same.
    typedef Scalar UnalignedVector __attribute__((vector_size(Bytes), may_alias, aligned(alignof(Scalar))));
    static constexpr int unknowns = 6;
    static constexpr int lanes = Bytes / static_cast<int>(sizeof(Scalar));
    static constexpr int w = strip_rows<Scalar>;
    static constexpr int per_strip = w / lanes;

    DDA_KERNEL static long row_at(int row, int columns) {
        return static_cast<long>(row / w) * w * columns + row % w;
    }
    /// Where the rows of a vector begin.
    DDA_KERNEL static long vector_at(int vector, int columns) {
        return static_cast<long>(vector / per_strip) * w * columns +
               static_cast<long>(vector % per_strip) * lanes;
    }

    DDA_KERNEL static const UnalignedVector& load(const Scalar* at) {
        return *reinterpret_cast<const UnalignedVector*>(at);
    }
    DDA_KERNEL static void store(const Vector& vector, Scalar* at) {
        *reinterpret_cast<UnalignedVector*>(at) = vector;
    }
};

}  // namespace rockslope::dda
