#include "heap.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>

// A sanitizer brings a heap of its own, in which the gigabyte would take 0.15 s of each start.
#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HEAP_OF_A_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HEAP_OF_A_SANITIZER
#endif

namespace rockslope {

void use_large_pages() {
#if defined(__GLIBC__) && !defined(HEAP_OF_A_SANITIZER)
    constexpr std::size_t large_page = 2 << 20;
    constexpr std::size_t heap_bytes = 1 << 30;
    // Of one arena, for those of further threads lie elsewhere.
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    void* const heap = std::malloc(heap_bytes);
    void* first = heap;
    std::size_t space = heap_bytes;
    if (heap != nullptr && std::align(large_page, heap_bytes - large_page, first, space) != nullptr)
        madvise(first, heap_bytes - large_page, MADV_HUGEPAGE);
    std::free(heap);
#endif
}

}  // namespace rockslope
