#include "scenes/generate/drape.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

constexpr double clothThickness = 0.008;

/// The cloth's two faces, its trimmed borders and its closed rim, over (u across, v down).
void addCloth(Mesh& mesh, int material, int trim, const Surface& front, double trimShare,
              int columns, int rows) {
    const auto back = [&](double u, double v) -> SurfacePoint {
        const double h = 1e-4;
        const SurfacePoint p = front(u, v);
        const Vec3 du =
            front(std::min(1.0, u + h), v).position - front(std::max(0.0, u - h), v).position;
        const Vec3 dv =
            front(u, std::min(1.0, v + h)).position - front(u, std::max(0.0, v - h)).position;
        const Vec3 normal = glm::normalize(glm::cross(dv, du));
        return {p.position - normal * clothThickness, p.texcoord};
    };
    const double begin[3] = {0, trimShare, 1 - trimShare};
    const double end[3] = {trimShare, 1 - trimShare, 1};
    for (int strip = 0; strip < 3; ++strip) {
        const bool middle = strip == 1;
        const int across =
            middle ? columns : std::max(1, static_cast<int>(columns * trimShare + 0.5));
        const double low = begin[strip];
        const double width = end[strip] - low;
        const int colour = middle ? material : trim;
        // The lowest part of the middle is trimmed as well.
        const double hem = middle ? 0.955 : 1.0;
        const auto part = [&](const Surface& face, double from, double to) {
            return [&face, low, width, from, to](double u, double v) {
                return face(low + width * u, from + (to - from) * v);
            };
        };
        const bool twoSided = mesh.detail().shows(0.29);
        mesh.addPatch(colour, across, rows, part(front, 0, hem), {.flip = true});
        if (twoSided) mesh.addPatch(colour, across, rows, part(back, 0, hem));
        if (middle) {
            const int hemRows = std::max(1, rows / 20);
            mesh.addPatch(trim, across, hemRows, part(front, hem, 1), {.flip = true});
            if (twoSided) mesh.addPatch(trim, across, hemRows, part(back, hem, 1));
        }
    }
    if (mesh.detail().shows(0.31)) {
        const auto rim = [&](int side) {
            return [&front, &back, side](double u, double v) {
                const double s = side == 0 ? 0 : 1;
                const SurfacePoint a = side == 2 ? front(u, 1) : front(s, u);
                const SurfacePoint b = side == 2 ? back(u, 1) : back(s, u);
                return SurfacePoint{a.position + (b.position - a.position) * v, a.texcoord};
            };
        };
        mesh.addPatch(trim, rows, 1, rim(0), {.flip = true});
        mesh.addPatch(trim, rows, 1, rim(1));
        mesh.addPatch(trim, columns, 1, rim(2));
    }
}

} // namespace

Mesh makeBanner(const Detail& detail, const BannerShape& shape) {
    Mesh mesh(detail);
    // The way down: over the rail, out to the cornice's edge, then free.
    Profile way({-0.34, -0.10});
    way.spline({{-0.30, 0.0},
                {-0.12, 0.018},
                {0.02, 0.0},
                {0.06, -0.10},
                {0.6 * shape.projection, -0.72 * shape.cornice},
                {shape.projection + 0.03, -shape.cornice - 0.02},
                {shape.projection + 0.05, -shape.cornice - 0.35},
                {shape.projection + 0.04, -0.45 * shape.length - 0.5 * shape.cornice},
                {shape.projection + 0.04, -shape.length}});
    const auto& path = way.pieces().front();
    const double phase = turn * hashUnit(shape.seed, 1);
    const double lean = hashRange(-0.05, 0.05, shape.seed, 2);
    const auto surface = [&, phase, lean](double u, double v) -> SurfacePoint {
        const Vec2 p = path.at(v);
        const double side = 2 * u - 1;
        const double fall =
            std::clamp((-p.y - shape.cornice) / (shape.length - shape.cornice), 0.0, 1.0);
        const double loose = std::sqrt(fall) * (0.55 + 0.45 * fall);
        // Folds run down and drift sideways; narrow ones die out, wide ones grow towards the hem.
        const double drift =
            0.35 * std::sin(2.6 * fall + phase) + 0.2 * std::sin(5.1 * fall + 2 * phase);
        const double wide = std::sin(turn * (2.3 * u + 0.16 * drift) + phase);
        const double narrow = std::sin(turn * (5.2 * u - 0.20 * drift) + 2.1 * phase);
        const double twist = std::sin(turn * (0.8 * u + 0.5 * fall) + 3.3 * phase);
        // Sharper ridges than a sine's: cloth bends in creases.
        const double folds = 0.75 * std::copysign(std::pow(std::abs(wide), 0.8), wide) +
                             0.40 * narrow * (1 - 0.5 * fall) + 0.35 * twist;
        const double depth = 0.02 + 0.17 * loose;
        const double gather = 1 - 0.16 * loose;
        const double sway = 0.03 * std::sin(turn * 4.6 * u + phase) * loose;
        const double hem = 0.03 * fall * wide;
        return {{0.5 * shape.width * side * gather + lean * fall + sway, p.y + hem,
                 p.x + depth * (folds + 0.9)},
                {0.5 * shape.width * side, v * (shape.length + 0.6)}};
    };
    addCloth(mesh, shape.material, shape.trimMaterial, surface, 0.07, detail.steps(110, 4),
             detail.steps(34, 6));
    return mesh;
}

Mesh makeCurtain(const Detail& detail, int material, int trimMaterial, double halfWidth,
                 double height, double tie, std::uint32_t seed) {
    Mesh mesh(detail);
    const double phase = turn * hashUnit(seed, 7);
    const auto surface = [&, phase](double u, double v) -> SurfacePoint {
        const double y = height * (1 - v);
        // Full width at the rod, a narrow waist at the tie, half open below.
        const double above = std::clamp((y - tie) / (height - tie), 0.0, 1.0);
        const double below = std::clamp((tie - y) / tie, 0.0, 1.0);
        const double width = y > tie ? 0.16 + (halfWidth - 0.16) * std::pow(above, 0.75)
                                     : 0.16 + 0.34 * std::pow(below, 0.6);
        const double gather = 1 - std::pow(width / halfWidth, 0.5);
        const double folds = std::sin(turn * 6 * u + phase) * 0.7 +
                             std::sin(turn * (9.5 * u + 0.2 * v) + 2 * phase) * 0.3;
        const double depth = 0.045 + 0.05 * gather;
        // Cloth between rod and tie swings down in a curve.
        const double swing = 0.55 * above * (1 - above) * (1 - u) * (1 - u);
        const double x = halfWidth - width * (1 - u);
        return {{x, y - swing, depth * folds}, {u * 2.2 * halfWidth, v * height}};
    };
    addCloth(mesh, material, trimMaterial, surface, 0.05, detail.steps(48, 8), detail.steps(30, 6));
    Profile band({0.115, tie - 0.05});
    band.bow({0.115, tie + 0.05}, 0.2);
    Mesh knot(detail);
    addLathe(knot, trimMaterial, band, detail.steps(16, 6));
    mesh.append(knot, place({halfWidth - 0.08, 0, 0}));
    return mesh;
}

} // namespace dirt::generate
