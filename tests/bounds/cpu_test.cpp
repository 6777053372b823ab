// How near the CPU backend's own bounds are come to: the boxes of its leaves and its light grid.

#include "backend_cpu/light/light_raster.h"
#include "backend_cpu/trace/leaf_boxes.h"
#include "backend_cpu/trace/leaf_test-inl.h"
#include "backend_cpu/trace/tile_walk-inl.h"
#include "core/verify/exact_number.h"
#include "shaders/shared/margins.h"
#include "tests/bounds/climb.h"
#include "tests/support/views.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace dirt::test {
namespace {

/// What of kCellSlack a depth of a bin needs to be in the box of the bin's cell. The tile's bounds,
/// the bin, and the depth's distance from the bin's border.
TEST(Bounds, EndsOfCells) {
    constexpr int kBins = 256;
    static Grid grid = [] {
        ViewSet set = fullViews(1, 1);
        set.settings.bins = kBins;
        return makeEmptyGrid(set.camera, set.settings);
    }();
    expectHeld(Bound<4>{
        "end of a cell: 7 u of the far depth",
        0.51,
        {{0x1.4138ap-6f, 0x1.5fffb2p-1f, 0x1.e58eaap-1f, 0x1.b9ad8ap-1f}},
        [](Random& random) {
            return Numbers<4>{(float) random.uniform(0.01, 1), (float) random.uniform(1, 2),
                              (float) random.uniform(0.01, 1), (float) random.uniform(-1, 1)};
        },
        [](const Numbers<4>& in) {
            const auto [near, far, place, beside] = in;
            if (!(near > 0.0f && near < far && far < 4.0f && place > 0.0f && place < 1.0f))
                return -HUGE_VAL;
            DepthBounds& bounds = grid.pyramids[4].levels[0].bounds[0];
            bounds = {near, far};
            const double border = near + std::floor(place * kBins) * ((double) far - near) / kBins;
            const float w = (float) (border + std::remainder(beside, 1.0f) * 16 * u * far);
            if (w < near || w > far) return -HUGE_VAL;
            const LeafBox box = boxOfCell(grid, 4, 0, BinMap(bounds, kBins)(w));
            // Sides that are the tile's own have no slack.
            double score = -HUGE_VAL;
            const double slack = kCellSlack * far;
            if (box.low.z > near) score = slack - ((double) w - box.low.z);
            if (box.high.z < far) score = std::max(score, slack - ((double) box.high.z - w));
            return score / (7 * u * far);
        }});
}

/// Where a ray enters a box by the plane of one axis: origin and direction along it, the box's
/// origin, steps to the plane and their size.
TEST(Bounds, PlanesOfBoxes) {
    expectHeld(Bound<5>{
        "plane of a box: 4 u (6 + |o|) of length",
        0.78,
        {{-0x1.b01276p+2f, 0x1.f7bb1ep-1f, 0x1.cee9p+0f, 0x1.ffab86p+5f, 0x1.3e223p-11f}},
        [](Random& random) {
            return Numbers<5>{(float) random.uniform(-4, 4), (float) random.uniform(0.2, 1),
                              (float) random.uniform(-2, 2), (float) random.range(1, 254),
                              (float) random.powerOfTwo(-12, -7)};
        },
        [](const Numbers<5>& in) {
            const auto [o, d, base, steps, size] = in;
            const int q = (int) steps, exponent = std::ilogb(size);
            const double plane = base + q * std::ldexp(1.0, exponent);
            if (!(q >= 0 && q < 255 && exponent > -20 && std::abs(base) < 2.0f && plane < 2.0 &&
                  plane > -2.0 && std::abs(o) < 8.0f && d > 0.01f && d <= 1.0f))
                return -HUGE_VAL;
            HWY_NAMESPACE::LeafRay ray;
            ray.set({{o, 0.0f, 0.0f}, {d, 0.0f, 1.0f}, kNoPrimitive});
            ray.setPart(-1e6, 1e6);
            LeafBoxes node{};
            node.children = 1;
            node.origin[0] = base, node.origin[1] = node.origin[2] = -2.0f;
            for (uint8_t& e : node.exponent) e = (uint8_t) (127 - 5);
            node.exponent[0] = (uint8_t) (127 + exponent);
            node.bound[0][0][0] = (uint8_t) q, node.bound[1][0][0] = 255;
            node.bound[1][1][0] = node.bound[1][2][0] = 255;
            // Along y and z the box begins far behind.
            node.origin[1] = node.origin[2] = -1000.0f;
            HWY_ALIGN float entry[LeafBoxes::kChildren];
            HWY_NAMESPACE::childrenMet(ray, node, entry);
            const double exact = (plane - o) / d;
            const double off = std::abs(entry[0] + (double) ray.pad[0] - exact) * d;
            return off / (4 * u * (6.0 + std::abs(o)));
        }});
}

/// Where SIMD's walk leaves a tile by the border s, which it moves by kVisitSlack: four roundings,
/// and one of that. x and w of the origin and of the direction, s.
TEST(Bounds, CrossingsOfTheTracedWalk) {
    expectHeld(Bound<5>{
        "t where SIMD leaves a tile: 5 * 2^-53",
        0.82,
        {{-0x1.266d02p-8f, 0x1.9840aap-8f, 0x1.fff74p-2f, 0x1.000004p-2f, -0x1.7dd77ap-7f}},
        [](Random& random) {
            Numbers<5> in;
            for (float& x : in) x = (float) random.uniform(-1, 1);
            in[1] = (float) random.uniform(1, 2);
            return in;
        },
        [](const Numbers<5>& in) {
            const auto [x, w, dx, dw, s] = in;
            const float columns[2] = {-1.0f, s}, rows[2] = {-1.0f, 1.0f};
            if (!(w > 0.0f && w < 4.0f && x > -w && x < s * w && std::abs(s) < 1.0f))
                return -HUGE_VAL;
            TileDepths depths({0.0f, FLT_MAX});
            depths.occupied = ~0u;
            const TracedView view{{1, 1}, {columns, rows}, {0.0, 0.0}, &depths};
            const HWY_NAMESPACE::ViewPart part{{x, 0.0}, {dx, 0.0}, w, dw, 0.0, INFINITY, w, 0};
            double end = INFINITY;
            uint64_t steps = 0;
            HWY_NAMESPACE::walkTiles(view, part, end, steps,
                                     [&](const HWY_NAMESPACE::Visit& visit) { end = visit.end; });
            int unit = std::min(0, lowestExponent(s));
            for (const float number : {x, w, dx, dw})
                unit = std::min(unit, lowestExponent(s) + lowestExponent(number));
            const auto integer = [&](double number) { return toInteger(number, unit); };
            const Integer n = integer((double) s * w) - integer(x);
            const Integer m = integer(dx) - integer((double) s * dw);
            if (n <= 0 || m <= 0 || !std::isfinite(end)) return -HUGE_VAL;
            const int least = std::min(0, lowestExponent(end));
            const Fraction off{toInteger(end, least) * m - (n << -least), n << -least, 0};
            if (std::abs(off.value()) > 0x1p-40) return -HUGE_VAL; // left by the other border
            if (off.numerator <= 0) return 2.0;                    // not even the exact one
            return std::abs(off.value() - kVisitSlack) / (5 * v);
        }});
}

/// Differences from the light, a triangle: what double makes of its planes.
Numbers<12> fromLight(Random& random) {
    Numbers<12> in;
    for (float& x : in) x = (float) random.uniform(-1, 1);
    for (size_t i = 0; i < 12; ++i)
        if (random.chance(0.3)) in[i] *= (float) random.powerOfTwo(-30, 0); // differences round
    return in;
}
struct ExactLight {
    int unit;
    IntegerVector a, b, c, normal;

    explicit ExactLight(const Numbers<12>& in) {
        unit = 0;
        for (size_t i = 0; i < 4; ++i) unit = std::min(unit, lowestExponent(vectorAt(in, i)));
        const IntegerVector light = toIntegers(vectorAt(in, 0), unit);
        a = toIntegers(vectorAt(in, 1), unit) - light;
        b = toIntegers(vectorAt(in, 2), unit) - light;
        c = toIntegers(vectorAt(in, 3), unit) - light;
        normal = cross(b - a, c - a);
    }
};
double distance(double f, const Integer& exact, int exponent) {
    const int unit = f == 0.0 ? exponent : std::min(exponent, lowestExponent(f));
    return toDouble(abs(toInteger(f, unit) - (exact << (exponent - unit))), unit);
}
bool isWalkCase(const Numbers<12>& in) {
    return std::all_of(in.begin(), in.end(), [](float x) { return std::abs(x) < 4.0f; });
}
LightTriangle seenFrom(const Numbers<12>& in) {
    return {{vectorAt(in, 1), vectorAt(in, 2), vectorAt(in, 3)}, vectorAt(in, 0)};
}

TEST(Bounds, PlanesThroughTheLight) {
    expectHeld(Bound<12>{"light: normal of an edge, 8 * 2^-53 of size^2",
                         0.63,
                         {{0x1.000008p-74f, 0x1.c72c9cp-33f, 0x1.33efa8p-3f, -0x1.000002p-47f,
                           -0x1.1ced3ap-59f, 0x1.bf9a66p-34f, 0x1.dc24d8p-50f, 0x1.6ffb6ep-2f,
                           -0x1.954d3ep-3f, 0x1p-60f, 0x1.6fee06p-2f, 0x1.ffef14p-2f}},
                         fromLight,
                         [](const Numbers<12>& in) {
                             if (!isWalkCase(in)) return -HUGE_VAL;
                             const LightTriangle seen = seenFrom(in);
                             const ExactLight exact(in);
                             const Integer nx = exact.b.y * exact.c.z - exact.b.z * exact.c.y;
                             return distance(seen.edges[0].x, nx, 2 * exact.unit) /
                                    (8 * v * seen.size * seen.size);
                         }});
}

TEST(Bounds, OrientationFromTheLight) {
    expectHeld(Bound<12>{
        "light: determinant, 24 and 4 * 2^-53",
        0.25,
        {{0x1.307facp-5f, 0x1.000002p-5f, 0x1.00003ep+0f, -0x1.c197aep-23f, -0x1.f7507ap-3f,
          -0x1.e9d356p-30f, 0x1.d311f6p-2f, -0x1.93d876p-1f, 0x1.651242p-30f, 0x1.000002p-1f,
          0x1.2a41dep-2f, 0x1.36d1f2p-33f}},
        fromLight,
        [](const Numbers<12>& in) {
            if (!isWalkCase(in)) return -HUGE_VAL;
            const LightTriangle seen = seenFrom(in);
            const ExactLight exact(in);
            const double sum =
                std::abs(seen.normal.x) + std::abs(seen.normal.y) + std::abs(seen.normal.z);
            const double bound = (24 * seen.length * seen.length + 4 * sum) * v * seen.size;
            if (!(bound > 0.0)) return -HUGE_VAL;
            return distance(seen.determinant, dot(exact.a, exact.normal), 3 * exact.unit) / bound;
        }});
}

/// The place at which a ray is looked up: as LightRay forms it of its origin. Light and origin
/// along one axis, and along that of the largest component.
TEST(Bounds, PlacesOfRays) {
    expectHeld(Bound<4>{
        "light: place of a ray, 3 of 2^-23",
        0.65,
        {{-0x1.01bfd8p-1f, 0x1.000002p-1f, -0x1.e015ap-2f, 0x1.140376p-1f}},
        [](Random& random) {
            return Numbers<4>{(float) random.uniform(-1, 1), (float) random.uniform(-1, 1),
                              (float) random.uniform(-1, 1), (float) random.uniform(-1, 1)};
        },
        [](const Numbers<4>& in) {
            const auto [lx, ox, lw, ow] = in;
            const float px = ox - lx, pw = ow - lw, distance = std::abs(pw);
            if (!(std::abs(px) <= distance && distance > 1e-3f && distance < 1e3f))
                return -HUGE_VAL;
            const float r = 1.0f / distance;
            const double place = (px * r + 1.0f) * (float) kPlacesPerSlope;
            const double exact = ((double) ox - lx) / std::abs((double) ow - lw) + 1.0;
            return std::abs(place - exact * kPlacesPerSlope) / 3.0;
        }});
}

} // namespace
} // namespace dirt::test
