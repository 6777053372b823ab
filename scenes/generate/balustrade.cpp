#include "scenes/generate/balustrade.h"

#include "scenes/generate/block.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

/// A double-bellied baluster of the given height, on y = 0.
Mesh makeBaluster(const Detail& detail, int material, double height) {
    Mesh mesh(detail);
    const double h = height;
    const double foot = 0.095 * h;
    const double half = 0.125 * h;
    Profile profile({0.115 * h, foot});
    if (detail.shows(0.30)) {
        addBlock(mesh, material, {-half, 0, -half}, {half, foot, half}, 0);
        addBlock(mesh, material, {-half, h - foot, -half}, {half, h, half}, 0);
        profile.bow({0.095 * h, 0.15 * h}, 0.4)
            .spline({{0.05 * h, 0.21 * h},
                     {0.06 * h, 0.27 * h},
                     {0.125 * h, 0.40 * h},
                     {0.12 * h, 0.47 * h},
                     {0.07 * h, 0.60 * h},
                     {0.045 * h, 0.74 * h},
                     {0.055 * h, 0.79 * h}})
            .bow({0.06 * h, 0.835 * h}, 0.6)
            .line({0.075 * h, 0.85 * h})
            .bow({0.105 * h, h - foot}, 0.3);
        addLathe(mesh, material, profile, detail.steps(10, 5));
    } else {
        Profile plain({0.05 * h, 0});
        plain.line({0.12 * h, 0.4 * h}).line({0.05 * h, h});
        addLathe(mesh, material, plain, 4);
    }
    return mesh;
}

} // namespace

Mesh makeBalustrade(const Detail& detail, const BalustradeShape& shape) {
    Mesh mesh(detail);
    const double base = 0.13 * shape.height;
    const double rail = 0.16 * shape.height;
    const double half = shape.length / 2;
    addBlock(mesh, shape.material, {-half, 0, -0.42 * shape.depth},
             {half, base, 0.42 * shape.depth}, 0.01);
    Profile section({-0.36 * shape.depth, shape.height - rail});
    section.line({0.36 * shape.depth, shape.height - rail})
        .cyma({0.5 * shape.depth, shape.height - 0.45 * rail}, 0.4)
        .line({0.5 * shape.depth, shape.height - 0.12 * rail})
        .line({0.46 * shape.depth, shape.height})
        .line({-0.46 * shape.depth, shape.height})
        .line({-0.5 * shape.depth, shape.height - 0.12 * rail})
        .line({-0.5 * shape.depth, shape.height - 0.45 * rail})
        .cyma({-0.36 * shape.depth, shape.height - rail}, -0.4);
    const auto path = [&](double u) -> PathFrame {
        return {{u * shape.length - half, 0, 0}, {0, 0, 1}, {0, 1, 0}, u * shape.length};
    };
    addSweep(mesh, shape.material, section, path, detail.steps(2));
    const Mesh baluster = makeBaluster(detail, shape.balusterMaterial, shape.height - base - rail);
    const int count = detail.number(shape.length / 0.27, 2);
    for (int k = 0; k < count; ++k) {
        const double x = -half + shape.length * (k + 0.5) / count;
        mesh.append(baluster, place({x, base, 0}), {0.37 * k, 0.21 * k});
    }
    return mesh;
}

Mesh makePedestal(const Detail& detail, int material, double halfWidth, double height) {
    Mesh mesh(detail);
    Profile profile({halfWidth, 0});
    profile.line({halfWidth, 0.12 * height});
    if (detail.shows(0.19)) {
        profile.cyma({0.86 * halfWidth, 0.18 * height}, -0.4)
            .line({0.86 * halfWidth, 0.84 * height})
            .cyma({halfWidth, 0.91 * height}, 0.4);
    }
    profile.line({halfWidth, height}).line({0, height});
    addPrism(mesh, material, profile, 4);
    return mesh;
}

} // namespace dirt::generate
