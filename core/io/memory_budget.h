#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace dirt {

/// How much memory a scene may take in all: its files while they are read, what is kept of them,
/// and a frame. Copies share one account. Without a limit nothing is counted.
///
/// What a file claims is charged before the memory is taken, so that a small one cannot cost all
/// there is. Things of a few kilobytes are not charged.
class MemoryBudget {
public:
    MemoryBudget() = default; ///< without a limit
    explicit MemoryBudget(uint64_t limit) : account_(std::make_shared<Account>(limit)) {}

    bool hasLimit() const { return account_ != nullptr; }
    uint64_t limit() const { return account_ ? account_->limit : ~uint64_t(0); }
    uint64_t taken() const { return account_ ? account_->taken.load() : 0; }
    uint64_t left() const;

    /// Takes \p bytes for good. Throws MemoryError, and takes nothing, where they are not left:
    /// "FILE: WHAT needs 2.1 GB of memory; 0.4 GB of 12.0 GB are left".
    void spend(uint64_t bytes, const std::filesystem::path& file, std::string_view what) const;

private:
    friend class MemoryClaim;
    struct Account {
        explicit Account(uint64_t limit) : limit(limit) {}
        const uint64_t limit;
        std::atomic<uint64_t> taken{0};
    };

    std::shared_ptr<Account> account_;
};

/// Bytes of a budget that are given back when this is gone.
class MemoryClaim {
public:
    MemoryClaim() = default; ///< of a budget without a limit
    explicit MemoryClaim(MemoryBudget budget) : budget_(std::move(budget)) {}
    ~MemoryClaim() { giveBack(bytes_); }
    MemoryClaim(MemoryClaim&& other) noexcept
        : budget_(std::move(other.budget_)), bytes_(std::exchange(other.bytes_, 0)) {}
    MemoryClaim& operator=(MemoryClaim&& other) noexcept {
        std::swap(budget_, other.budget_);
        std::swap(bytes_, other.bytes_);
        return *this;
    }

    const MemoryBudget& budget() const { return budget_; }
    uint64_t bytes() const { return bytes_; }
    /// Takes \p bytes more; see MemoryBudget::spend.
    void take(uint64_t bytes, const std::filesystem::path& file, std::string_view what);
    /// Takes what \p bytes are more than bytes().
    void reach(uint64_t bytes, const std::filesystem::path& file, std::string_view what) {
        if (bytes > bytes_) take(bytes - bytes_, file, what);
    }

private:
    void giveBack(uint64_t bytes);

    MemoryBudget budget_;
    uint64_t bytes_ = 0;
};

/// "12.3 GB", or "45 MB" below one.
std::string memoryText(uint64_t bytes);

/// a b; all there is where that overflows.
uint64_t timesBytes(uint64_t a, uint64_t b);

} // namespace dirt
