// How near coverage and clip come to the bounds derived in coverage.cpp and clip.cpp.

#include "core/base/exact_sum.h"
#include "core/grid/clip.h"
#include "shaders/shared/margins.h"
#include "tests/bounds/climb.h"
#include "tests/support/corner_triangles.h"

#include <algorithm>

namespace dirt::test {
namespace {

/// As fine as a view may be, with borders that are no floats.
constexpr int kTiles = kMaxTiles - 1;
const View& finestFace() {
    static const ViewSet set = fullViews(kTiles, 1);
    return set.views[4]; // its frame is the grid's
}
constexpr double kTile = 2.0 / kTiles;
double lowBorder(int tile) {
    return tile * kTile - 1.0 - kGuardBand * kTile;
}
double highBorder(int tile) {
    return (tile + 1) * kTile - 1.0 + kGuardBand * kTile;
}

Triangle triangleAt(const Numbers<9>& x) {
    return {vectorAt(x, 0), vectorAt(x, 1), vectorAt(x, 2)};
}
Numbers<9> numbersOf(const Triangle& t) {
    return {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
}

/// For a decision of which the exact value is \p inside (negative: outside), in units of a bound:
/// how much of the bound it shows to be used.
double scoreOf(bool decidedInside, double inside) {
    return decidedInside == (inside >= 0.0) ? -std::abs(inside) : std::abs(inside);
}

/// A side plane moves by less than 3 u S. x and w of a point, and the place of its tile.
TEST(Bounds, SidePlanes) {
    expectHeld(
        Bound<3>{"side plane of a tile: 3 u S of slope",
                 0.44,
                 {{0x1.039734p-4f, 0x1.138938p-4f, 0x1.f13644p-1f}},
                 [](Random& random) {
                     const int tile = random.below(kTiles);
                     const double w = random.uniform(0.01, 2);
                     const double s = random.pick({lowBorder(tile), highBorder(tile)});
                     return Numbers<3>{(float) (s * w), (float) w, (float) ((tile + 0.5) / kTiles)};
                 },
                 [](const Numbers<3>& in) {
                     const auto [x, w, place] = in;
                     if (!(w > 1e-6f && w < 2.0f && place >= 0.0f && place < 1.0f))
                         return -HUGE_VAL;
                     const int column = (int) (place * (float) kTiles);
                     const glm::vec3 point(x, 0.0f, w);
                     ViewTriangle setup;
                     if (!setUpTriangle({point, point, point}, finestFace(), setup))
                         return -HUGE_VAL;
                     const bool inside = overlaps(setup, finestFace(), column, kTiles / 2);
                     const double low = x / (double) w - lowBorder(column);
                     const double high = highBorder(column) - x / (double) w;
                     return scoreOf(inside, std::min(low, high) / (3 * u));
                 }});
}

/// An edge plane's value at a corner is that of a corner 6 u S away at most.
TEST(Bounds, EdgePlanes) {
    constexpr int kAt = kTiles - 3;
    expectHeld(Bound<9>{
        "edge plane at a tile's corner: 6 u S of slope",
        0.54,
        {{0x1.21e1f6p-4f, 0x1.53fde8p-2f, 0x1.b0bdd6p-3f, 0x1.b4752ap-1f, 0x1.c04f4cp-3f,
          0x1.065bc2p-1f, -0x1.000004p-18f, 0x1.769604p-28f, 0x1.b7f6ccp-17f}},
        [](Random& random) {
            const double s = random.pick({lowBorder(kAt), highBorder(kAt)});
            const double t = random.pick({lowBorder(kAt), highBorder(kAt)});
            const double w0 = random.uniform(0.1, 1), w1 = random.uniform(0.1, 1);
            const double dx = random.uniform(-1, 1), dy = random.uniform(-1, 1);
            return numbersOf(
                {glm::vec3((s + dx) * w0, (t + dy) * w0, w0),
                 glm::vec3((s - dx) * w1, (t - dy) * w1, w1),
                 glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1))});
        },
        [](const Numbers<9>& in) {
            ViewTriangle setup;
            const Triangle triangle = triangleAt(in);
            if (!setUpTriangle(triangle, finestFace(), setup) || setup.edgeOn()) return -HUGE_VAL;
            const bool inside = !edgesSeparate(setup, finestFace(), kAt, kAt);
            const ExactTriangle exact(triangle, finestFace());
            double least = HUGE_VAL;
            for (const IntegerVector& n : exact.edges) {
                const int side = sign(exact.volume);
                const Integer nx = n.x * side, ny = n.y * side, nz = n.z * side;
                const double s = nx > 0 ? highBorder(kAt) : lowBorder(kAt);
                const double t = ny > 0 ? highBorder(kAt) : lowBorder(kAt);
                const Integer value = nx * toInteger(s, -60) + ny * toInteger(t, -60) + (nz << 60);
                const double size = toDouble(abs(nx)) + toDouble(abs(ny));
                if (size == 0.0) return -HUGE_VAL;
                least = std::min(least, toDouble(value, -60) / size);
            }
            return scoreOf(inside, least / (6 * u));
        }});
}

/// Small, around a direction, so that the volume is a small part of its terms.
Numbers<9> smallTriangle(Random& random, double s, double t) {
    const double size = std::exp2(random.uniform(-16, -10)), w = random.uniform(0.5, 1.5);
    const auto vertex = [&] {
        const double z = w * (1.0 + size * random.uniform(-1, 1));
        return glm::vec3((s + size * random.uniform(-1, 1)) * z,
                         (t + size * random.uniform(-1, 1)) * z, z);
    };
    return numbersOf({vertex(), vertex(), vertex()});
}

/// What double gives is off by 2.5 * 2^-53 of the terms where they cancel, and these are at most
/// 2^26 times as large.
TEST(Bounds, Orientation) {
    expectHeld(Bound<9>{
        "a . (b x c): 2.5 * 2^-27",
        0.55,
        {{-0x1.3cc5ap-3f, 0x1.09aba6p-2f, 0x1.519b34p-1f, 0x1.000002p-1f, 0x1.09a8c2p-2f,
          0x1.5196d4p-1f, 0x1.f8a172p-8f, 0x1.09ad1p-2f, 0x1.519cd4p-1f},
         // in doubt, and so exact; double would be wrong by more than the bound
         {0x1.7dfcbap-3f, 0x1.4c52e8p-2f, 0x1.66c3eap+0f, -0x1.5de3ap-4f, 0x1.ee4dc8p+3f,
          0x1.ffffccp-4f, 0x1.7df124p-3f, 0x1.4a63aep-2f, 0x1.66b312p+0f}},
        [](Random& random) {
            return smallTriangle(random, random.uniform(-1, 1), random.uniform(-1, 1));
        },
        [](const Numbers<9>& in) {
            ViewTriangle setup;
            const Triangle triangle = triangleAt(in);
            if (!setUpTriangle(triangle, finestFace(), setup)) return -HUGE_VAL;
            const ExactTriangle exact(triangle, finestFace());
            if (exact.volume == 0) return setup.edgeOn() ? 0.0 : 2.0;
            const int unit = std::min(3 * exact.exponent, lowestExponent(setup.determinant));
            const Integer value = exact.volume << (3 * exact.exponent - unit);
            const Integer off = abs(toInteger(setup.determinant, unit) - value);
            return toDouble(off) / toDouble(abs(value)) / (2.5 * 0x1p-27);
        }});
}

/// n . (s, t, 1), as clip.cpp has it.
double edgeAtCorner(const ViewTriangle& triangle, size_t k, float s, float t) {
    const glm::dvec3 n = triangle.normals[k] * glm::dvec3(s, t, 1.0);
    const double value = (n.x + n.y) + n.z;
    if (std::abs(value) > kSignDoubt * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z)))
        return value;
    return tripleProductExact({s, t, 1.0f}, triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
}

/// The depth at which a corner ray meets the triangle, before it is rounded: the orientation is
/// good for 2.5 * 2^-27, each of three edges for 2 * 2^-27.
TEST(Bounds, DepthsAtCorners) {
    static const float s = finestFace().sHi[6000], t = finestFace().tLo[5000];
    expectHeld(Bound<9>{
        "depth at a corner of a tile: 4.5 * 2^-27",
        0.48,
        {{0x1.072d56p-2f, 0x1.f3b432p-4f, 0x1.1be006p-1f, 0x1.ffc566p-3f, 0x1.fffff4p-5f,
          -0x1.323e4ap+5f, 0x1.0727dap-2f, 0x1.f422ap-4f, 0x1.44ab9ep-1f}},
        [](Random& random) { return smallTriangle(random, s, t); },
        [](const Numbers<9>& in) {
            ViewTriangle setup;
            const Triangle triangle = triangleAt(in);
            if (!setUpTriangle(triangle, finestFace(), setup) || setup.edgeOn()) return -HUGE_VAL;
            const ExactTriangle exact(triangle, finestFace());
            const IntegerVector corner = toIntegers({s, t, 1.0f}, -30);
            double sum = 0.0;
            Integer exactSum = 0;
            for (size_t k = 0; k < 3; ++k) {
                const Integer value = dot(exact.edges[k], corner);
                if (sign(value) * sign(exact.volume) < 0) return -HUGE_VAL; // beside it
                exactSum += value;
                sum += edgeAtCorner(setup, k, s, t);
            }
            if (exactSum == 0) return -HUGE_VAL;
            const Fraction depth{abs(exact.volume), abs(exactSum), exact.exponent + 30};
            return std::abs(setup.determinant / sum / depth.value() - 1.0) / (4.5 * 0x1p-27);
        }});
}

} // namespace
} // namespace dirt::test
