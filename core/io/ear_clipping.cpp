#include "core/io/ear_clipping.h"

#include <cmath>

#include <glm/common.hpp>

namespace dirt {

namespace {

/// Twice the signed area of abc. Coordinates are float32 values, so the differences, and nearly
/// always the products, are exact in double.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's normal, relative to the first corner so that a polygon far from the origin keeps its
/// digits.
glm::dvec3 newellNormal(std::span<const glm::vec3> polygon) {
    glm::dvec3 normal(0.0);
    const glm::dvec3 origin(polygon[0]);
    glm::dvec3 p = glm::dvec3(polygon.back()) - origin;
    for (const glm::vec3& corner : polygon) {
        const glm::dvec3 q = glm::dvec3(corner) - origin;
        normal.x += (p.y - q.y) * (p.z + q.z);
        normal.y += (p.z - q.z) * (p.x + q.x);
        normal.z += (p.x - q.x) * (p.y + q.y);
        p = q;
    }
    return normal;
}

/// The axis along which the polygon is widest to look at.
int dominantAxis(const glm::dvec3& v) {
    const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    return x > y && x > z ? 0 : y > z ? 1 : 2;
}

/// For a polygon without net area: the axis along which it is narrowest.
int narrowestAxis(std::span<const glm::vec3> polygon) {
    glm::vec3 lo = polygon[0], hi = polygon[0];
    for (const glm::vec3& corner : polygon) {
        lo = glm::min(lo, corner);
        hi = glm::max(hi, corner);
    }
    const glm::dvec3 extent = glm::dvec3(hi) - glm::dvec3(lo);
    return extent.x < extent.y && extent.x < extent.z ? 0 : extent.y < extent.z ? 1 : 2;
}

} // namespace

void EarClipper::project(std::span<const glm::vec3> polygon) {
    const glm::dvec3 normal = newellNormal(polygon);
    const int axis = normal == glm::dvec3(0.0) ? narrowestAxis(polygon) : dominantAxis(normal);
    // Seen from the normal's side, so that the polygon runs counter-clockwise.
    const int x = (axis + (normal[axis] < 0.0 ? 2 : 1)) % 3;
    const int y = 3 - axis - x;

    const uint32_t count = (uint32_t) polygon.size();
    vertices_.resize(count);
    for (uint32_t i = 0; i < count; ++i)
        vertices_[i] = {{polygon[i][x], polygon[i][y]},
                        i == 0 ? count - 1 : i - 1,
                        i + 1 == count ? 0 : i + 1,
                        false};
    for (uint32_t i = 0; i < count; ++i) updateConvexity(i);
}

void EarClipper::updateConvexity(uint32_t vertex) {
    Vertex& v = vertices_[vertex];
    v.convex = turn(vertices_[v.previous].position, v.position, vertices_[v.next].position) > 0.0;
}

/// Whether another corner lies in the ear. Corners at the place of one of the ear's own don't
/// count: polygons with holes reach them over an edge that is run through twice.
bool EarClipper::containsVertex(uint32_t ear, Rule rule) const {
    const Vertex& v = vertices_[ear];
    const glm::dvec2 a = vertices_[v.previous].position, b = v.position,
                     c = vertices_[v.next].position;
    for (uint32_t i = vertices_[v.next].next; i != v.previous; i = vertices_[i].next) {
        if (vertices_[i].convex) continue; // then a reflex one lies inside as well
        const glm::dvec2 p = vertices_[i].position;
        if (p == a || p == b || p == c) continue;
        const double ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
        const bool inside = rule == Rule::proper ? ab >= 0.0 && bc >= 0.0 && ca >= 0.0
                                                 : ab > 0.0 && bc > 0.0 && ca > 0.0;
        if (inside) return true;
    }
    return false;
}

bool EarClipper::isEar(uint32_t vertex, Rule rule) const {
    const Vertex& v = vertices_[vertex];
    switch (rule) {
    case Rule::proper:
    case Rule::noneInside:
        return v.convex && !containsVertex(vertex, rule);
    case Rule::convex:
        return turn(vertices_[v.previous].position, v.position, vertices_[v.next].position) >= 0.0;
    case Rule::any:
        break;
    }
    return true;
}

std::span<const EarClipper::Ear> EarClipper::operator()(std::span<const glm::vec3> polygon) {
    ears_.clear();
    uint32_t remaining = (uint32_t) polygon.size();
    if (remaining < 3) return ears_;
    if (remaining == 3) {
        ears_.push_back({0, 1, 2});
        return ears_;
    }
    project(polygon);
    Rule rule = Rule::proper;
    uint32_t vertex = 1, refused = 0;
    while (remaining > 3) {
        const uint32_t previous = vertices_[vertex].previous, next = vertices_[vertex].next;
        if (isEar(vertex, rule)) {
            ears_.push_back({previous, vertex, next});
            vertices_[previous].next = next;
            vertices_[next].previous = previous;
            updateConvexity(previous);
            updateConvexity(next);
            --remaining;
            refused = 0;
        } else if (++refused == remaining) {
            // Once broken, a polygon stays broken: going back to the stricter rules would only
            // cost time.
            rule = (Rule) ((int) rule + 1);
            refused = 0;
        }
        vertex = next;
    }
    ears_.push_back({vertices_[vertex].previous, vertex, vertices_[vertex].next});
    return ears_;
}

} // namespace dirt
