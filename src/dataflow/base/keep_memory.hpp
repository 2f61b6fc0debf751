#pragma once
#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace dataflow {

/// For a program that does the same again and again: memory that was freed stays with it. Otherwise what one retiming
/// gives back to the host the next asks for again, page by page.
inline void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int most_kept = 64 << 20, least_of_its_own = 4 << 20;  // bytes
    mallopt(M_TRIM_THRESHOLD, most_kept);
    mallopt(M_MMAP_THRESHOLD, least_of_its_own);
#endif
}

}  // namespace dataflow
