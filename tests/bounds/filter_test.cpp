// How near the filter before the intersection comes to the bounds derived in ray_filter.h.

#include "core/trace/ray_filter.h"
#include "tests/bounds/meeting.h"
#include "tests/support/exact_point.h"

namespace dirt::test {
namespace {

/// Where the ray is seen as an axis: lateral coordinates of the vertices, exactly, and what the
/// filter compares them with.
struct Lateral {
    double x[3], y[3], n, largest = 0.0;

    explicit Lateral(const Meeting& in) {
        const Ray ray = rayOf(in);
        const Triangle t = triangleOf(in);
        const glm::vec3 d = glm::abs(ray.direction);
        const int z = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
        const ExactRay exact(ray);
        const auto part = [](const IntegerVector& p, int axis) {
            return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
        };
        const int unit = std::min({lowestExponent(ray.origin), lowestExponent(t.a),
                                   lowestExponent(t.b), lowestExponent(t.c), 0});
        const IntegerVector o = toIntegers(ray.origin, unit);
        const IntegerVector& dir = exact.direction;
        int k = 0;
        for (const glm::vec3& vertex : {t.a, t.b, t.c}) {
            const IntegerVector p = toIntegers(vertex, unit) - o;
            const auto lateral = [&](int axis) {
                const Integer value = part(p, axis) * part(dir, z) - part(dir, axis) * part(p, z);
                return toDouble(value, unit) / toDouble(part(dir, z));
            };
            x[k] = lateral((z + 1) % 3), y[k] = lateral((z + 2) % 3);
            largest = std::max({largest, std::abs(x[k]), std::abs(y[k])});
            ++k;
        }
        n = extent(t) + maxNorm(ray.origin);
    }
    static double extent(const Triangle& t) {
        return std::max({maxNorm(t.a), maxNorm(t.b), maxNorm(t.c)});
    }
};

/// Refused where the exact coordinates are nearer than the error allows: what is missing is used.
TEST(Bounds, LateralCoordinates) {
    expectHeld(Bound<15>{
        "lateral coordinate in the filter: 5 u N",
        0.39,
        {{-0x1.35a7a4p-1f, -0x1.928f6ap-1f, -0x1.6c4e02p-1f, 0x1.10c87cp+0f, 0x1.f1a466p-1f,
          0x1.0b1f12p+0f, 0x1.d7d304p-2f, 0x1.7c54b2p-3f, 0x1.53e08p-2f, 0x1p-36f, -0x1.62c58ap-38f,
          -0x1.140e2cp-47f, -0x1.08f9b2p-14f, 0x1.000004p-30f, -0x1.61369ep-45f}},
        [](Random& random) { return meeting(random, 0x1p-19, 0.5); },
        [](const Meeting& in) {
            if (!isCase(in)) return -HUGE_VAL;
            const Triangle t = triangleOf(in);
            const Triangle point{t.a, t.a, t.a}; // no area, no edges
            const Ray ray = rayOf(in);
            Meeting one = in;
            for (size_t i = 9; i < 15; ++i) one[i] = in[i - 3 - (i >= 12 ? 3 : 0)];
            const Lateral lateral(one);
            const bool refused =
                RayFilter(ray, (float) Lateral::extent(point)).certainlyMisses(point);
            const double allowed = kLateralError * lateral.n;
            const double beside = std::max(std::abs(lateral.x[0]), std::abs(lateral.y[0]));
            return (refused ? allowed - beside : beside - allowed) / (5 * u * lateral.n);
        }});
}

/// Refused by the areas where the exact ones are not as mixed as that, or the reverse.
TEST(Bounds, LateralAreas) {
    expectHeld(Bound<15>{
        "area in the filter: 30 u N L",
        0.26,
        {{-0x1.07e43p+0f, -0x1.0c2a3ep+0f, -0x1.074b14p+0f, 0x1.049386p+1f, 0x1.062994p+1f,
          0x1.0139fp+1f, 0x1.f67f0ap-1f, 0x1.fa00ap-1f, 0x1.f6549cp-1f, 0x1.074632p+0f,
          0x1.035198p+0f, 0x1.f64e7cp-1f, 0x1.fd3c32p-1f, 0x1.ffb48ep-1f, 0x1.ef768ep-1f}},
        [](Random& random) {
            // From corner to corner of a cube, at an edge of a triangle there.
            Meeting in;
            const double size = std::exp2(random.uniform(-12, -2));
            for (size_t i = 0; i < 3; ++i) {
                in[i] = -(float) random.uniform(1, 1.1);
                for (size_t k = 6; k < 15; k += 3)
                    in[k + i] = (float) (1.0 + size * random.uniform(-1, 1));
                in[3 + i] = (in[6 + i] + in[9 + i]) * 0.5f - in[i];
            }
            return in;
        },
        [](const Meeting& in) {
            if (!isCase(in)) return -HUGE_VAL;
            const Triangle t = triangleOf(in);
            const Lateral l(in);
            const double allowed = kLateralError * l.n, wide = 2.0 * allowed;
            for (const auto& x : {l.x, l.y})
                if (std::min({x[0], x[1], x[2]}) > -wide || std::max({x[0], x[1], x[2]}) < wide)
                    return -HUGE_VAL; // or nearly so by the coordinates alone
            const double areas[3] = {l.x[1] * l.y[2] - l.y[1] * l.x[2],
                                     l.x[2] * l.y[0] - l.y[2] * l.x[0],
                                     l.x[0] * l.y[1] - l.y[0] * l.x[1]};
            const double mixed = std::min(std::max({areas[0], areas[1], areas[2]}),
                                          -std::min({areas[0], areas[1], areas[2]}));
            const double beyond = mixed - 4.0 * allowed * l.largest;
            const bool refused =
                RayFilter(rayOf(in), (float) Lateral::extent(t)).certainlyMisses(t);
            return (refused == (beyond > 0.0) ? -std::abs(beyond) : std::abs(beyond)) /
                   (30 * u * l.n * l.largest);
        }});
}

} // namespace
} // namespace dirt::test
