// Whether dirt check notices a fault of the passes of construction in GLSL: edited shaders, one
// fault each.

#include "backend_cpu/cpu_backend.h"
#include "backend_gl/gl_backend.h"
#include "core/check/check.h"
#include "tests/gl/overlapping_halves.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <span>

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
    EXPECT_EQ(caughtFault("largest_coordinate.comp", "& 0x7fffffffu", "& 0x7f000000u"), row);
}

TEST(Check, CatchesFaultsOfFillDepth) {
    const Rows row = {"FillDepth: depth bounds"};
    EXPECT_EQ(caughtFault("fill_depth.frag", "bounds = vec2(-depths.x",
                          "bounds = vec2(-uintBitsToFloat(floatBitsToUint(depths.x) + 1u)"),
              row);
}

TEST(Check, CatchesFaultsOfFillPrimitives) {
    const Rows lists = {"FillPrimitives: lists"};
    EXPECT_EQ(caughtFault("shared/bins.h", "* perDepth", "* (perDepth * 1.001f)"), lists);
}

/// Cells of one level whose depths differ.
uint64_t wrongCells(const Grid& right, const Grid& found, size_t level) {
    uint64_t wrong = 0;
    for (size_t view = 0; view < right.views.size(); ++view) {
        const auto& a = right.pyramids[view].levels[level].bounds;
        const auto& b = found.pyramids[view].levels[level].bounds;
        for (size_t i = 0; i < a.size(); ++i)
            wrong += a[i].near != b[i].near || a[i].far != b[i].far;
    }
    return wrong;
}

uint64_t inOneAlone(std::span<const uint32_t> left, std::span<const uint32_t> right) {
    const std::multiset<uint32_t> a(left.begin(), left.end()), b(right.begin(), right.end());
    std::set<uint32_t> ids(left.begin(), left.end());
    ids.insert(right.begin(), right.end());
    uint64_t count = 0;
    for (const uint32_t id : ids) {
        const size_t in[] = {a.count(id), b.count(id)};
        count += std::max(in[0], in[1]) - std::min(in[0], in[1]);
    }
    return count;
}

uint64_t wrongCoordinates(const FrameGeometry& right, const FrameGeometry& found) {
    uint64_t wrong = 0;
    for (size_t i = 0; i < right.triangles.size(); ++i) {
        const Triangle &a = right.triangles[i], &b = found.triangles[i];
        for (int k = 0; k < 3; ++k)
            wrong += (a.a[k] != b.a[k]) + (a.b[k] != b.b[k]) + (a.c[k] != b.c[k]);
    }
    return wrong;
}

/// Entries that the passes of \p options, each fed the CPU's buffers, get wrong: counted one by one
/// here, without core's comparison.
std::map<std::string, uint64_t> trulyWrong(const GlOptions& options) {
    const ViewSet set = fullViews(90, 7);
    const Mesh mesh = difficultMesh(set);
    SerialExecutor executor;
    CpuBackend cpu(executor);
    cpu.build(mesh, Camera{}, set.settings);
    const Grid right = cpu.readGrid();
    const size_t levels = right.pyramids[0].levels.size();
    std::map<std::string, uint64_t> wrong;

    GlBackend gl(options);
    gl.clear(Camera{}, set.settings);
    gl.transform(mesh, Camera{}, ViewMode::full);
    wrong["FillDepth: triangle buffer"] = wrongCoordinates(cpu.readGeometry(), gl.readGeometry());
    gl.setGeometry(cpu.readGeometry());
    gl.fillDepth();
    wrong["FillDepth: depth bounds"] = wrongCells(right, gl.readGrid(), 0);

    Grid empty = right;
    empty.ids.clear();
    std::fill(empty.heads.begin(), empty.heads.end(), 0u);
    for (DepthPyramid& pyramid : empty.pyramids) pyramid.levels.resize(1);
    gl.writeGrid(empty);
    gl.fillDepthMipmap();
    for (size_t level = 1; level < levels; ++level)
        wrong["FillDepthMipmap: depth pyramid, level " + std::to_string(level)] =
            wrongCells(right, gl.readGrid(), level);

    empty.pyramids = right.pyramids;
    gl.writeGrid(empty);
    gl.fillPrimitives();
    const Grid lists = gl.readGrid();
    wrong["FillPrimitives: triangles at the eye"] = inOneAlone(right.atEye, lists.atEye);
    const auto ids = [](const Grid& grid, size_t cell) {
        return std::span(grid.ids).subspan(grid.heads[cell],
                                           grid.heads[cell + 1] - grid.heads[cell]);
    };
    for (size_t cell = 0; cell + 1 < right.heads.size(); ++cell)
        wrong["FillPrimitives: lists"] += inOneAlone(ids(right, cell), ids(lists, cell));
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
        EXPECT_EQ(row.different > 0, rows.contains(name)) << name << ": " << row.different;
        EXPECT_EQ(row.different, wrong.at(name)) << name;
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
    expectCountedFault("scale_triangles.comp", "* scale", "* (0.5 * scale)",
                       {"FillDepth: triangle buffer"});
    const std::string level = "FillDepthMipmap: depth pyramid, level ";
    expectCountedFault("fill_depth_mipmap.comp", "child < 4", "child < 3",
                       {level + "1", level + "2", level + "3", level + "4"});
    expectCountedFault("triangles_at_eye.comp", "firstId + triangle", "firstId + triangle + 1u",
                       {"FillPrimitives: triangles at the eye"});
    expectCountedFault("fill_depth.frag", "-depths.x, depths.y", "-depths.x, depths.x",
                       {"FillDepth: depth bounds"});
    const Rows lists = {"FillPrimitives: lists"};
    expectCountedFault("fill_primitives.frag", "bin <= last", "bin < last", lists);
    expectCountedFault("fill_primitives.frag", "uvec2(next, primitive)",
                       "uvec2(next, primitive ^ 1u)", lists);
}

/// Of the parts that FillDepth and FillPrimitives share.
TEST(Check, CatchesFaultsOfTheDecision) {
    EXPECT_EQ(caughtFault("shared/tile_coverage.h", "inside < 0.0f", "inside < 1.0e-4f"),
              kDecision);
    EXPECT_EQ(caughtFault("include/coverage.glsl", "a.z >= 0.0", "a.z > 0.0"), kDecision);
    EXPECT_EQ(caughtFault("include/coverage.glsl", "(a.z > 0.0 && b.z < 0.0)", "false"), kDecision);
    EXPECT_EQ(caughtFault("shared/tile_clip.h", "1.0 + kDepthMargin", "1.0"), kDecision);
    EXPECT_EQ(caughtFault("shared/tile_clip.h", "signOf(p) * signOf(q) > 0", "false"), kDecision);
    EXPECT_EQ(caughtFault("include/views.glsl", "axes.w < 0", "axes.w < -1"), kDecision);
}

/// The proposal decides nothing, so a loose one changes nothing; but it must not be too tight.
TEST(Check, ToleratesALooseProposalAndCatchesATightOne) {
    EXPECT_EQ(caughtFault("propose_tiles.geom", "ivec2 columns = ",
                          "ivec2 columns = true ? ivec2(0, grid.columns - 1) : "),
              Rows{});
    expectCountedFault("propose_tiles.geom", "columns.y - columns.x + 1", "columns.y - columns.x",
                       kDecision);
    GlOptions plain; // triangles, without conservative rasterization where this is tested
    plain.proposal = Proposal::triangles;
    if (GlContext context; epoxy_has_gl_extension("GL_NV_conservative_raster"))
        GTEST_SKIP() << "this driver rasterizes conservatively";
    expectCounted(plain, kDecision);
}

/// As where rasterization is conservative: a tile offered twice is listed once, and a list with an
/// entry too many is seen.
TEST(Check, ListsOnceWhatIsProposedTwiceAndCatchesRepeatedEntries) {
    const EditedShaders shaders;
    overlapHalves(shaders);
    GlOptions options;
    options.shaders = shaders.files();
    options.proposal = Proposal::triangles;
    expectCounted(options, {});
    ownAllTiles(shaders);
    options.shaders = shaders.files();
    expectCounted(options, {"FillPrimitives: lists"});
}

} // namespace
} // namespace dirt::test
