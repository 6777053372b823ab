#include "scenes/generate/cornell.h"

namespace dirt::generate {
namespace {

enum CornellMaterial : int { White, Red, Green, Lamp };

/// A parallelogram, corner `a` to `b` along u and to `d` along v, outward du × dv.
void addFace(Mesh& mesh, int material, Vec3 a, Vec3 b, Vec3 d) {
    const int steps = mesh.detail().steps(1);
    mesh.addPatch(material, steps, steps, [=](double u, double v) {
        return SurfacePoint{a + (b - a) * u + (d - a) * v, {u, v}};
    });
}

/// A box that stands on the floor, turned about its middle: four sides and a top.
void addBox(Mesh& mesh, Vec3 foot, double degrees, double half, double height) {
    Mesh box(mesh.detail());
    for (int side = 0; side < 4; ++side) {
        Mesh wall(mesh.detail());
        addFace(wall, White, {-half, 0, half}, {half, 0, half}, {-half, height, half});
        box.append(wall, place({0, 0, 0}, 90.0 * side));
    }
    addFace(box, White, {-half, height, half}, {half, height, half}, {-half, height, -half});
    addFace(box, White, {-half, 0, -half}, {half, 0, -half}, {-half, 0, half});
    mesh.append(box, place(foot, degrees));
}

} // namespace

Model makeCornell(const Detail& detail) {
    Model model{{{.name = "white", .diffuse = {0.725, 0.71, 0.68}},
                 {.name = "red", .diffuse = {0.63, 0.065, 0.05}},
                 {.name = "green", .diffuse = {0.14, 0.45, 0.091}},
                 {.name = "lamp", .diffuse = {0.78, 0.78, 0.78}, .emission = {5, 4.2, 3}}},
                Mesh(detail)};
    Mesh& mesh = model.mesh;
    addFace(mesh, White, {-1, 0, 1}, {1, 0, 1}, {-1, 0, -1});
    addFace(mesh, White, {-1, 2, -1}, {1, 2, -1}, {-1, 2, 1});
    addFace(mesh, White, {-1, 0, -1}, {1, 0, -1}, {-1, 2, -1});
    addFace(mesh, Red, {-1, 0, 1}, {-1, 0, -1}, {-1, 2, 1});
    addFace(mesh, Green, {1, 0, -1}, {1, 0, 1}, {1, 2, -1});
    addFace(mesh, Lamp, {-0.25, 1.995, -0.22}, {0.25, 1.995, -0.22}, {-0.25, 1.995, 0.22});
    addBox(mesh, {-0.34, 0, -0.32}, 18, 0.3, 1.2);
    addBox(mesh, {0.35, 0, 0.32}, -17, 0.3, 0.6);
    return model;
}

} // namespace dirt::generate
