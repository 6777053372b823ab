#include "core/scene/light.h"

#include <cmath>

namespace dirt {

double roundedFlux(double flux) {
    int exponent = 0;
    const double digits = std::frexp(flux, &exponent);
    return std::ldexp((double) (float) digits, exponent);
}

} // namespace dirt
