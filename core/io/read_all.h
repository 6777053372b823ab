#pragma once

#include "core/base/denormals.h"
#include "core/base/executor.h"

#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <vector>

namespace dirt {

/// Told how many of so many files are read; on any thread, one call at a time.
using LoadProgress = std::function<void(size_t done, size_t total)>;

/// Calls \p read(index) for each of \p count files on the executor's threads. What it throws is
/// thrown when all are done: of several the one with the lowest index, whichever came first.
template <typename Read>
void readAll(size_t count, Executor& executor, const LoadProgress& progress, const Read& read) {
    std::vector<std::exception_ptr> errors(count);
    std::mutex mutex;
    size_t done = 0;
    executor.forRange(count, 1, [&](size_t begin, size_t end) {
        const KeepDenormals keep;
        for (size_t i = begin; i < end; ++i) {
            try {
                read(i);
            } catch (...) {
                errors[i] = std::current_exception();
            }
            const std::lock_guard lock(mutex);
            ++done;
            if (progress) progress(done, count);
        }
    });
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

} // namespace dirt
