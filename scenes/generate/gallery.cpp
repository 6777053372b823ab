#include "scenes/generate/gallery.h"

#include <cmath>

#include "scenes/generate/arch.h"
#include "scenes/generate/atrium_materials.h"
#include "scenes/generate/block.h"
#include "scenes/generate/numbers.h"

namespace dirt::generate {
namespace {

/// Where a bay's opening lies.
struct Opening {
    double radius;
    double sill;
    double springing;
    double depth;
};

void addRectangle(Mesh& mesh, int material, double x0, double x1, double y0, double y1) {
    const int columns = mesh.detail().steps(2);
    const int rows = mesh.detail().steps(2);
    mesh.addPatch(material, columns, rows, [=](double u, double v) {
        const Vec2 p(x0 + (x1 - x0) * u, y0 + (y1 - y0) * v);
        return SurfacePoint{{p.x, p.y, 0}, p};
    });
}

/// The wall's face around the opening, and the mouldings that frame it.
void addFrame(Mesh& mesh, const Opening& opening, double halfWidth, double height) {
    const double r = opening.radius;
    Mesh above(mesh.detail());
    addSpandrel(above, Plaster, r, halfWidth, height - opening.springing, 0);
    mesh.append(above, place({0, opening.springing, 0}), {0, opening.springing});
    addRectangle(mesh, Plaster, r, halfWidth, opening.sill, opening.springing);
    addRectangle(mesh, Plaster, -halfWidth, -r, opening.sill, opening.springing);
    if (opening.sill > 0) {
        addRectangle(mesh, Plaster, -halfWidth, halfWidth, 0, opening.sill);
        addBlock(mesh, Limestone, {-r - 0.22, opening.sill - 0.1, -opening.depth},
                 {r + 0.22, opening.sill, 0.14}, 0.012);
    }
    if (opening.sill <= 0) {
        // The threshold.
        addBlock(mesh, RedMarble, {-r, -0.1, -opening.depth}, {r, 0.012, 0.02}, 0.006);
    }
    Profile section({0, -opening.depth});
    section.line({0, 0.05});
    if (mesh.detail().shows(0.26)) {
        section.line({0.08, 0.05}).line({0.09, 0.07}).cyma({0.16, 0.10}, -0.4);
    }
    section.line({0.18, 0.10}).line({0.18, -0.01});
    Mesh moulding(mesh.detail());
    const int steps = mesh.detail().steps(40, 5);
    addSweep(moulding, Limestone, section, archPath(r, opening.springing - opening.sill, steps),
             steps);
    mesh.append(moulding, place({0, opening.springing, 0}));
}

/// A half cylinder under a quarter sphere, ribbed like a shell.
void addNicheHollow(Mesh& mesh, const Opening& opening) {
    const double r = opening.radius;
    const int around = mesh.detail().steps(30, 4);
    mesh.addPatch(Limestone, around, mesh.detail().steps(3), [&](double u, double v) {
        const double angle = pi * u;
        const double y = opening.sill + (opening.springing - opening.sill) * v;
        return SurfacePoint{{-r * std::cos(angle), y, -0.05 - r * std::sin(angle)}, {angle * r, y}};
    });
    mesh.addPatch(
        Limestone, mesh.detail().shows(0.36) ? 2 * around : around, mesh.detail().steps(8, 3),
        [&](double u, double v) {
            const double angle = pi * u;
            const double polar = 0.5 * pi * v;
            const double rib = 1 - 0.05 * std::abs(std::sin(9 * angle)) * std::sin(2 * polar);
            const double ring = r * std::cos(polar) * rib;
            return SurfacePoint{{-ring * std::cos(angle), opening.springing + r * std::sin(polar),
                                 -0.05 - ring * std::sin(angle)},
                                {angle * r, polar * r}};
        });
    mesh.addPatch(Limestone, mesh.detail().steps(8, 3), 1,
                  [&](double u, double v) {
                      const double angle = pi * (1 - u);
                      return SurfacePoint{{r * std::cos(angle), opening.sill,
                                           -0.05 - r * std::sin(angle) * (1 - v)},
                                          {r * std::cos(angle), v}};
                  },
                  {.flip = true});
    if (mesh.detail().shows(0.125)) {
        mesh.append(makeUrn(mesh.detail(), 1.15), place({0, opening.sill, -0.18}));
    }
}

/// Two leaves with sunk panels, and a lunette with bars.
void addDoorLeaves(Mesh& mesh, const Opening& opening) {
    const double z = -opening.depth + 0.12;
    const double r = opening.radius;
    const double height = opening.springing - opening.sill;
    mesh.addQuad(Wood, {-r, opening.sill, z - 0.05}, {r, opening.sill, z - 0.05},
                 {r, opening.springing + r, z - 0.05}, {-r, opening.springing + r, z - 0.05});
    if (!mesh.detail().shows(0.14)) {
        return;
    }
    for (int side = -1; side <= 1; side += 2) {
        const double x0 = side < 0 ? -r : 0.006;
        const double x1 = side < 0 ? -0.006 : r;
        const double w = x1 - x0;
        const double shift = 3.1 * side;
        const double stile = 0.16 * w;
        addBlock(mesh, Wood, {x0, opening.sill, z - 0.04}, {x0 + stile, opening.springing, z}, 0,
                 {shift, 0});
        addBlock(mesh, Wood, {x1 - stile, opening.sill, z - 0.04}, {x1, opening.springing, z}, 0,
                 {shift + 1, 0});
        for (int k = 0; k < 4 && mesh.detail().shows(0.155); ++k) {
            const double y0 = opening.sill + height * k / 4.0;
            addBlock(mesh, Wood, {x0 + stile + 0.05, y0 + 0.1, z - 0.045},
                     {x1 - stile - 0.05, y0 + height / 4 - 0.1, z - 0.012}, 0.025,
                     {shift + 0.5, 2.3 * k});
            if (mesh.detail().shows(0.175)) {
                addBlock(mesh, Wood, {x0 + stile, y0 - 0.05, z - 0.04},
                         {x1 - stile, y0 + 0.05, z - 0.003}, 0, {shift, 1.7 * k});
            }
        }
        if (!mesh.detail().shows(0.23)) {
            continue;
        }
        Profile knob({0.045, 0.0});
        knob.line({0.035, 0.01})
            .line({0.012, 0.02})
            .spline({{0.03, 0.04}, {0.028, 0.06}, {0.0, 0.075}});
        Mesh handle(mesh.detail());
        addLathe(handle, Bronze, knob, mesh.detail().steps(12, 5));
        const Transform toFront(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);
        mesh.append(handle, place({side * 0.09, opening.sill + 1.05, z}) * toFront);
    }
    addBlock(mesh, Wood, {-r, opening.springing - 0.07, z - 0.04},
             {r, opening.springing + 0.07, z + 0.03}, 0.01);
    const int bars = mesh.detail().shows(0.27) ? 5 : 0;
    for (int k = 1; k <= bars; ++k) {
        const double angle = pi * k / (bars + 1);
        const Vec3 end(r * std::cos(angle), opening.springing + r * std::sin(angle), z);
        const Vec3 root(0.15 * end.x, opening.springing + 0.05, z);
        addTube(
            mesh, Bronze, [=](double t) { return root + (end - root) * t; },
            [](double) { return 0.016; }, 1, mesh.detail().steps(6, 4));
    }
}

} // namespace

Mesh makeUrn(const Detail& detail, double height) {
    Mesh mesh(detail);
    const double h = height;
    addBlock(mesh, WhiteMarble, {-0.17 * h, 0, -0.17 * h}, {0.17 * h, 0.09 * h, 0.17 * h}, 0.01);
    Profile urn({0.15 * h, 0.09 * h});
    urn.bow({0.13 * h, 0.14 * h}, 0.4)
        .spline({{0.06 * h, 0.21 * h},
                 {0.07 * h, 0.27 * h},
                 {0.20 * h, 0.42 * h},
                 {0.25 * h, 0.58 * h},
                 {0.23 * h, 0.70 * h},
                 {0.13 * h, 0.79 * h},
                 {0.12 * h, 0.84 * h}})
        .bow({0.17 * h, 0.90 * h}, 0.3)
        .line({0.17 * h, 0.92 * h})
        .spline({{0.10 * h, 0.95 * h}, {0.04 * h, 0.97 * h}, {0.04 * h, 1.0 * h}, {0.0, 1.03 * h}});
    addLathe(mesh, WhiteMarble, urn, detail.steps(40, 5));
    return mesh;
}

Mesh makeWallBay(const Detail& detail, BayKind kind, double halfWidth, double height) {
    Mesh mesh(detail);
    switch (kind) {
    case BayKind::Plain:
        addRectangle(mesh, Plaster, -halfWidth, halfWidth, 0, height);
        break;
    case BayKind::Niche: {
        const Opening opening{0.52, 1.0, 2.55, 0.05};
        addFrame(mesh, opening, halfWidth, height);
        addNicheHollow(mesh, opening);
        break;
    }
    case BayKind::Door: {
        const Opening opening{0.72, 0.0, 2.35, 0.40};
        addFrame(mesh, opening, halfWidth, height);
        addDoorLeaves(mesh, opening);
        break;
    }
    case BayKind::Window: {
        const Opening opening{0.5, 0.95, 2.3, 0.30};
        addFrame(mesh, opening, halfWidth, height);
        addDoorLeaves(mesh, opening);
        break;
    }
    }
    return mesh;
}

Mesh makePilaster(const Detail& detail, double halfWidth, double depth, double height) {
    Mesh mesh(detail);
    const double w = halfWidth;
    if (!detail.shows(0.17)) {
        addBlock(mesh, Limestone, {-w, 0, -0.05}, {w, height, depth});
        return mesh;
    }
    addBlock(mesh, Limestone, {-1.2 * w, 0, -0.05}, {1.2 * w, 0.3, depth * 1.4}, 0);
    addBlock(mesh, Limestone, {-w, 0.3, -0.05}, {w, height - 0.28, depth}, 0.008, {0.7, 0.2});
    addBlock(mesh, Limestone, {-1.1 * w, height - 0.28, -0.05},
             {1.1 * w, height - 0.2, depth * 1.2}, 0);
    addBlock(mesh, Limestone, {-1.25 * w, height - 0.12, -0.05}, {1.25 * w, height, depth * 1.5},
             0.012);
    addBlock(mesh, Limestone, {-w, height - 0.2, -0.05}, {w, height - 0.12, depth}, 0);
    return mesh;
}

} // namespace dirt::generate
