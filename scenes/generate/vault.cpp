#include "scenes/generate/vault.h"

#include <cmath>
#include <numbers>

#include "scenes/generate/sweep.h"

namespace dirt::generate {

Mesh makeGroinVault(const Detail& detail, int material, double halfWidth, double rise) {
    Mesh mesh(detail);
    Mesh web(detail);
    const auto surface = [&](double u, double v) -> SurfacePoint {
        // Both barrels have the same section, so they meet above the diagonals: |x| = z.
        const double edge = v * std::numbers::pi / 2;
        const double angle = (2 * u - 1) * edge;
        const double x = halfWidth * std::sin(angle);
        const double z = halfWidth * std::sin(edge);
        return {{x, rise * std::cos(angle), z}, {angle * halfWidth, z}};
    };
    web.addPatch(material, detail.steps(22, 2), detail.steps(11, 1), surface);
    for (int k = 0; k < 4; ++k) {
        mesh.append(web, place({0, 0, 0}, 90.0 * k), {0.5 * k, 0.25 * k});
    }
    return mesh;
}

Mesh makeRib(const Detail& detail, int material, double halfSpan, double rise, double width) {
    Mesh mesh(detail);
    Profile section({0.16, -width / 2});
    section.line({0, -width / 2}).line({0, width / 2}).line({0.16, width / 2});
    const auto path = [&](double u) -> PathFrame {
        const double angle = std::numbers::pi * u;
        const Vec3 radial(-std::cos(angle), std::sin(angle), 0);
        return {{(halfSpan - 0.1) * radial.x, (rise - 0.1) * radial.y, 0},
                radial,
                {0, 0, 1},
                angle * halfSpan};
    };
    addSweep(mesh, material, section, path, detail.steps(36, 4));
    return mesh;
}

} // namespace dirt::generate
