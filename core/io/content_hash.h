#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace dirt {

/// 64 bits that change where the bytes do: always for one changed word, else but for one in 2^64.
/// Against accidents, not against attackers. Some gigabytes a second.
uint64_t contentHash(std::span<const std::byte> bytes);

} // namespace dirt
