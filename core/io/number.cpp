#include "core/io/number.h"

#include <algorithm>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace dirt {

namespace {

/// std::from_chars takes no plus sign.
std::string_view withoutPlus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    return plus ? text.substr(1) : text;
}

bool isLetterOrDigit(char c) {
    return (c >= '0' && c <= '9') || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z');
}

/// What Microsoft's printf made of values that are not finite, before 2015: "1.#QNAN0", "-1.#IND",
/// "1.#INF00" and, with few digits, a rounded form of these. None of them is of use, so all become
/// NaN.
bool isMicrosoftNaN(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    return text.size() > 3 && text.starts_with("1.#") &&
           std::all_of(text.begin() + 3, text.end(), isLetterOrDigit);
}

} // namespace

std::optional<double> parseNumber(std::string_view text) {
    const std::string_view digits = withoutPlus(text);
    const char* end = digits.data() + digits.size();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error == std::errc() && stop != end && isMicrosoftNaN(digits))
        return std::numeric_limits<double>::quiet_NaN();
    if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
    // from_chars does not tell too large from too small; strtod does.
    if (error == std::errc::result_out_of_range)
        return std::strtod(std::string(digits).c_str(), nullptr);
    return value;
}

std::optional<int> parseInteger(std::string_view text) {
    const std::string_view digits = withoutPlus(text);
    const char* end = digits.data() + digits.size();
    int value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error != std::errc()) return std::nullopt;
    return value;
}

bool fitsFloat(double value) {
    return std::fabs(value) <= (double) FLT_MAX;
}

bool fitsFloat(const glm::dvec3& value) {
    return fitsFloat(value.x) && fitsFloat(value.y) && fitsFloat(value.z);
}

} // namespace dirt
