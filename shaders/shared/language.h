// The common subset of C++ and GLSL in which the headers of this folder are written, so that both
// languages compute the same bits: x, +, -, /, sqrt, floor and abs on floats and doubles, integers,
// and no built-in function that an implementation may approximate. Where GLSL defines
// DIRT_NO_DOUBLES, they leave out what needs doubles.
#ifndef DIRT_SHARED_LANGUAGE_H
#define DIRT_SHARED_LANGUAGE_H

#ifdef __cplusplus

#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define DIRT_SHARED_BEGIN namespace dirt {
#define DIRT_SHARED_END }
#define DIRT_FUNCTION inline
#define DIRT_OUT(type) type&
#define DIRT_INOUT(type) type&
#define DIRT_PRECISE // -ffp-contract=off does it
#define DIRT_DEFAULT(value)                                                                        \
    { value }

namespace dirt {
using uint = uint32_t;
using glm::dvec3;
using glm::ivec2;
using glm::ivec4;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using std::abs;
using std::floor;
using std::sqrt;
inline uint floatBitsToUint(float x) {
    return std::bit_cast<uint>(x);
}
inline float uintBitsToFloat(uint x) {
    return std::bit_cast<float>(x);
}
inline double infinity() {
    return HUGE_VAL;
}
} // namespace dirt

#else

#define DIRT_SHARED_BEGIN
#define DIRT_SHARED_END
#define DIRT_FUNCTION
#define DIRT_OUT(type) out type
#define DIRT_INOUT(type) inout type
#define DIRT_PRECISE precise
#define DIRT_DEFAULT(value)

#ifndef DIRT_NO_DOUBLES
double infinity() {
    return packDouble2x32(uvec2(0u, 0x7ff00000u));
}
#endif

#endif

#ifndef DIRT_NO_DOUBLES

DIRT_SHARED_BEGIN

DIRT_FUNCTION int signOf(double x) {
    return int(x > 0.0) - int(x < 0.0);
}

DIRT_SHARED_END

#endif

#endif
