#include "core/io/gltf_data.h"

namespace dirt {

namespace {

/// The six bits of a base64 digit; -1 where it is none.
int base64Digit(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

} // namespace

std::optional<std::string> decodeDataUri(std::string_view uri, const JsonValue& from) {
    if (uri.substr(0, 5) != "data:") return std::nullopt;
    const size_t comma = uri.find(',');
    if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64"))
        from.fail("has a data URI that is not in base64");
    std::string_view digits = uri.substr(comma + 1);
    while (digits.ends_with('=')) digits.remove_suffix(1);
    std::string bytes;
    bytes.reserve(digits.size() / 4 * 3 + 3);
    uint32_t bits = 0;
    int count = 0;
    for (const char c : digits) {
        const int digit = base64Digit(c);
        if (digit < 0) from.fail("has a data URI with a character that is not of base64");
        bits = (bits << 6 | (uint32_t) digit) & 0xffff;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back((char) (bits >> count & 0xff));
    }
    return bytes;
}

std::string decodeUri(std::string_view uri) {
    std::string text;
    for (size_t i = 0; i < uri.size(); ++i) {
        const bool coded = uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 &&
                           hexDigit(uri[i + 2]) >= 0;
        text.push_back(coded ? (char) (hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2])) : uri[i]);
        if (coded) i += 2;
    }
    return text;
}

} // namespace dirt
