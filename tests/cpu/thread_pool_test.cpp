#include "backend_cpu/thread_pool.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

namespace dirt {
namespace {

TEST(ThreadPool, CoversEachIndexOnce) {
    for (unsigned threads : {1u, 2u, 7u}) {
        ThreadPool pool(threads);
        EXPECT_EQ(pool.threads(), threads);
        for (size_t count : {0u, 1u, 5u, 1000u, 4097u}) {
            std::vector<int> seen(count, 0);
            pool.forRange(count, 16, [&](size_t begin, size_t end) {
                for (size_t i = begin; i < end; ++i) ++seen[i];
            });
            EXPECT_EQ(seen, std::vector<int>(count, 1));
        }
    }
}

TEST(ThreadPool, GoesOnWithTheThreadsThereAre) {
    for (const unsigned possible : {0u, 1u, 5u, 6u}) {
        unsigned made = 0;
        ThreadPool pool(7, [&](std::function<void()> run) {
            if (made == possible)
                throw std::system_error(
                    std::make_error_code(std::errc::resource_unavailable_try_again));
            ++made;
            return std::thread(std::move(run));
        });
        EXPECT_EQ(pool.threads(), possible + 1);
        EXPECT_EQ(pool.missing(), 6 - possible);
        std::vector<int> seen(1000, 0);
        pool.forRange(seen.size(), 16, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) ++seen[i];
        });
        EXPECT_EQ(seen, std::vector<int>(1000, 1));
    }
}

TEST(ThreadPool, ManyShortLoops) {
    ThreadPool pool(3);
    std::atomic<size_t> sum{0};
    for (int i = 0; i < 2000; ++i)
        pool.forRange(10, 1, [&](size_t begin, size_t) { sum += begin; });
    EXPECT_EQ(sum, 2000u * 45u);
}

TEST(ThreadPool, RethrowsAndGoesOn) {
    ThreadPool pool(4);
    EXPECT_THROW(pool.forRange(1000, 1,
                               [](size_t begin, size_t) {
                                   if (begin == 500) throw std::runtime_error("piece 500");
                               }),
                 std::runtime_error);
    std::atomic<int> pieces{0};
    pool.forRange(100, 10, [&](size_t, size_t) { ++pieces; });
    EXPECT_EQ(pieces, 10);
}

} // namespace
} // namespace dirt
