#pragma once

#include <cstddef>
#include <vector>

namespace dirt {

/// One channel of an image: row-major, the first row on top.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> values;

    Plane() = default;
    Plane(int width, int height) : width(width), height(height), values((size_t) width * height) {}

    double* row(int y) { return values.data() + (size_t) y * width; }
    const double* row(int y) const { return values.data() + (size_t) y * width; }
    double at(int x, int y) const { return row(y)[x]; }
};

} // namespace dirt
