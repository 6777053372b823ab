#include "scenes/generate/arch.h"

#include <cmath>

#include "scenes/generate/block.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"

namespace dirt::generate {
namespace {

constexpr double ringWidth = 0.24; // of the voussoirs, relative to the radius

/// Section of a voussoir, from the wall's back over the soffit to its front: (radial, z).
Profile voussoirProfile(const Detail& detail, const ArchShape& shape) {
    const double w = ringWidth * shape.radius;
    const double face = shape.thickness / 2;
    if (!detail.shows(0.115)) {
        Profile plain({w, -face - 0.01});
        plain.line({0, -face - 0.01}).line({0, face + 0.03}).line({w, face + 0.03});
        return plain;
    }
    Profile profile({w, -face + 0.01});
    profile.line({w, -face - 0.025}).line({0, -face - 0.025});
    profile.line({0, face + 0.02});
    if (detail.shows(0.315)) {
        profile.line({0.36 * w, face + 0.02})
            .line({0.38 * w, face + 0.04})
            .line({0.66 * w, face + 0.04})
            .cyma({0.9 * w, face + 0.085}, -0.4)
            .line({w, face + 0.085});
    } else {
        profile.line({w, face + 0.05});
    }
    profile.line({w, face - 0.01});
    return profile;
}

void addVoussoirs(Mesh& mesh, const ArchShape& shape) {
    const Profile profile = voussoirProfile(mesh.detail(), shape);
    const bool pillowed = mesh.detail().shows(0.325);
    int count = shape.voussoirs;
    if (!mesh.detail().shows(0.185)) {
        count = mesh.detail().shows(0.13) ? shape.voussoirs / 2 | 1 : 5;
    }
    const int body = mesh.detail().steps(1);
    const int steps = pillowed ? body + 2 : body;
    for (int k = 0; k < count; ++k) {
        const double begin = pi * k / count;
        const double end = pi * (k + 1) / count;
        const double bevel = 0.009 / shape.radius;
        const auto path = [&](double u) -> PathFrame {
            const int column = static_cast<int>(std::lround(u * steps));
            double angle = begin + (end - begin) * u;
            double recess = 0;
            if (pillowed) {
                const double s = std::clamp((column - 1.0) / body, 0.0, 1.0);
                angle = begin + bevel + (end - begin - 2 * bevel) * s;
                if (column == 0 || column == steps) {
                    angle = column == 0 ? begin : end;
                    recess = 0.012;
                }
            }
            const Vec3 radial(-std::cos(angle), std::sin(angle), 0);
            // The joints lie a little deeper than the stones: seen as a groove around each.
            return {radial * (shape.radius + recess), radial, Vec3(0, 0, 1 - 2 * recess),
                    angle * shape.radius + 0.77 * k};
        };
        addSweep(mesh, k % 2 == 0 ? shape.stoneMaterial : shape.otherStoneMaterial, profile, path,
                 steps);
    }
}

/// The keystone, which stands out from the ring on both sides.
void addKeystone(Mesh& mesh, const ArchShape& shape) {
    const double w = ringWidth * shape.radius;
    const double x = 0.105 * shape.radius;
    const double z = shape.thickness / 2 + 0.12;
    const double y = shape.radius - 0.02;
    addBlock(mesh, shape.stoneMaterial, {-x, y, -z}, {x, y + w + 0.08, z}, 0.012);
}

/// A disc of coloured stone in a moulded ring, where two arches meet.
void addDisc(Mesh& mesh, const ArchShape& shape, int material, double x) {
    const double radius = 0.2 * shape.radius;
    Mesh disc(mesh.detail());
    Profile ring({radius, 0.0});
    ring.bow({radius * 0.8, 0.045}, 0.3).line({radius * 0.76, 0.01});
    addLathe(disc, shape.stoneMaterial, ring, mesh.detail().steps(48, 6));
    Profile field({radius * 0.76, 0.012});
    field.spline({{radius * 0.4, 0.035}, {0, 0.045}});
    addLathe(disc, material, field, mesh.detail().steps(40, 6));
    const Transform toWall(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1); // y becomes z
    mesh.append(disc, place({x, 0.86 * shape.radius, shape.thickness / 2}) * toWall);
}

} // namespace

void addSpandrel(Mesh& mesh, int material, double radius, double halfWidth, double top, double z,
                 bool facingBack) {
    const double corner = std::atan2(top, halfWidth);
    const double begin[3] = {0, corner, pi - corner};
    const double end[3] = {corner, pi - corner, pi};
    for (int zone = 0; zone < 3; ++zone) {
        const auto surface = [&](double u, double v) -> SurfacePoint {
            const double angle = begin[zone] + (end[zone] - begin[zone]) * u;
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            const Vec2 inner = Vec2(c, s) * radius;
            const Vec2 outer = zone == 1   ? Vec2(c / s * top, top)
                               : zone == 0 ? Vec2(halfWidth, s / c * halfWidth)
                                           : Vec2(-halfWidth, -s / c * halfWidth);
            const Vec2 p = inner + (outer - inner) * v;
            return {{p.x, p.y, z}, p};
        };
        mesh.addPatch(material, mesh.detail().steps(zone == 1 ? 8 : 4, zone == 1 ? 2 : 1),
                      mesh.detail().steps(1), surface, {.flip = !facingBack});
    }
}

std::function<PathFrame(double)> archPath(double radius, double foot, int steps) {
    const double arc = pi * radius;
    const double jamb = 1.0 / steps;
    return [=](double u) -> PathFrame {
        if (u < jamb * 0.5) {
            return {{-radius, -foot, 0}, {-1, 0, 0}, {0, 0, 1}, 0};
        }
        if (u > 1 - jamb * 0.5) {
            return {{radius, -foot, 0}, {1, 0, 0}, {0, 0, 1}, 2 * foot + arc};
        }
        const double angle = pi * (u - jamb) / (1 - 2 * jamb);
        const Vec3 radial(-std::cos(angle), std::sin(angle), 0);
        return {radial * radius, radial, {0, 0, 1}, foot + angle * radius};
    };
}

Mesh makeArchBay(const Detail& detail, const ArchShape& shape, int discMaterial) {
    Mesh mesh(detail);
    // The wall ends under the ring of voussoirs.
    const double wallRadius = shape.radius * (1 + 0.5 * ringWidth);
    addSpandrel(mesh, shape.wallMaterial, wallRadius, shape.halfWidth, shape.top,
                shape.thickness / 2);
    addSpandrel(mesh, shape.wallMaterial, wallRadius, shape.halfWidth, shape.top,
                -shape.thickness / 2, true);
    addVoussoirs(mesh, shape);
    if (detail.shows(0.1)) {
        addKeystone(mesh, shape);
    }
    if (detail.shows(0.16)) {
        addDisc(mesh, shape, discMaterial, shape.halfWidth);
    }
    return mesh;
}

} // namespace dirt::generate
