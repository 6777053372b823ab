#pragma once

#include "core/frame/path_buffers.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

/// Path buffers of two backends, compared.
namespace dirt::test {

/// Words of a record that differ; +0 and -0 are equal.
template <typename Record>
int differingWord(const Record& a, const Record& b) {
    uint32_t x[sizeof(Record) / 4 + 1] = {}, y[sizeof(Record) / 4 + 1] = {};
    std::memcpy(x, &a, sizeof a);
    std::memcpy(y, &b, sizeof b);
    for (size_t i = 0; i < std::size(x); ++i)
        if (x[i] != y[i] && ((x[i] | y[i]) & 0x7fffffffu) != 0) return (int) i;
    return -1;
}

template <typename Record>
testing::AssertionResult sameRecords(const char* name, const std::vector<Record>& a,
                                     const std::vector<Record>& b) {
    if (a.size() != b.size())
        return testing::AssertionFailure() << name << ": " << a.size() << " and " << b.size();
    size_t different = 0, first = 0;
    for (size_t i = a.size(); i-- > 0;)
        if (differingWord(a[i], b[i]) >= 0) {
            ++different;
            first = i;
        }
    if (different == 0) return testing::AssertionSuccess();
    const int word = differingWord(a[first], b[first]);
    float x = 0, y = 0;
    const size_t bytes = std::min<size_t>(4, sizeof(Record));
    std::memcpy(&x, (const char*) &a[first] + 4 * word, bytes);
    std::memcpy(&y, (const char*) &b[first] + 4 * word, bytes);
    return testing::AssertionFailure()
           << name << ": " << different << " of " << a.size() << " differ, first record " << first
           << " in word " << word << ": " << x << " and " << y;
}

/// Whether all buffers are equal to the bit, but for the signs of zeros; else what differs first.
inline testing::AssertionResult samePaths(const PathBuffers& a, const PathBuffers& b) {
    testing::AssertionResult result = testing::AssertionSuccess();
    const auto compare = [&](const char* name, const auto& x, const auto& y) {
        if (result) result = sameRecords(name, x, y);
    };
    compare("previous", a.previous, b.previous);
    compare("current", a.current, b.current);
    compare("next", a.next, b.next);
    compare("mask", a.mask, b.mask);
    compare("rays", a.rays, b.rays);
    compare("hits", a.hits, b.hits);
    compare("visibility", a.visibility, b.visibility);
    compare("radiance", a.radiance, b.radiance);
    compare("image", a.image, b.image);
    return result;
}

} // namespace dirt::test
