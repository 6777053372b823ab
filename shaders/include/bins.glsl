// BinMap of core/grid/grid.h: from depth to bin, monotone, for construction and traversal.

struct BinMap {
    float near, scale;
};

/// \p bounds: (near, far) of a tile.
BinMap binMap(vec2 bounds, int bins) {
    precise float length = bounds.y - bounds.x;
    length = flushed(length);
    if (!(length > 0.0)) return BinMap(bounds.x, 0.0);
    // A quotient of doubles rounded to float is the correctly rounded quotient of floats, which
    // float division is not everywhere.
    precise double quotient = double(bins) / double(length);
    float scale = quotient <= double(kLargest) ? float(quotient) : 0.0;
    return BinMap(bounds.x, scale);
}

int binOf(BinMap map, float w, int bins) {
    precise float offset = w - map.near;
    precise float bin = flushed(offset) * map.scale;
    return int(min(max(bin, 0.0), float(bins - 1)));
}
