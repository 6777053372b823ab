#pragma once

#include <cstddef>
#include <string_view>

namespace dirt {

/// Bytes of the UTF-8 sequence that \p text begins with; 0 where it begins with none (a stray or
/// missing continuation byte, an overlong form, a surrogate, a value above U+10FFFF).
inline size_t utf8Length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](size_t i) { return (unsigned char) text[i]; };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    const size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    for (size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    if (lead == 0xe0 && byte(1) < 0xa0) return 0;  // overlong
    if (lead == 0xed && byte(1) >= 0xa0) return 0; // surrogate
    if (lead == 0xf0 && byte(1) < 0x90) return 0;  // overlong
    if (lead == 0xf4 && byte(1) >= 0x90) return 0; // above U+10FFFF
    return length;
}

} // namespace dirt
