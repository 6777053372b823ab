#pragma once

#include <cstring>
#include <vector>

namespace dirt::test {

/// Whether two arrays have the same bytes: unlike ==, with NaNs, and zeros by their signs.
template <typename Value>
bool sameBits(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

} // namespace dirt::test
