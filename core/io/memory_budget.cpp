#include "core/io/memory_budget.h"

#include "core/base/error.h"
#include "core/io/load_report.h"

#include <limits>

namespace dirt {

uint64_t MemoryBudget::left() const {
    const uint64_t used = taken(), all = limit();
    return used < all ? all - used : 0;
}

void MemoryBudget::spend(uint64_t bytes, const std::filesystem::path& file,
                         std::string_view what) const {
    if (!account_) return;
    uint64_t before = account_->taken.load();
    do {
        const uint64_t left = before < account_->limit ? account_->limit - before : 0;
        if (bytes > left)
            throw MemoryError(atLine(file, 0,
                                     std::string(what) + " needs " + memoryText(bytes) +
                                         " of memory; " + memoryText(left) + " of " +
                                         memoryText(account_->limit) + " are left"));
    } while (!account_->taken.compare_exchange_weak(before, before + bytes));
}

void MemoryClaim::take(uint64_t bytes, const std::filesystem::path& file, std::string_view what) {
    budget_.spend(bytes, file, what);
    bytes_ += bytes;
}

void MemoryClaim::giveBack(uint64_t bytes) {
    if (budget_.account_) budget_.account_->taken -= bytes;
    bytes_ -= bytes;
}

std::string memoryText(uint64_t bytes) {
    constexpr uint64_t kMega = 1'000'000, kGiga = 1'000'000'000;
    if (bytes < kGiga) return std::to_string((bytes + kMega - 1) / kMega) + " MB";
    const uint64_t tenths = bytes / (kGiga / 10);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}

uint64_t timesBytes(uint64_t a, uint64_t b) {
    uint64_t product = 0;
    return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<uint64_t>::max() : product;
}

} // namespace dirt
