#include "core/io/content_hash.h"

#include <cstring>

namespace dirt {

namespace {

/// An odd number with about half of its bits set, so that the product is a permutation.
constexpr uint64_t kFactor = 0x9e3779b97f4a7c15ull;

/// For a given state a permutation of the words, and for a given word one of the states: a word
/// that differs stays a state that differs.
uint64_t mixed(uint64_t state, uint64_t word) {
    const uint64_t product = (state ^ word) * kFactor;
    return product ^ product >> 32;
}

} // namespace

uint64_t contentHash(std::span<const std::byte> bytes) {
    // Four lanes, whose products do not wait for each other.
    uint64_t lanes[4] = {1, 2, 3, 4};
    const auto take = [&lanes](const std::byte* block) {
        for (int i = 0; i < 4; ++i) {
            uint64_t word;
            std::memcpy(&word, block + i * 8, 8);
            lanes[i] = mixed(lanes[i], word);
        }
    };
    size_t done = 0;
    for (; done + 32 <= bytes.size(); done += 32) take(bytes.data() + done);
    std::byte last[32] = {};
    if (done < bytes.size()) std::memcpy(last, bytes.data() + done, bytes.size() - done);
    take(last);
    uint64_t hash = bytes.size();
    for (const uint64_t lane : lanes) hash = mixed(hash, lane);
    return mixed(hash, hash >> 32);
}

} // namespace dirt
