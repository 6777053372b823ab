// What propose_tiles.geom draws to propose tiles where rasterization is conservative: a triangle
// itself, or a half of its rectangle of tiles.

const int kWhole = 0, kFirstHalf = 1, kSecondHalf = 2;
