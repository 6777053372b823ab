#pragma once

#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace dirt {

/// All of \p text as a decimal number ("1", "+2.", ".5", "-3e+7"), correctly rounded; nothing where
/// it is none. The words "nan" and "inf", Microsoft's "1.#QNAN" and "-1.#IND", and values beyond
/// double are not finite; values too small are zero.
std::optional<double> parseNumber(std::string_view text);

/// All of \p text as a decimal integer; nothing where it is none or does not fit.
std::optional<int> parseInteger(std::string_view text);

/// Whether \p value is finite and does not overflow float32.
bool fitsFloat(double value);
bool fitsFloat(const glm::dvec3& value);

} // namespace dirt
