#pragma once

#include <cstddef>
#include <cstring>
#include <span>

namespace dirt {

/// The value number \p index of an array that lies in \p bytes, aligned or not.
template <typename Value>
Value valueAt(std::span<const std::byte> bytes, size_t index) {
    Value value;
    std::memcpy(&value, bytes.data() + index * sizeof(Value), sizeof(Value));
    return value;
}

} // namespace dirt
