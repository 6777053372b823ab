#pragma once

#include "tests/support/views.h"

#include <algorithm>
#include <cmath>

/// Triangles that overlap tests get wrong, aimed at one tile of one view.
namespace dirt::test {

/// A triangle of the grid frame, and the tile it was aimed at.
struct TileCase {
    const ViewSet* set;
    const View* view;
    Triangle triangle;
    int column, row;
    const char* kind;
};

class NastyTriangles {
public:
    NastyTriangles(Random& random, const std::vector<ViewSet>& sets) : random(random), sets(sets) {}

    /// A third of all are degenerate, edge-on, through the eye's plane or on a tile's border.
    TileCase next() {
        set = &sets[random.below((int) sets.size())];
        view = &set->views[random.below((int) set->views.size())];
        tile = set->tileSize(*view);
        column = random.below(view->columns);
        row = random.below(view->rows);
        glm::dvec3 p[3];
        const char* kind = shape(p);
        TileCase result{set, view, toTriangle(p), column, row, kind};
        aim(result);
        return result;
    }

private:
    const char* shape(glm::dvec3 (&p)[3]) {
        switch (random.below(26)) {
        case 0:
        case 1:
            return wide(p), "wide exponents";
        case 2:
        case 3:
        case 4:
            return local(p, 10.0), "near the tile";
        case 5:
        case 6:
            return local(p, 1e-3), "tiny";
        case 7:
        case 8:
        case 9:
            return alongBorder(p), "along a border";
        case 10:
        case 11:
        case 12:
            return pastCorner(p), "past a corner";
        case 13:
            return onGrid(p), "on borders and corners";
        case 14:
            return inBorderPlane(p), "in a border's plane";
        case 15:
            return edgeOn(p, 0), "edge-on";
        case 16:
            return edgeOn(p, random.range(1, 64)), "nearly edge-on";
        case 17:
            return point(p), "a point";
        case 18:
            return segment(p), "a segment";
        case 19:
            return collinearWithEye(p), "collinear with the eye";
        case 20:
            return aroundEye(p), "through or around the eye";
        case 21:
            return behind(p), "through the eye's plane";
        case 22:
            return sliver(p), "sliver";
        case 23:
        case 24:
            return pastEye(p), "closely past the eye";
        default:
            return noise(p), "almost zero coordinates";
        }
    }

    double depth() {
        return random.chance(0.5) ? random.powerOfTwo(-20, 0)
                                  : std::pow(10.0, random.uniform(-6, 0));
    }

    /// A place across the tile along one axis, as a slope: on a border, on one of the three guard
    /// bands, just beside them, inside, or up to \p reach tiles away.
    double slope(const std::vector<float>& borders, int cell, double width, double reach) {
        const int side = random.below(2);
        const double border = borders[cell + side], outwards = side ? width : -width;
        switch (random.below(6)) {
        case 0:
            return border;
        case 1:
            return border + outwards * random.pick({1.0 / 512, 1.0 / 128, 1.0 / 64});
        case 2:
            return border + outwards * random.uniform(1.0 / 512, 1.0 / 64);
        case 3:
            return border + outwards * random.wide(-9, -1);
        case 4:
            return borders[cell] + random.uniform() * ((double) borders[cell + 1] - borders[cell]);
        default:
            return border + outwards * random.uniform(-reach, reach);
        }
    }
    glm::dvec2 slopes(double reach) {
        return {slope(view->s, column, tile.x, reach), slope(view->t, row, tile.y, reach)};
    }
    static glm::dvec3 at(glm::dvec2 slopes, double w) { return {slopes.x * w, slopes.y * w, w}; }
    glm::dvec3 corner(double w) {
        return at({view->s[column + random.below(2)], view->t[row + random.below(2)]}, w);
    }

    void wide(glm::dvec3 (&p)[3]) {
        for (glm::dvec3& v : p) v = {random.wide(-6, 6), random.wide(-6, 6), random.wide(-6, 6)};
    }
    void local(glm::dvec3 (&p)[3], double reach) {
        const double w = depth(), spread = std::pow(10.0, random.uniform(-7, 1));
        const bool flat = random.chance(0.5);
        const glm::dvec2 center = slopes(reach);
        for (glm::dvec3& v : p) {
            const glm::dvec2 offset{random.uniform(-1, 1) * tile.x, random.uniform(-1, 1) * tile.y};
            v = at(center + offset * spread, flat ? w * (1 + random.uniform() * spread) : depth());
        }
    }
    /// An edge runs along a border of the tile, in or near the guard bands.
    void alongBorder(glm::dvec3 (&p)[3]) {
        const glm::dvec2 a = slopes(2);
        const double length = std::pow(10.0, random.uniform(-3, 3));
        const bool upright = random.chance(0.5);
        glm::dvec2 b = a, c = slopes(20);
        (upright ? b.y : b.x) += random.sign() * length * (upright ? tile.y : tile.x);
        if (random.chance(0.5)) { // a long way past the tile on both sides
            c = a;
            (upright ? c.y : c.x) -= length * (upright ? tile.y : tile.x);
            (upright ? c.x : c.y) += random.wide(-6, 1) * (upright ? tile.x : tile.y);
        }
        p[0] = at(a, depth()), p[1] = at(b, depth()), p[2] = at(c, depth());
    }
    /// An edge passes the tile's corner closely, with the rest beyond or across.
    void pastCorner(glm::dvec3 (&p)[3]) {
        const int right = random.below(2), below = random.below(2);
        const double distance = random.chance(0.5)
                                    ? random.uniform(0, 1.0 / 32)
                                    : random.pick({0.0, 1.0 / 512, 1.0 / 128, 1.0 / 64});
        const glm::dvec2 outwards{right ? tile.x : -tile.x, below ? tile.y : -tile.y};
        const glm::dvec2 via =
            glm::dvec2(view->s[column + right], view->t[row + below]) + outwards * distance;
        const double angle = random.uniform(0, 1.5707963);
        const glm::dvec2 along{outwards.x * std::cos(angle), -outwards.y * std::sin(angle)};
        const double ahead = std::pow(10.0, random.uniform(-2, 3));
        const double back = std::pow(10.0, random.uniform(-2, 3));
        p[0] = at(via + along * ahead, depth());
        p[1] = at(via - along * back, depth());
        const double side = random.chance(0.7) ? std::pow(10.0, random.uniform(-5, 3)) : -1.0;
        p[2] = at(via + outwards * side + along * random.uniform(-1, 1), depth());
    }
    void onGrid(glm::dvec3 (&p)[3]) {
        for (glm::dvec3& v : p)
            v = random.chance(0.7) ? corner(random.powerOfTwo(-12, 0))
                                   : at(slopes(2), random.powerOfTwo(-12, 0));
    }
    void inBorderPlane(glm::dvec3 (&p)[3]) {
        const int side = random.below(2);
        const bool upright = random.chance(0.5);
        const double border = upright ? view->s[column + side] : view->t[row + side];
        for (glm::dvec3& v : p) {
            const double w = random.powerOfTwo(-12, 0), other = random.wide(-6, 0);
            v = upright ? glm::dvec3(border * w, other, w) : glm::dvec3(other, border * w, w);
        }
    }
    /// Integer combinations of two integer vectors: exactly in a plane through the eye.
    void edgeOn(glm::dvec3 (&p)[3], int perturbation) {
        const glm::dvec2 center = slopes(1);
        const glm::dvec3 u = glm::round(at(center, 1.0) * 1024.0);
        const glm::dvec3 v(random.range(-999, 999), random.range(-999, 999),
                           random.range(-999, 999));
        for (glm::dvec3& q : p)
            q = (u * (double) random.range(-20, 900) + v * (double) random.range(-40, 40)) *
                0x1p-24 * random.powerOfTwo(-8, 0);
        for (int i = 0; i < perturbation; ++i) {
            double& x = p[random.below(3)][random.below(3)];
            x = std::nextafter((float) x, (float) random.sign());
        }
    }
    void point(glm::dvec3 (&p)[3]) {
        p[0] = p[1] = p[2] =
            random.chance(0.3) ? corner(random.powerOfTwo(-12, 0)) : at(slopes(1), depth());
    }
    void segment(glm::dvec3 (&p)[3]) {
        local(p, 3.0);
        if (random.chance(0.5)) alongBorder(p);
        if (random.chance(0.5))
            p[2] = p[random.below(2)];
        else // on the segment, exactly where the sum is exact, else nearly
            p[2] = (glm::dvec3(glm::vec3(p[0])) + glm::dvec3(glm::vec3(p[1]))) * 0.5;
    }
    void collinearWithEye(glm::dvec3 (&p)[3]) {
        local(p, 2.0);
        p[1] = glm::dvec3(glm::vec3(p[0])) * random.powerOfTwo(-20, 0);
        if (random.chance(0.5)) p[2] = glm::dvec3(glm::vec3(p[0])) * random.powerOfTwo(-20, 0);
        if (random.chance(0.2)) p[1] = -p[1];
    }
    void aroundEye(glm::dvec3 (&p)[3]) {
        local(p, 2.0);
        switch (random.below(4)) {
        case 0:
            p[0] = {0, 0, 0};
            break;
        case 1:
            p[1] = glm::dvec3(glm::vec3(p[0])) * -random.powerOfTwo(-10, 3);
            break;
        case 2:
            p[0] = p[1] = {0, 0, 0};
            break;
        default: // the eye is inside: c = -(a + b) / 2^k for integers a and b
            for (int i = 0; i < 2; ++i) p[i] = glm::round(p[i] / tile.x * 1000.0 * 0x1p12 / p[i].z);
            p[2] = (p[0] + p[1]) * -random.powerOfTwo(-4, 4);
            for (glm::dvec3& v : p) v *= 0x1p-40;
        }
    }
    void behind(glm::dvec3 (&p)[3]) {
        random.chance(0.5) ? local(p, 10.0) : pastCorner(p);
        const int count = random.range(1, 2);
        for (int i = 0; i < count; ++i) {
            glm::dvec3& v = p[random.below(3)];
            if (random.chance(0.3))
                v = {random.wide(-6, 0), random.wide(-6, 0), 0.0};
            else
                v = {random.wide(-6, 0), random.wide(-6, 0),
                     -std::pow(10.0, random.uniform(-6, 0))};
        }
    }
    /// Large, and nearer to the eye than its vertices by far: in the tile or beside it.
    void pastEye(glm::dvec3 (&p)[3]) {
        const glm::dvec3 near =
            at(slopes(1), std::ldexp(random.uniform(1, 2), random.range(-30, -4)));
        glm::dvec3 along, across;
        for (int i = 0; i < 3; ++i)
            along[i] = random.uniform(-1, 1), across[i] = random.uniform(-1, 1);
        if (random.chance(0.3)) along.z = 0;
        if (random.chance(0.3)) across = at(slopes(1), random.sign());
        p[0] = near + along * std::pow(10.0, random.uniform(-3, 0));
        p[1] = near - along * std::pow(10.0, random.uniform(-3, 0));
        p[2] = random.chance(0.5) ? near + across * std::pow(10.0, random.uniform(-6, 0))
                                  : across * std::pow(10.0, random.uniform(-3, 0)) - near;
    }
    void sliver(glm::dvec3 (&p)[3]) {
        random.chance(0.5) ? local(p, 100.0) : pastCorner(p);
        const double f = random.uniform();
        p[2] = random.chance(0.5) ? p[0] : p[0] * f + p[1] * (1 - f);
        p[2] += glm::dvec3(random.wide(-9, -5), random.wide(-9, -5), random.wide(-9, -5)) *
                glm::length(p[0]);
    }
    void noise(glm::dvec3 (&p)[3]) {
        random.chance(0.5) ? local(p, 10.0) : wide(p);
        for (int i = 0; i < 3; ++i) p[random.below(3)][random.below(3)] *= random.wide(-20, -8);
    }

    /// Rounds to float; where a coordinate reaches 2, the grid frame's scale is applied.
    Triangle toTriangle(glm::dvec3 (&p)[3]) {
        double largest = 0;
        for (const glm::dvec3& v : p)
            largest = std::max({largest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
        double scale = 1;
        while (largest * scale >= 1.99) scale *= 0.5;
        if (random.chance(0.2)) scale *= random.powerOfTwo(-20, 0);
        std::swap(p[random.below(3)], p[random.below(3)]);
        for (glm::dvec3& v : p) v *= scale;
        return {fromView(*view, glm::vec3(p[0])), fromView(*view, glm::vec3(p[1])),
                fromView(*view, glm::vec3(p[2]))};
    }

    /// Keeps the tile, or takes one beside it, one under a point of the triangle, or any.
    void aim(TileCase& result) {
        const int choice = random.below(10);
        if (choice >= 8) {
            result.column = random.below(view->columns);
            result.row = random.below(view->rows);
        } else if (choice >= 5) {
            const double u = random.pick({0.0, 1.0, random.uniform()});
            const double v = (1 - u) * random.pick({0.0, 1.0, random.uniform()});
            const glm::dvec3 a(view->toView(result.triangle.a)), b(view->toView(result.triangle.b)),
                c(view->toView(result.triangle.c));
            const glm::dvec3 p = a * (1 - u - v) + b * u + c * v;
            if (p.z > 0) {
                result.column = cellAt(view->s, p.x / p.z);
                result.row = cellAt(view->t, p.y / p.z);
            }
        }
        if (choice % 2) {
            result.column = std::clamp(result.column + random.range(-1, 1), 0, view->columns - 1);
            result.row = std::clamp(result.row + random.range(-1, 1), 0, view->rows - 1);
        }
    }

    Random& random;
    const std::vector<ViewSet>& sets;
    const ViewSet* set = nullptr;
    const View* view = nullptr;
    TileSize tile{};
    int column = 0, row = 0;
};

} // namespace dirt::test
