// What the shaders compute of a ray, number for number, against core: crossings and their order,
// the part in a view, weights of triangles, new origins. Hits alone would not tell of a margin that
// is a little too small.

#include "backend_gl/gl_context.h"
#include "backend_gl/grid_views.h"
#include "backend_gl/program.h"
#include "core/grid/denormals.h"
#include "core/trace/intersect.h"
#include "core/trace/offset.h"
#include "core/trace/view_cone.h"
#include "core/trace/view_ray.h"
#include "tests/gl/edited_shaders.h"
#include "tests/support/grid_rays.h"
#include "tests/support/nasty_rays.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
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
};

const char* const kProbe = R"(#version 450 core
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
    int refused;
};
layout(std430, binding = 0) readonly buffer Questions { Question questions[]; };
layout(std430, binding = 1) buffer Answers { Answer answers[]; };
void main() {
    Question q = questions[gl_GlobalInvocationID.x];
    Ray ray = Ray(q.origin, q.direction, 0u);
    Answer r;
    ViewSpan span;
    ViewRay seen = makeViewRay(q.view, ray);
    r.clipped = int(clipToView(seen, span));
    r.begin = span.begin;
    r.end = span.end;
    r.depth = span.depth;
    r.order = orderOf(seen, q.columnBorder, q.rowBorder);
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
    EXPECT_EQ(answer.order,
              ray.order(view.s[(size_t) q.columnBorder], view.t[(size_t) q.rowBorder]))
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

TEST(GlMargins, AreThoseOfCore) {
    const GlContext context;
    context.makeCurrent();
    const FlushDenormals flush;
    Random random(31);
    for (const ViewSet& set : {fullViews(17, 1), fullViews(64, 1), singleView(100, 50, 1, 60.0f)}) {
        Grid grid = makeEmptyGrid(set.camera, set.settings);
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
                if (random.chance(0.5)) { // through the very corner, or an ulp beside it
                    const glm::vec3 corner(view.s[(size_t) q.columnBorder],
                                           view.t[(size_t) q.rowBorder], 1.0f);
                    const glm::vec3 off = nasty.direction();
                    c.ray.origin = fromView(view, corner + off);
                    c.ray.direction = fromView(view, corner) - c.ray.origin;
                }
            }
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
