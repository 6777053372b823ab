#pragma once

// Counts what this program has allocated: operator new of the whole test. To be included by one
// file of it.

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace dirt::test {

inline std::atomic<int64_t> allocated{0}; ///< bytes that are in use
inline std::atomic<int64_t> mostAllocated{0};

/// The most that \p body had allocated at once, above what there was before.
template <typename Body>
int64_t peakOf(Body&& body) {
    const int64_t before = allocated;
    mostAllocated = before;
    body();
    return mostAllocated - before;
}

inline void* countedNew(size_t size, size_t alignment) {
    void* const memory =
        alignment > alignof(std::max_align_t)
            ? aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
            : std::malloc(size);
    if (!memory) throw std::bad_alloc();
    const int64_t now = allocated += (int64_t) malloc_usable_size(memory);
    for (int64_t most = mostAllocated;
         now > most && !mostAllocated.compare_exchange_weak(most, now);)
        ;
    return memory;
}

inline void countedDelete(void* memory) {
    if (memory) allocated -= (int64_t) malloc_usable_size(memory);
    std::free(memory);
}

} // namespace dirt::test

void* operator new(size_t size) {
    return dirt::test::countedNew(size, 1);
}
void* operator new[](size_t size) {
    return dirt::test::countedNew(size, 1);
}
void* operator new(size_t size, std::align_val_t alignment) {
    return dirt::test::countedNew(size, (size_t) alignment);
}
void* operator new[](size_t size, std::align_val_t alignment) {
    return dirt::test::countedNew(size, (size_t) alignment);
}
void operator delete(void* memory) noexcept {
    dirt::test::countedDelete(memory);
}
void operator delete[](void* memory) noexcept {
    dirt::test::countedDelete(memory);
}
void operator delete(void* memory, size_t) noexcept {
    dirt::test::countedDelete(memory);
}
void operator delete[](void* memory, size_t) noexcept {
    dirt::test::countedDelete(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    dirt::test::countedDelete(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    dirt::test::countedDelete(memory);
}
void operator delete(void* memory, size_t, std::align_val_t) noexcept {
    dirt::test::countedDelete(memory);
}
void operator delete[](void* memory, size_t, std::align_val_t) noexcept {
    dirt::test::countedDelete(memory);
}
