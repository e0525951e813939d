#pragma once

#include "dda/linear/symbolic_factor.hpp"

namespace rockslope::dda {

/// Inlines a kernel into its callers, each of which is compiled for one processor type.
#define DDA_KERNEL [[gnu::always_inline]] inline

/// Access to a panel's rows, stored in strips (see front_kernels.hpp), by vectors of Bytes bytes.
template <class Scalar, int Bytes>
struct Strips {
    typedef Scalar Vector __attribute__((vector_size(Bytes), may_alias));
    /// A vector at any address: the caller's array may begin anywhere, and the sanitizer's stack frames do
    /// not keep the alignment of wide vectors. A struct, because clang forgets that a vector type is
    /// unaligned when a function returns a reference to it. At an aligned address it costs the same.
    struct [[gnu::packed, gnu::may_alias]] Unaligned {
        Vector vector;
    };
    static constexpr int unknowns = 6;
    static constexpr int lanes = Bytes / static_cast<int>(sizeof(Scalar));
    static constexpr int w = strip_rows<Scalar>;
    static constexpr int per_strip = w / lanes;

    /// Offset of the first scalar of a row.
    DDA_KERNEL static long row_at(int row, int columns) {
        return static_cast<long>(row / w) * w * columns + row % w;
    }
    /// Offset of the first scalar of a vector of rows.
    DDA_KERNEL static long vector_at(int vector, int columns) {
        return static_cast<long>(vector / per_strip) * w * columns +
               static_cast<long>(vector % per_strip) * lanes;
    }

    DDA_KERNEL static const Unaligned& load(const Scalar* at) {
        return *reinterpret_cast<const Unaligned*>(at);
    }
    DDA_KERNEL static void store(const Vector& vector, Scalar* at) {
        reinterpret_cast<Unaligned*>(at)->vector = vector;
    }
};

}  // namespace rockslope::dda
