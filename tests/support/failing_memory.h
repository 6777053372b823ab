#pragma once

// Memory that cannot be had: operator new of the whole test, of which any call can be made to fail.
// To be included by one file of it.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>

namespace dirt::test {

/// Which calls of operator new fail: of those for \p least bytes or more, counted from 0 on all
/// threads, \p count from the \p first on.
struct FailingCalls {
    static constexpr int64_t kNone = std::numeric_limits<int64_t>::max();

    int64_t first = kNone;
    int64_t count = 1;
    size_t least = 0;
};

inline std::atomic<int64_t> callsOfNew{0}, firstFailing{FailingCalls::kNone}, failingCalls{1};
inline std::atomic<size_t> leastFailing{0};

/// Runs \p body while \p failing fail; returns how many calls for so much there were.
template <typename Body>
int64_t withFailing(const FailingCalls& failing, Body&& body) {
    leastFailing = failing.least;
    callsOfNew = 0;
    failingCalls = failing.count;
    firstFailing = failing.first;
    body();
    firstFailing = FailingCalls::kNone;
    return callsOfNew;
}

inline void* newOrFail(size_t size, size_t alignment) {
    if (size >= leastFailing) {
        const int64_t call = callsOfNew++, first = firstFailing;
        if (call >= first && call - first < failingCalls) throw std::bad_alloc();
    }
    void* const memory =
        alignment > alignof(std::max_align_t)
            ? aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
            : std::malloc(size > 0 ? size : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

} // namespace dirt::test

void* operator new(size_t size) {
    return dirt::test::newOrFail(size, 1);
}
void* operator new[](size_t size) {
    return dirt::test::newOrFail(size, 1);
}
void* operator new(size_t size, std::align_val_t alignment) {
    return dirt::test::newOrFail(size, (size_t) alignment);
}
void* operator new[](size_t size, std::align_val_t alignment) {
    return dirt::test::newOrFail(size, (size_t) alignment);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, size_t, std::align_val_t) noexcept {
    std::free(memory);
}
