// What the shaders compute of a ray, number for number, against core: crossings and their order,
// the part in a view, depths in a tile, weights of triangles, new origins. Hits alone would not
// tell of a margin that is a little too small.

#include "backend_gl/gl_context.h"
#include "backend_gl/grid_views.h"
#include "backend_gl/program.h"
#include "core/base/denormals.h"
#include "core/trace/determinant.h"
#include "core/trace/intersect.h"
#include "core/trace/offset.h"
#include "core/trace/view_cone.h"
#include "core/trace/view_walk.h"
#include "tests/gl/edited_shaders.h"
#include "tests/support/grid_rays.h"
#include "tests/support/nasty_rays.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <cfloat>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace dirt::test {
namespace {

constexpr int kCases = 4096;

struct Question {
    glm::vec3 origin;
    int view;
    glm::vec3 direction;
    int columnBorder;
    glm::vec4 a, b; ///< a triangle; w: spare
    glm::vec3 c;
    int rowBorder;
};

struct Answer {
    double begin, end, depth; ///< of the part in the view
    double weights[3];
    float partBegin, partEnd; ///< as ViewCone
    float t, u, v;
    int order, hit, clipped;
    float offset[3];
    int refused; ///< by the filter
    int tile;    ///< where the walk starts, or -1; and the ray's depths there
    float near, far;
};

const char* const kProbe = R"(#version 450 core
#include "include/view_walk.glsl"
#include "include/view_cone.glsl"
#include "include/offset.glsl"
#include "shaders/shared/margins.h"
layout(local_size_x = 64) in;
struct Question {
    vec3 origin;
    int view;
    vec3 direction;
    int columnBorder;
    vec4 a, b;
    vec3 c;
    int rowBorder;
};
struct Answer {
    double begin, end, depth, weights[3];
    float partBegin, partEnd, t, u, v;
    int order, hit, clipped;
    float offset[3];
    int refused, tile;
    float near, far;
};
layout(std430, binding = 0) readonly buffer Questions { Question questions[]; };
layout(std430, binding = 1) buffer Answers { Answer answers[]; };
void main() {
    Question q = questions[gl_GlobalInvocationID.x];
    Ray ray = Ray(q.origin, q.direction, 0u);
    Answer r;
    SeenSpan span;
    SeenRay seen = seenRay(q.view, ray);
    r.clipped = int(clipToView(seen, span));
    r.begin = span.begin;
    r.end = span.end;
    r.depth = span.depth;
    r.order = orderOf(seen, slopeOf(0, q.columnBorder), slopeOf(1, q.rowBorder));
    ViewWalk walk = startWalk(q.view, seen, span, 0);
    TileVisit visit;
    r.tile = -1;
    if (r.clipped != 0 && all(greaterThanEqual(walk.tile, ivec2(0)))) {
        offerTile(walk, exitOf(walk, 0), visit); // the answer depends on a pyramid: none here
        r.tile = walk.tile.y * grid.columns + walk.tile.x;
        r.near = visit.near;
        r.far = visit.far;
    }
    vec2 part = partInView(ray);
    r.partBegin = part.x;
    r.partEnd = part.y;
    TriangleHit hit;
    dvec3 weights;
    Triangle triangle = Triangle(q.a.xyz, q.b.xyz, q.c);
    r.hit = int(intersect(ray, triangle, hit, weights));
    r.t = hit.t;
    r.u = hit.u;
    r.v = hit.v;
    vec3 origin = offsetOrigin(triangle, hit.u, hit.v, q.direction);
    for (int i = 0; i < 3; ++i) {
        r.weights[i] = weights[i];
        r.offset[i] = origin[i];
    }
    r.refused = int(certainlyMisses(makeFilter(ray), ray, triangle));
    answers[gl_GlobalInvocationID.x] = r;
}
)";

/// Asks the shaders.
std::vector<Answer> ask(const Grid& grid, const std::vector<Question>& questions) {
    TemporaryFolder folder;
    for (const std::string& file : ShaderFiles::builtIn())
        folder.write(file, ShaderFiles().read(file));
    folder.write("probe.comp", kProbe);
    const Program program(ShaderFiles(folder.path()), {"probe", {"probe.comp"}, {}, {}});
    GridViews views;
    views.set(grid);
    const GlBuffer input(questions.size() * sizeof(Question), questions.data());
    const GlBuffer output(questions.size() * sizeof(Answer));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, input.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, output.id());
    program.use();
    glDispatchCompute((GLuint) questions.size() / 64, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<Answer> answers(questions.size());
    output.read(0, output.bytes(), answers.data());
    return answers;
}

Ray rayOf(const Question& q) {
    return {q.origin, q.direction, kNoPrimitive};
}

void expectSameView(const Grid& grid, const Question& q, const Answer& answer) {
    const View& view = grid.views[(size_t) q.view];
    const ViewRay ray(view, rayOf(q));
    ViewSpan span;
    const bool clipped = ray.clip(q.view, span);
    ASSERT_EQ(answer.clipped != 0, clipped) << hex(rayOf(q));
    if (clipped) {
        EXPECT_EQ(answer.begin, span.begin) << hex(rayOf(q));
        EXPECT_EQ(answer.end, span.end) << hex(rayOf(q));
        EXPECT_EQ(answer.depth, span.depth) << hex(rayOf(q));
    }
    int tile = -1;
    if (clipped) {
        const double forever = INFINITY;
        ViewWalk walk(ray, span, grid.pyramids[(size_t) q.view], 0);
        if (walk.valid())
            walk.run(
                forever, [](const CellLook&) {},
                [&](const TileVisit& visit) {
                    if (tile >= 0) return;
                    tile = visit.tile;
                    EXPECT_EQ(answer.near, visit.near) << hex(rayOf(q));
                    EXPECT_EQ(answer.far, visit.far) << hex(rayOf(q));
                });
    }
    EXPECT_EQ(answer.tile, tile) << hex(rayOf(q));
    EXPECT_EQ(answer.order,
              orderOf(ray, view.s[(size_t) q.columnBorder], view.t[(size_t) q.rowBorder]))
        << hex(rayOf(q));
    const ViewCone::Part part = ViewCone(grid.views[0]).part(rayOf(q));
    EXPECT_EQ(answer.partBegin, part.begin) << hex(rayOf(q));
    EXPECT_EQ(answer.partEnd, part.end) << hex(rayOf(q));
}

void expectSameHit(const Question& q, const Answer& answer) {
    const Triangle t{glm::vec3(q.a), glm::vec3(q.b), q.c};
    TriangleHit hit;
    ASSERT_EQ(answer.hit != 0, intersect(rayOf(q), t, hit)) << hex(rayOf(q)) << hex(t);
    if (answer.hit == 0) return;
    // The filter is made for coordinates below 2.
    const glm::vec3 size = glm::max(glm::max(glm::abs(t.a), glm::abs(t.b)), glm::abs(t.c));
    if (glm::all(glm::lessThan(size, glm::vec3(2.0f)))) {
        EXPECT_EQ(answer.refused, 0) << hex(rayOf(q)) << hex(t);
    }
    const EdgePlanes::Weights weights = EdgePlanes(q.origin, t).along(q.direction);
    if (std::abs(weights.a + weights.b + weights.c) >= kSureWeights * weights.bound) {
        EXPECT_EQ(answer.weights[0], weights.a) << hex(rayOf(q)) << hex(t);
        EXPECT_EQ(answer.weights[1], weights.b) << hex(rayOf(q)) << hex(t);
        EXPECT_EQ(answer.weights[2], weights.c) << hex(rayOf(q)) << hex(t);
    }
    EXPECT_EQ(answer.t, hit.t) << hex(rayOf(q)) << hex(t);
    EXPECT_EQ(answer.u, flushed(hit.u)) << hex(rayOf(q)) << hex(t);
    EXPECT_EQ(answer.v, flushed(hit.v)) << hex(rayOf(q)) << hex(t);
    const glm::vec3 origin = offsetOrigin(t, flushed(hit.u), flushed(hit.v), q.direction);
    EXPECT_EQ(glm::vec3(answer.offset[0], answer.offset[1], answer.offset[2]), origin)
        << hex(rayOf(q)) << hex(t);
}

/// A ray past a corner of tiles, about as near as the order of its borders can be told.
Ray pastCorner(Random& random, const View& view, glm::vec3 corner) {
    Ray best;
    double nearest = HUGE_VAL;
    for (int i = 0; i < 200; ++i) {
        glm::vec3 origin, direction;
        for (int k = 0; k < 3; ++k) { // some of it so small that double drops it
            const float x = corner[k], ulp = std::nextafter(x, 9.0f * x) - x;
            const float off = ulp * (float) random.range(-99, 99);
            origin[k] = x + off;
            direction[k] = -off * (float) (1.0 + random.uniform(-1, 1) * 0x1p-22);
            if (random.chance(0.3)) direction[k] *= (float) random.powerOfTwo(-30, 0);
        }
        const Ray ray{fromView(view, origin), fromView(view, direction), kNoPrimitive};
        const glm::dvec3 terms = ViewRay(view, ray).moment * glm::dvec3(corner);
        const double part = std::abs((terms.x + terms.y) + terms.z) /
                            (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z));
        const double off = std::abs(std::log2(part) + 51.5);
        if (off < nearest) nearest = off, best = ray;
    }
    return best;
}

/// A ray so close to a triangle's plane that double is about to be in doubt of its t, and wrong by
/// much.
RayCase grazing(Random& random) {
    const auto point = [&] {
        return glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    const auto norm = [](const glm::dvec3& p) {
        return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    };
    RayCase best{};
    double worst = -1.0;
    for (int i = 0; i < 50; ++i) {
        Triangle t{glm::vec3(point()), glm::vec3(point()), glm::vec3(point())};
        for (glm::vec3* p : {&t.a, &t.b, &t.c})
            (*p)[random.below(3)] *= (float) random.powerOfTwo(-40, -20); // differences round
        const glm::dvec3 a(t.a), ab = glm::dvec3(t.b) - a, ac = glm::dvec3(t.c) - a;
        const glm::dvec3 normal = glm::cross(ab, ac), inside = a + 0.3 * ab + 0.3 * ac;
        const glm::vec3 origin(inside + ab * random.uniform(-1, 1) + ac * random.uniform(-1, 1) +
                               glm::normalize(normal) * std::exp2(random.uniform(-20, -17)));
        const glm::dvec3 toA = a - glm::dvec3(origin);
        const double value = glm::dot(normal, toA),
                     exact = planeDeterminantExact(origin, t.a, t.b, t.c);
        const double part =
            std::abs(value) / (norm(ab) * norm(ac) * glm::dot(glm::abs(toA), glm::dvec3(1)));
        const double off = part < 0x1p-20 && part > 0x1p-21 ? std::abs(value / exact + 1.0) : 0.0;
        if (off <= worst) continue;
        worst = off;
        best = {{origin, glm::vec3(inside - glm::dvec3(origin))}, t, "grazing"};
    }
    return best;
}

TEST(GlMargins, AreThoseOfCore) {
    const GlContext context;
    context.makeCurrent();
    const FlushDenormals flush;
    Random random(31);
    for (const ViewSet& set : {fullViews(17, 1), fullViews(64, 1), singleView(100, 50, 1, 60.0f)}) {
        Grid grid = makeEmptyGrid(set.camera, set.settings);
        for (DepthPyramid& pyramid : grid.pyramids) {
            for (DepthBounds& bounds : pyramid.levels[0].bounds) bounds = {0.0f, FLT_MAX};
            buildPyramid(pyramid);
        }
        GridRays rays(random, set);
        NastyRays nasty(random);
        std::vector<Question> questions;
        while (questions.size() < kCases) {
            Question q{};
            q.view = random.below((int) set.views.size());
            const View& view = set.views[(size_t) q.view];
            q.columnBorder = random.below(view.columns + 1);
            q.rowBorder = random.below(view.rows + 1);
            RayCase c = nasty.next();
            if (random.chance(0.5)) {
                c.ray = rays.next().ray;
                const glm::vec3 corner(view.s[(size_t) q.columnBorder],
                                       view.t[(size_t) q.rowBorder], 1.0f);
                if (random.chance(0.2)) {
                    c.ray = pastCorner(random, view, corner);
                } else if (random.chance(0.5)) { // through the very corner, or an ulp beside it
                    const glm::vec3 off = nasty.direction();
                    c.ray.origin = fromView(view, corner + off);
                    c.ray.direction = fromView(view, corner) - c.ray.origin;
                }
            }
            if (random.chance(0.1)) {
                // To a border in the middle, at a depth that double does not tell from 1.
                c.ray = {fromView(view, {0x1p-60f, 0.25f, 1.0f}),
                         fromView(view, {-1.0f, 0.0f, (float) random.sign()}), kNoPrimitive};
            }
            if (random.chance(0.2)) c = grazing(random);
            if (random.chance(0.25)) { // a needle, thinner than roundings
                const int axis = random.below(3);
                for (int i = 0; i < 2; ++i) {
                    const int k = (axis + i) % 3;
                    const float thin = (float) random.powerOfTwo(-50, -10);
                    for (glm::vec3* p : {&c.triangle.a, &c.triangle.b, &c.triangle.c, &c.ray.origin,
                                         &c.ray.direction})
                        (*p)[k] *= thin;
                }
            }
            for (int i = 0; i < 3; ++i) {
                c.ray.origin[i] = flushed(c.ray.origin[i]);
                c.ray.direction[i] = flushed(c.ray.direction[i]);
            }
            if (!isTraceable(c.ray)) continue;
            q.origin = c.ray.origin;
            q.direction = c.ray.direction;
            q.a = glm::vec4(c.triangle.a, 0), q.b = glm::vec4(c.triangle.b, 0), q.c = c.triangle.c;
            questions.push_back(q);
        }
        const std::vector<Answer> answers = ask(grid, questions);
        for (size_t i = 0; i < questions.size(); ++i) {
            expectSameView(grid, questions[i], answers[i]);
            expectSameHit(questions[i], answers[i]);
            if (HasFailure()) return;
        }
    }
}

} // namespace
} // namespace dirt::test
