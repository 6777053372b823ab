#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dirt {

/// A set of numbers below a limit that finds its next member fast, however few it has.
class IndexSet {
public:
    static constexpr uint32_t kNone = 0xffffffffu;

    /// All numbers below \p limit, at least 1. Keeps its memory.
    void fill(uint32_t limit) {
        size_t levels = 0;
        for (size_t bits = limit;;) {
            const size_t words = (bits + 63) / 64;
            if (levels_.size() == levels) levels_.emplace_back();
            levels_[levels].assign(words, ~uint64_t(0));
            if (bits % 64 != 0) levels_[levels].back() = (uint64_t(1) << bits % 64) - 1;
            ++levels;
            if (words == 1) break;
            bits = words;
        }
        levels_.resize(levels);
    }

    void insert(uint32_t number) {
        for (auto& level : levels_) {
            level[number / 64] |= uint64_t(1) << number % 64;
            number /= 64;
        }
    }
    void erase(uint32_t number) {
        for (auto& level : levels_) {
            level[number / 64] &= ~(uint64_t(1) << number % 64);
            if (level[number / 64] != 0) return;
            number /= 64;
        }
    }

    /// The least member that is not below \p from; kNone where there is none.
    uint32_t next(uint32_t from) const {
        for (size_t k = 0; k < levels_.size(); ++k) {
            const size_t word = from / 64;
            if (word >= levels_[k].size()) return kNone;
            const uint64_t rest = levels_[k][word] >> from % 64;
            if (rest != 0) return down(k, from + (uint32_t) std::countr_zero(rest));
            from = (uint32_t) word + 1;
        }
        return kNone;
    }

private:
    uint32_t down(size_t k, uint32_t number) const {
        for (; k > 0; --k)
            number = number * 64 + (uint32_t) std::countr_zero(levels_[k - 1][number]);
        return number;
    }

    /// A bit each, then a bit for each word of the level below that is not 0.
    std::vector<std::vector<uint64_t>> levels_;
};

} // namespace dirt
