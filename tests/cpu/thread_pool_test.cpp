#include "backend_cpu/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
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

/// G7 is the Executor's, so that no algorithm has to see to it and no kind of executor can forget
/// it.
TEST(Executor, FlushesDenormalsInEveryPieceAndNowhereElse) {
    const volatile float tiny = 0x1p-100f;
    const auto keepsDenormals = [&] { return tiny * 0x1p-40f != 0.0f; };
    ASSERT_TRUE(keepsDenormals());
    SerialExecutor serial;
    ThreadPool pool(3);
    for (Executor* executor : {(Executor*) &serial, (Executor*) &pool}) {
        std::atomic<int> kept{0}, pieces{0};
        executor->forRange(100, 1, [&](size_t, size_t) {
            ++pieces;
            kept += keepsDenormals();
        });
        EXPECT_EQ(pieces, 100);
        EXPECT_EQ(kept, 0);
        EXPECT_THROW(executor->forRange(1, 1, [](size_t, size_t) { throw std::bad_alloc(); }),
                     std::bad_alloc);
        EXPECT_TRUE(keepsDenormals());
    }
}

} // namespace
} // namespace dirt
