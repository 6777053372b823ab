// Whether dirt check notices a fault of the passes of construction in GLSL: edited shaders, one
// fault each.

#include "backend_cpu/cpu_backend.h"
#include "backend_gl/gl_backend.h"
#include "core/check/check.h"
#include "tests/gl/edited_shaders.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

namespace dirt::test {
namespace {

/// A mesh that needs every part of every pass: large and small triangles, degenerate ones, ones on
/// the borders of tiles, and one around the eye.
Mesh difficultMesh(const ViewSet& set) {
    Random random(7);
    const std::vector<ViewSet> sets{set};
    NastyTriangles nasty(random, sets);
    std::vector<Triangle> triangles{{{0.5f, 0, 0}, {-0.5f, 0.5f, 0}, {-0.5f, -0.5f, 0}}};
    for (int i = 0; i < 400; ++i) triangles.push_back(nasty.next().triangle);
    addSoup(random, triangles, 100);
    addRoom(random, triangles);
    Mesh mesh;
    for (const Triangle& t : triangles) {
        const auto first = (uint32_t) mesh.positions.size();
        mesh.positions.insert(mesh.positions.end(), {t.a, t.b, t.c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// The buffers, as "pass: buffer", in whose rows of \p gl something differs.
std::set<std::string> caught(const GlOptions& options, const Camera& camera = {}) {
    const ViewSet set = fullViews(90, 7);
    SerialExecutor executor;
    CpuBackend cpu(executor);
    GlBackend gl(options);
    std::set<std::string> different;
    for (const CheckRow& row :
         checkConstruction(difficultMesh(set), camera, set.settings, cpu, gl)) {
        EXPECT_EQ(row.compared, row.equal + row.withinTolerance + row.different);
        if (row.different == 0) continue;
        EXPECT_FALSE(row.examples.empty());
        different.insert(row.pass + ": " + row.buffer);
    }
    return different;
}

std::set<std::string> caughtFault(const std::string& file, const std::string& from,
                                  const std::string& to, const Camera& camera = {}) {
    const EditedShaders shaders;
    shaders.replace(file, from, to);
    GlOptions options;
    options.shaders = shaders.files();
    return caught(options, camera);
}

using Rows = std::set<std::string>;

const Rows kDecision = {"FillDepth: depth bounds", "FillPrimitives: lists"};

TEST(Check, FindsNoDifferenceOnADifficultMesh) {
    EXPECT_EQ(caught({}), Rows{});
}

TEST(Check, CatchesFaultsOfTheTransform) {
    Camera aside;
    aside.eye = {0.125f, 0.25f, -0.5f};
    const Rows row = {"FillDepth: triangle buffer"};
    EXPECT_EQ(caughtFault("transform.vert", "world - eye", "world", aside), row);
    EXPECT_EQ(caughtFault("scale_triangles.comp", "* scale", "* (0.5 * scale)"), row);
    EXPECT_EQ(caughtFault("largest_coordinate.comp", "& 0x7fffffffu", "& 0x7f000000u"), row);
}

TEST(Check, CatchesFaultsOfFillDepth) {
    const Rows row = {"FillDepth: depth bounds"};
    EXPECT_EQ(caughtFault("fill_depth.frag", "bounds = vec2(-depths.x",
                          "bounds = vec2(-uintBitsToFloat(floatBitsToUint(depths.x) + 1u)"),
              row);
}

TEST(Check, CatchesFaultsOfFillDepthMipmap) {
    const Rows rows = caughtFault("fill_depth_mipmap.comp", "child < 4", "child < 3");
    EXPECT_TRUE(rows.contains("FillDepthMipmap: depth pyramid, level 1"));
    for (const std::string& row : rows) EXPECT_TRUE(row.starts_with("FillDepthMipmap")) << row;
}

TEST(Check, CatchesFaultsOfFillPrimitives) {
    const Rows lists = {"FillPrimitives: lists"};
    EXPECT_EQ(caughtFault("include/bins.glsl", "* map.scale", "* (map.scale * 1.001)"), lists);
    EXPECT_EQ(caughtFault("triangles_at_eye.comp", "firstId + triangle", "firstId + triangle + 1u"),
              Rows{"FillPrimitives: triangles at the eye"});
}

/// Entries that the passes of \p options, each fed the CPU's buffers, get wrong: counted one by one
/// here, without core's comparison.
std::map<std::string, uint64_t> trulyWrong(const GlOptions& options) {
    const ViewSet set = fullViews(90, 7);
    SerialExecutor executor;
    CpuBackend cpu(executor);
    cpu.build(difficultMesh(set), Camera{}, set.settings);
    const Grid right = cpu.readGrid();
    std::map<std::string, uint64_t> wrong;
    GlBackend gl(options);
    gl.clear(Camera{}, set.settings);
    gl.setGeometry(cpu.readGeometry());
    gl.fillDepth();
    const Grid depths = gl.readGrid();
    for (size_t view = 0; view < right.views.size(); ++view)
        for (int tile = 0; tile < right.views[view].columns * right.views[view].rows; ++tile) {
            const DepthBounds &a = right.bounds((int) view, tile),
                              b = depths.bounds((int) view, tile);
            wrong["FillDepth: depth bounds"] += a.near != b.near || a.far != b.far;
        }
    Grid empty = right;
    empty.ids.clear();
    std::fill(empty.heads.begin(), empty.heads.end(), 0u);
    gl.writeGrid(empty);
    gl.fillPrimitives();
    const Grid lists = gl.readGrid();
    for (size_t cell = 0; cell + 1 < right.heads.size(); ++cell) {
        const auto ids = [&](const Grid& grid) {
            return std::set<uint32_t>(grid.ids.begin() + grid.heads[cell],
                                      grid.ids.begin() + grid.heads[cell + 1]);
        };
        const std::set<uint32_t> a = ids(right), b = ids(lists);
        for (const uint32_t id : a) wrong["FillPrimitives: lists"] += !b.contains(id);
        for (const uint32_t id : b) wrong["FillPrimitives: lists"] += !a.contains(id);
    }
    return wrong;
}

/// That GL's passes on the CPU's data differ in \p rows alone, by as many entries as are wrong.
void expectCounted(const GlOptions& options, const Rows& rows) {
    const std::map<std::string, uint64_t> wrong = trulyWrong(options);
    const ViewSet set = fullViews(90, 7);
    SerialExecutor executor;
    CpuBackend cpu(executor);
    GlBackend gl(options);
    for (const CheckRow& row : checkConstruction(difficultMesh(set), {}, set.settings, cpu, gl)) {
        if (row.tested != "gl") continue;
        const std::string name = row.pass + ": " + row.buffer;
        EXPECT_EQ(row.different > 5, rows.contains(name)) << name << ": " << row.different;
        EXPECT_EQ(row.different, wrong.contains(name) ? wrong.at(name) : 0u) << name;
    }
}

void expectCountedFault(const std::string& file, const std::string& from, const std::string& to,
                        const Rows& rows) {
    SCOPED_TRACE(to);
    const EditedShaders shaders;
    shaders.replace(file, from, to);
    GlOptions options;
    options.shaders = shaders.files();
    expectCounted(options, rows);
}

TEST(Check, CountsWhatIsTrulyWrong) {
    expectCountedFault("fill_depth.frag", "-depths.x, depths.y", "-depths.x, depths.x",
                       {"FillDepth: depth bounds"});
    const Rows lists = {"FillPrimitives: lists"};
    expectCountedFault("fill_primitives.frag", "bin <= last", "bin < last", lists);
    expectCountedFault("fill_primitives.frag", "uvec2(next, primitive)",
                       "uvec2(next, primitive ^ 1u)", lists);
}

/// Of the parts that FillDepth and FillPrimitives share.
TEST(Check, CatchesFaultsOfTheDecision) {
    EXPECT_EQ(caughtFault("include/coverage.glsl", "if (inside < 0.0)", "if (inside < 1.0e-4)"),
              kDecision);
    EXPECT_EQ(caughtFault("include/coverage.glsl", "a.z >= 0.0", "a.z > 0.0"), kDecision);
    EXPECT_EQ(caughtFault("include/coverage.glsl", "(a.z > 0.0 && b.z < 0.0)", "false"), kDecision);
    EXPECT_EQ(caughtFault("include/clip.glsl", "1.0LF + margin", "1.0LF"), kDecision);
    EXPECT_EQ(caughtFault("include/clip.glsl", "signOf(p) * signOf(q) > 0", "false"), kDecision);
    EXPECT_EQ(caughtFault("include/views.glsl", "axes.w < 0", "axes.w < -1"), kDecision);
}

/// The proposal decides nothing, so a loose one changes nothing; but it must not be too tight.
TEST(Check, ToleratesALooseProposalAndCatchesATightOne) {
    EXPECT_EQ(caughtFault("propose_tiles.geom", "ivec2 columns = ",
                          "ivec2 columns = true ? ivec2(0, grid.columns - 1) : "),
              Rows{});
    expectCountedFault("propose_tiles.geom", "vec2(columns.y + 1", "vec2(columns.y", kDecision);
    GlOptions plain; // triangles, without conservative rasterization where this is tested
    plain.proposal = Proposal::triangles;
    if (GlContext context; epoxy_has_gl_extension("GL_NV_conservative_raster"))
        GTEST_SKIP() << "this driver rasterizes conservatively";
    expectCounted(plain, kDecision);
}

} // namespace
} // namespace dirt::test
