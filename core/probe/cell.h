#pragma once

#include <compare>
#include <iosfwd>

namespace dirt {

/// A tile of one view: column 0 at the low end of x, row 0 at the low end of y.
struct Tile {
    int view = 0, column = 0, row = 0;
    auto operator<=>(const Tile&) const = default;
};

/// A bin of a tile: what has a list of ids.
struct Cell {
    int view = 0, column = 0, row = 0, bin = 0;
    Tile tile() const { return {view, column, row}; }
    auto operator<=>(const Cell&) const = default;
};

/// "view 5, tile (2, 1)" and "view 5, tile (2, 1), bin 0".
std::ostream& operator<<(std::ostream& out, const Tile& tile);
std::ostream& operator<<(std::ostream& out, const Cell& cell);

} // namespace dirt
