#include "scenes/generate/loft.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

/// The slope that a monotone curve has at a key between two chords (their harmonic mean).
double slopeBetween(double before, double after) {
    return before * after > 0 ? 2 * before * after / (before + after) : 0;
}

/// Half the thickness of a symmetric four-digit profile, at a part of the chord.
double halfThickness(double x, double thickness) {
    return 5 * thickness *
           (0.2969 * std::sqrt(x) + x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))));
}

} // namespace

double Keys::operator()(double x) const {
    if (x <= keys_.front().x) return keys_.front().y;
    if (x >= keys_.back().x) return keys_.back().y;
    std::size_t k = 1;
    while (keys_[k].x < x) ++k;
    const auto chord = [this](std::size_t i) {
        return (keys_[i + 1].y - keys_[i].y) / (keys_[i + 1].x - keys_[i].x);
    };
    const double width = keys_[k].x - keys_[k - 1].x;
    const double here = chord(k - 1);
    const double m0 = k >= 2 ? slopeBetween(chord(k - 2), here) : here;
    const double m1 = k + 1 < keys_.size() ? slopeBetween(here, chord(k)) : here;
    const double t = (x - keys_[k - 1].x) / width;
    const double s = 1 - t;
    return keys_[k - 1].y * s * s * (1 + 2 * t) + keys_[k].y * t * t * (3 - 2 * t) +
           width * s * t * (m0 * s - m1 * t);
}

void addWing(Mesh& mesh, int material, const std::vector<WingStation>& stations, double columns,
             double rows) {
    const auto spans = static_cast<int>(stations.size()) - 1;
    const Vec3 way = glm::normalize(stations.back().leading * Vec3(1, 1, 0) -
                                    stations.front().leading * Vec3(1, 1, 0));
    const Vec3 up = glm::cross(Vec3(0, 0, 1), way);
    const auto surface = [&](double u, double v) -> SurfacePoint {
        const int span = std::min(static_cast<int>(v * spans), spans - 1);
        const double t = v * spans - span;
        const WingStation& a = stations[static_cast<std::size_t>(span)];
        const WingStation& b = stations[static_cast<std::size_t>(span) + 1];
        const double chord = a.chord + (b.chord - a.chord) * t;
        const double thickness = a.thickness + (b.thickness - a.thickness) * t;
        const Vec3 leading = a.leading + (b.leading - a.leading) * t;
        const double angle = 2 * std::numbers::pi * u;
        const double x = 0.5 + 0.5 * std::cos(angle);
        const double half = halfThickness(x, thickness) * (u < 0.5 ? 1.0 : -0.85);
        return {leading - Vec3(0, 0, chord * x) + up * (half * chord),
                {glm::dot(leading, way), x * chord + (u < 0.5 ? 0 : 7.3)}};
    };
    mesh.addPatch(material, mesh.detail().steps(columns, 6) / 2 * 2,
                  spans * mesh.detail().steps(rows), surface);
}

Transform standing(Vec3 from, Vec3 to) {
    const Vec3 y = glm::normalize(to - from);
    const Vec3 helper = std::abs(y.y) < 0.99 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 x = glm::normalize(glm::cross(helper, y));
    const Vec3 z = glm::cross(x, y);
    return Transform(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(from, 1));
}

void addBar(Mesh& mesh, int material, Vec3 from, Vec3 to, double width, double height,
            double bevel) {
    Mesh bar(mesh.detail());
    const double length = glm::distance(from, to);
    addBlock(bar, material, {-width / 2, 0, -height / 2}, {width / 2, length, height / 2}, bevel);
    mesh.append(bar, standing(from, to), {from.x + from.z, from.y});
}

void addRod(Mesh& mesh, int material, Vec3 from, Vec3 to, double radius, double sides) {
    addTube(
        mesh, material, [=](double t) { return from + (to - from) * t; },
        [=](double) { return radius; }, 1, mesh.detail().steps(sides, 5));
}

} // namespace dirt::generate
