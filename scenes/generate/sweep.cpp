#include "scenes/generate/sweep.h"

#include "scenes/generate/numbers.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt::generate {
namespace {

double widestRadius(const Profile& profile) {
    double widest = 0;
    for (const auto& piece : profile.pieces()) {
        for (const Vec2 control : piece.controls) {
            widest = std::max(widest, control.x);
        }
    }
    return widest;
}

} // namespace

void addLathe(Mesh& mesh, int material, const Profile& profile, int sides) {
    const double around = turn * widestRadius(profile);
    double start = 0;
    for (const auto& piece : profile.pieces()) {
        const auto surface = [&](double u, double v) -> SurfacePoint {
            const Vec2 p = piece.at(v);
            const double angle = -turn * (u < 1 ? u : 0);
            return {{p.x * std::cos(angle), p.y, p.x * std::sin(angle)},
                    {u * around, start + v * piece.length}};
        };
        mesh.addPatch(material, sides, mesh.detail().steps(piece.steps), surface, {.wrapU = true});
        start += piece.length;
    }
}

void addPrism(Mesh& mesh, int material, const Profile& profile, int sides) {
    const double slope = std::tan(std::numbers::pi / sides);
    double start = 0;
    for (const auto& piece : profile.pieces()) {
        for (int side = 0; side < sides; ++side) {
            const double angle = turn * side / sides;
            const Vec3 out(std::cos(angle), 0, -std::sin(angle));
            const Vec3 along(-std::sin(angle), 0, -std::cos(angle));
            const auto surface = [&](double u, double v) -> SurfacePoint {
                const Vec2 p = piece.at(v);
                const double w = p.x * slope * (2 * u - 1);
                return {out * p.x + along * w + Vec3(0, p.y, 0),
                        {w + side * 1.37, start + v * piece.length}};
            };
            // A line's patch is flat: one quad is exact.
            mesh.addPatch(material, 1, piece.steps <= 1 ? 1 : mesh.detail().steps(piece.steps),
                          surface);
        }
        start += piece.length;
    }
}

void addInnerRing(Mesh& mesh, int material, const Profile& profile, Vec2 halfExtent,
                  double stepsAlong) {
    double start = 0;
    for (const auto& piece : profile.pieces()) {
        for (int side = 0; side < 4; ++side) {
            const bool endWall = side % 2 == 1;
            const double depth = endWall ? halfExtent.y : halfExtent.x;
            const double half = endWall ? halfExtent.x : halfExtent.y;
            const double angle = turn * side / 4;
            const Vec3 out(std::round(std::cos(angle)), 0, std::round(-std::sin(angle)));
            const Vec3 along(out.z, 0, -out.x);
            const auto surface = [&](double u, double v) -> SurfacePoint {
                const Vec2 p = piece.at(v);
                const double w = (half - p.x) * (1 - 2 * u);
                return {out * (depth - p.x) + along * w + Vec3(0, p.y, 0),
                        {-w, start + v * piece.length}};
            };
            mesh.addPatch(material, mesh.detail().steps(stepsAlong),
                          mesh.detail().steps(piece.steps), surface);
        }
        start += piece.length;
    }
}

void addSweep(Mesh& mesh, int material, const Profile& profile,
              const std::function<PathFrame(double)>& path, int steps) {
    double start = 0;
    for (const auto& piece : profile.pieces()) {
        const auto surface = [&](double u, double v) -> SurfacePoint {
            const PathFrame frame = path(u);
            const Vec2 p = piece.at(v);
            return {frame.origin + frame.x * p.x + frame.y * p.y,
                    {frame.length, start + v * piece.length}};
        };
        mesh.addPatch(material, steps, mesh.detail().steps(piece.steps), surface);
        start += piece.length;
    }
}

void addTube(Mesh& mesh, int material, const std::function<Vec3(double)>& path,
             const std::function<double(double)>& radius, int steps, int sides) {
    const auto surface = [&](double u, double v) -> SurfacePoint {
        const double h = 1e-4;
        const Vec3 ahead = path(std::min(1.0, v + h)) - path(std::max(0.0, v - h));
        const Vec3 tangent = glm::normalize(ahead);
        const Vec3 helper = std::abs(tangent.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
        const Vec3 x = glm::normalize(glm::cross(helper, tangent));
        const Vec3 y = glm::cross(tangent, x);
        const double angle = turn * (u < 1 ? u : 0);
        const double r = radius(v);
        return {path(v) + (x * std::cos(angle) + y * std::sin(angle)) * r,
                {u * turn * radius(0.5), v}};
    };
    mesh.addPatch(material, sides, steps, surface, {.wrapU = true});
}

} // namespace dirt::generate
