#include "core/io/ear_clipping.h"

#include <cmath>
#include <utility>

#include <glm/common.hpp>

namespace dirt {

namespace {

/// Of polygons with more corners, ears that follow each other share none: neighbours would make a
/// fan of slivers as long as the polygon, of which each ray that leaves it passes thousands.
constexpr uint32_t kMostOfAFan = 1024;

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
        vertices_[i] = {
            {polygon[i][x], polygon[i][y]}, i == 0 ? count - 1 : i - 1, i + 1 == count ? 0 : i + 1};
    anyReflex_ = false;
    bool any = false;
    for (uint32_t i = 0; i < count; ++i) any |= !(vertices_[i].convex = turnAt(i) > 0.0);
    if (any) findReflex();
}

double EarClipper::turnAt(uint32_t vertex) const {
    const Vertex& v = vertices_[vertex];
    return turn(vertices_[v.previous].position, v.position, vertices_[v.next].position);
}

/// Puts what is not convex into points_; before the first such corner there is nothing to look for.
void EarClipper::findReflex() {
    positions_.clear();
    for (const Vertex& v : vertices_) positions_.push_back(v.position);
    points_.set(positions_);
    for (uint32_t i = 0; i < vertices_.size(); ++i)
        if (!vertices_[i].cut && !vertices_[i].convex) points_.use(i);
    watched_.assign(points_.size(), PolygonPoints::kNone);
    watches_.clear();
    anyReflex_ = true;
}

/// Corners that were refused because of one that is convex now may be ears.
void EarClipper::updateConvexity(uint32_t vertex) {
    Vertex& v = vertices_[vertex];
    const bool before = std::exchange(v.convex, turnAt(vertex) > 0.0);
    if (v.convex == before) return;
    if (!anyReflex_) return findReflex();
    if (!v.convex) return points_.use(vertex);
    points_.release(vertex);
    const uint32_t place = points_.placeOf(vertex);
    if (points_.isUsed(place)) return;
    for (uint32_t i = std::exchange(watched_[place], PolygonPoints::kNone);
         i != PolygonPoints::kNone; i = watches_[i].next)
        if (!vertices_[watches_[i].vertex].cut) due_.insert(watches_[i].vertex);
}

/// Whether another corner lies in the ear. Corners at the place of one of the ear's own don't
/// count: polygons with holes reach them over an edge that is run through twice. Nor do convex
/// ones: then a reflex one lies inside as well.
bool EarClipper::containsVertex(uint32_t ear, Rule rule) {
    if (!anyReflex_) return false;
    const Vertex& v = vertices_[ear];
    const uint32_t place = points_.inside(vertices_[v.previous].position, v.position,
                                          vertices_[v.next].position, rule == Rule::proper);
    if (place == PolygonPoints::kNone) return false;
    watches_.push_back({ear, std::exchange(watched_[place], (uint32_t) watches_.size())});
    return true;
}

bool EarClipper::isEar(uint32_t vertex, Rule rule) {
    switch (rule) {
    case Rule::proper:
    case Rule::noneInside:
        return vertices_[vertex].convex && !containsVertex(vertex, rule);
    case Rule::convex:
        return turnAt(vertex) >= 0.0;
    case Rule::any:
        break;
    }
    return true;
}

/// The next corner from \p from on, around the polygon, that may be an ear; kNone if none may.
uint32_t EarClipper::takeDue(uint32_t from) {
    uint32_t vertex = due_.next(from);
    if (vertex == IndexSet::kNone) vertex = due_.next(0);
    if (vertex != IndexSet::kNone) due_.erase(vertex);
    return vertex;
}

void EarClipper::cut(uint32_t vertex) {
    Vertex& v = vertices_[vertex];
    ears_.push_back({v.previous, vertex, v.next});
    v.cut = true;
    vertices_[v.previous].next = v.next;
    vertices_[v.next].previous = v.previous;
    for (const uint32_t neighbour : {v.previous, v.next}) {
        updateConvexity(neighbour);
        due_.insert(neighbour);
    }
}

std::span<const EarClipper::Ear> EarClipper::operator()(std::span<const glm::vec3> polygon) {
    ears_.clear();
    const uint32_t count = (uint32_t) polygon.size();
    if (count < 3) return ears_;
    if (count == 3) {
        ears_.push_back({0, 1, 2});
        return ears_;
    }
    project(polygon);
    due_.fill(count);
    Rule rule = Rule::proper;
    uint32_t first = 1, from = first; // where a round begins that no corner may pass
    while (ears_.size() < count - 3) {
        const uint32_t vertex = takeDue(from);
        if (vertex == IndexSet::kNone) {
            // Once broken, a polygon stays broken: going back to the stricter rules would only
            // cost time.
            rule = (Rule) ((int) rule + 1);
            for (uint32_t i = 0; i < count; ++i)
                if (!vertices_[i].cut) due_.insert(i);
            from = first;
            continue;
        }
        from = vertices_[vertex].next;
        if (!isEar(vertex, rule)) continue;
        cut(vertex);
        if (count > kMostOfAFan) from = vertices_[from].next;
        first = from;
    }
    ears_.push_back({vertices_[first].previous, first, vertices_[first].next});
    return ears_;
}

} // namespace dirt
