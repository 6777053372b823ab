// dirt check over backends on the host: what is right passes, row by row, and a known number of
// wrong entries of one pass shows in its row, with that number, and nowhere else.

#include "core/check/check.h"

#include "backend_cpu/cpu_backend.h"
#include "tests/check/faulty_backend.h"
#include "tests/check/plain_backend.h"
#include "tests/frame/brute_force_backend.h"
#include "tests/frame/shapes.h"
#include "tests/support/random.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

RenderSettings smallImage(ViewMode mode = ViewMode::full) {
    RenderSettings settings;
    settings.grid.mode = mode;
    settings.grid.width = 48;
    settings.grid.height = 32;
    settings.grid.tile = 4;
    settings.grid.bins = 4;
    settings.bounces = 3;
    return settings;
}

std::string text(const CheckRow& row) {
    std::string text = row.pass + " " + std::to_string(row.event) + ", " + row.buffer + ", " +
                       row.tested + " on " + row.source + ": " + std::to_string(row.different) +
                       " of " + std::to_string(row.compared) + " differ";
    for (const std::string& example : row.examples) text += "\n  " + example;
    return text;
}

std::string nameOf(const CheckRow& row) {
    return row.pass + (row.event < 0 ? "" : " " + std::to_string(row.event)) + ": " + row.buffer;
}

/// The rows of one direction, by name.
std::vector<std::string> rowsOf(const CheckReport& report, const std::string& tested) {
    std::vector<std::string> names;
    for (const CheckRow& row : report.rows)
        if (row.tested == tested) names.push_back(nameOf(row));
    return names;
}

void expectEqual(const CheckReport& report) {
    EXPECT_TRUE(report.passed());
    for (const CheckRow& row : report.rows) EXPECT_EQ(row.equal, row.compared) << text(row);
    EXPECT_EQ(report.means[0], report.means[1]);
    EXPECT_GT(report.means[0].x, 0.0);
}

/// The rows of a sample with \p bounces.
std::vector<std::string> sampleRows(bool rasterized, int bounces) {
    std::vector<std::string> rows{"Clear 0: radiance"};
    const auto add = [&rows](const std::string& pass, int k, const std::string& buffer) {
        rows.push_back(pass + " " + std::to_string(k) + ": " + buffer);
    };
    for (int k = 0; k < bounces; ++k) {
        if (k > 0) add("DepthMask", k, "mask");
        if (k == 0 && rasterized) {
            add("DirectVisibility", k, "shading buffer G[k+1]");
        } else {
            add("Rays", k, "rays");
            add("Trace", k, "hit buffer");
            add("Fetch", k, "shading buffer G[k+1]");
            add("Fetch", k, "hit buffer");
        }
        add("Visibility", k, "visibility");
        add("Shade", k, "radiance");
        add("Shift", k, "shading buffer G[k-1]");
        add("Shift", k, "shading buffer G[k]");
    }
    rows.push_back("Resolve 0: image");
    rows.push_back("every pass: what it must not write");
    return rows;
}

TEST(Check, CpuBackendEqualsThePlainDefinitionInEveryRow) {
    SerialExecutor executor;
    const Scene scene = room();
    for (const ViewMode mode : {ViewMode::full, ViewMode::single})
        for (const Fetch fetch : {Fetch::raster, Fetch::direct})
            for (const Primary primary : {Primary::raster, Primary::traced}) {
                RenderSettings settings = smallImage(mode);
                settings.fetch = fetch;
                settings.primary = primary;
                CpuBackend cpu(executor);
                PlainBackend plain(executor);
                const CheckReport report = checkBackends(scene, settings, plain, cpu);
                expectEqual(report);
                std::vector<std::string> rows = rowsOf(report, "plain");
                std::erase_if(rows, [](const std::string& row) { return row.starts_with("Fill"); });
                EXPECT_EQ(rows, sampleRows(primary == Primary::raster, 3));
                rows = rowsOf(report, "cpu");
                EXPECT_EQ(rows[0], "FillDepth: triangle buffer");
                EXPECT_EQ(rows[1], "FillDepth: depth bounds");
                EXPECT_EQ(rows[2], "FillDepthMipmap: depth pyramid, level 1");
                EXPECT_TRUE(std::count(rows.begin(), rows.end(), "FillPrimitives: lists"));
            }
}

TEST(Check, BackendsWithoutAGridAreComparedInWhatTheyShare) {
    SerialExecutor executor;
    CpuBackend cpu(executor);
    BruteForceBackend bruteForce(executor);
    const CheckReport report = checkBackends(room(), smallImage(), cpu, bruteForce);
    expectEqual(report);
    std::vector<std::string> rows = rowsOf(report, "brute force");
    EXPECT_EQ(rows[0], "FillDepth: triangle buffer");
    rows.erase(rows.begin());
    EXPECT_EQ(rows, sampleRows(false, 3));
    EXPECT_EQ(rowsOf(report, "cpu"), sampleRows(false, 3));
    Scene holes = room();
    holes.materials[1].opacity = 0.25f; // neither the left wall nor the box is there
    expectEqual(checkBackends(holes, smallImage(), cpu, bruteForce));
#ifdef DIRT_HAVE_EMBREE
    EmbreeBackend embree(executor);
    expectEqual(checkBackends(room(), smallImage(), cpu, embree));
    expectEqual(checkBackends(holes, smallImage(), embree, cpu));
#endif
}

/// Two backends that agree may both be wrong.
TEST(Check, WhatIsNotFiniteFails) {
    SerialExecutor executor;
    const float nan = std::nanf(""), inf = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, inf}) {
        CpuBackend one(executor), other(executor);
        const Fault fault{"Shade", 1, [bad](PathBuffers& paths) { paths.radiance[50].y = bad; }};
        FaultyBackend first(one, fault), second(other, fault);
        const CheckReport report = checkBackends(room(), smallImage(), first, second);
        EXPECT_FALSE(report.passed());
        const auto row = std::find_if(report.rows.begin(), report.rows.end(), [](const auto& r) {
            return nameOf(r) == "Shade 1: radiance";
        });
        ASSERT_NE(row, report.rows.end());
        ASSERT_EQ(row->different, 1u);
        EXPECT_EQ(row->examples[0],
                  std::string("pixel 2,1: G is ") + (std::isnan(bad) ? "nan" : "inf"));
    }
}

/// How often the rows named by the keys have to differ, in either direction. All others must not.
using Expected = std::map<std::string, uint64_t>;

void expectCaught(const Fault& fault, const Expected& expected, const RenderSettings& settings) {
    SCOPED_TRACE(fault.pass + " " + std::to_string(fault.event));
    SerialExecutor executor;
    CpuBackend cpu(executor), inner(executor);
    FaultyBackend faulty(inner, fault);
    const CheckReport report = checkBackends(room(), settings, cpu, faulty);
    std::map<std::string, int> seen;
    for (const CheckRow& row : report.rows) {
        const auto found = expected.find(nameOf(row));
        const uint64_t different = found == expected.end() ? 0 : found->second;
        EXPECT_EQ(row.different, different) << text(row);
        EXPECT_EQ(row.compared, row.equal + row.withinTolerance + row.different);
        EXPECT_EQ(row.examples.size(), std::min<uint64_t>(different, kExamples));
        if (different > 0) ++seen[nameOf(row)];
    }
    for (const auto& [name, count] : expected)
        EXPECT_EQ(seen[name], name == "FillDepth: triangle buffer" ? 1 : 2) << name;
    EXPECT_FALSE(report.passed());
}

/// Different places below \p size.
std::vector<size_t> somePlaces(Random& random, size_t size, size_t count) {
    std::set<size_t> places;
    while (places.size() < count) places.insert((size_t) random.below((int) size));
    return {places.begin(), places.end()};
}

float nextAbove(float x) {
    return std::nextafter(x, INFINITY);
}

/// A way to spoil one record of a pass.
struct Spoiling {
    const char* pass;
    const char* buffer;
    std::function<void(PathBuffers&, size_t)> spoil;
};

const Spoiling kSpoilings[] = {
    {"Clear", "radiance", [](PathBuffers& p, size_t i) { p.radiance[i].z = 0x1p-100f; }},
    {"DirectVisibility", "shading buffer G[k+1]",
     [](PathBuffers& p, size_t i) { p.next[i].diffuse.y += 0.25f; }},
    {"DepthMask", "mask", [](PathBuffers& p, size_t i) { p.mask[i] ^= 1; }},
    {"Rays", "rays",
     [](PathBuffers& p, size_t i) { p.rays[i].direction.z = nextAbove(p.rays[i].direction.z); }},
    {"Rays", "rays", [](PathBuffers& p, size_t i) { p.rays[i].pdf += 1.0f; }},
    {"Trace", "hit buffer", [](PathBuffers& p, size_t i) { p.hits[i].t = nextAbove(p.hits[i].t); }},
    {"Trace", "hit buffer",
     [](PathBuffers& p, size_t i) { p.hits[i].primitive = p.hits[i].primitive == 7 ? 8 : 7; }},
    {"Trace", "hit buffer",
     [](PathBuffers& p, size_t i) { p.hits[i].tile = p.hits[i].tile == 1 ? 2 : 1; }},
    {"Fetch", "shading buffer G[k+1]",
     [](PathBuffers& p, size_t i) { p.next[i].shadingNormal.x += 0.5f; }},
    {"Fetch", "hit buffer", [](PathBuffers& p, size_t i) { ++p.hits[i].fetches; }},
    {"Visibility", "visibility", [](PathBuffers& p, size_t i) { p.visibility[i] ^= 1; }},
    {"Shade", "radiance",
     [](PathBuffers& p, size_t i) { p.radiance[i].x = nextAbove(p.radiance[i].x); }},
    {"Shift", "shading buffer G[k]", [](PathBuffers& p, size_t i) { p.current[i].u += 1.0f; }},
    {"Shift", "shading buffer G[k-1]",
     [](PathBuffers& p, size_t i) { p.previous[i].position.x += 1.0f; }},
    {"Resolve", "image", [](PathBuffers& p, size_t i) { p.image[i].y = nextAbove(p.image[i].y); }},
};

TEST(Check, CountsTheWrongRecordsOfAPassInItsRow) {
    Random random(3);
    for (const Spoiling& spoiling : kSpoilings) {
        const std::string pass = spoiling.pass;
        const bool once = pass == "Clear" || pass == "DirectVisibility" || pass == "Resolve";
        const bool later =
            pass == "DepthMask" || pass == "Rays" || pass == "Trace" || pass == "Fetch";
        const int event = once ? 0 : random.range(later ? 1 : 0, 2);
        const RenderSettings settings =
            smallImage(random.chance(0.5) ? ViewMode::full : ViewMode::single);
        const auto places = somePlaces(random, 48 * 32, (size_t) random.range(1, 40));
        Fault fault{pass, event};
        fault.spoilPaths = [&](PathBuffers& paths) {
            for (size_t i : places) spoiling.spoil(paths, i);
        };
        const std::string row = pass + " " + std::to_string(event) + ": " + spoiling.buffer;
        expectCaught(fault, {{row, places.size()}}, settings);
    }
}

TEST(Check, AShadowMapHasARowWhereThereIsOne) {
    SerialExecutor executor;
    Scene scene = room();
    scene.lights[0].resolution = 50;
    RenderSettings settings = smallImage();
    settings.visibility = LightVisibility::shadowMap;
    CpuBackend cpu(executor);
    PlainBackend plain(executor);
    const CheckReport report = checkBackends(scene, settings, plain, cpu);
    expectEqual(report);
    std::vector<std::string> rows = rowsOf(report, "cpu");
    std::erase_if(rows, [](const std::string& row) { return row.starts_with("Fill"); });
    std::vector<std::string> expected = sampleRows(true, 3);
    std::erase_if(expected, [](const std::string& row) { return row.starts_with("Visib"); });
    expected.insert(expected.begin(), "ShadowMap: shadow map");
    EXPECT_EQ(rows, expected);

    Fault fault{"ShadowMap", -1};
    fault.spoilShadowMap = [](std::vector<float>& depths) {
        for (size_t i : {3, 700, 701}) depths[i] = nextAbove(depths[i]);
    };
    CpuBackend inner(executor);
    FaultyBackend faulty(inner, fault);
    for (const CheckRow& row : checkBackends(scene, settings, cpu, faulty).rows)
        EXPECT_EQ(row.different, row.pass == "ShadowMap" ? 3u : 0u) << text(row);
}

TEST(Check, CountsWhatAPassMustNotWrite) {
    Random random(4);
    const auto places = somePlaces(random, 48 * 32, 7);
    Fault fault{"Trace", 1};
    fault.spoilPaths = [&](PathBuffers& paths) {
        for (size_t i : places) paths.radiance[i].x += 1.0f;
    };
    // Seen from the other side, the pass that is right leaves alone what the faulty one has not.
    SerialExecutor executor;
    CpuBackend cpu(executor), inner(executor);
    FaultyBackend faulty(inner, fault);
    for (const CheckRow& row : checkBackends(room(), smallImage(), cpu, faulty).rows)
        EXPECT_EQ(row.different,
                  row.pass == "every pass" && row.tested == "faulty" ? places.size() : 0)
            << text(row);
}

/// The last entry of every tenth list so many times: 0 leaves it out.
void repeatLast(Grid& grid, int times) {
    std::vector<uint32_t> ids, heads{0};
    for (size_t cell = 0; cell + 1 < grid.heads.size(); ++cell) {
        const auto list =
            std::span(grid.ids).subspan(grid.heads[cell], grid.heads[cell + 1] - grid.heads[cell]);
        for (size_t i = 0; i < list.size(); ++i)
            ids.insert(ids.end(), cell % 10 == 0 && i + 1 == list.size() ? times : 1, list[i]);
        heads.push_back((uint32_t) ids.size());
    }
    grid.ids = ids;
    grid.heads = heads;
}

TEST(Check, CountsTheWrongEntriesOfTheConstruction) {
    Random random(5);
    const RenderSettings settings = smallImage();
    Fault fault{"FillDepth", -1};
    fault.spoilGrid = [](Grid& grid) {
        for (int tile : {3, 17, 40}) grid.pyramids[2].levels[0].bounds[tile].far = 3.0f;
    };
    expectCaught(fault, {{"FillDepth: depth bounds", 3}}, settings);

    fault = {"FillDepthMipmap", -1};
    fault.spoilGrid = [](Grid& grid) {
        for (int cell : {0, 5}) grid.pyramids[4].levels[1].bounds[cell].near = 0.0f;
    };
    expectCaught(fault, {{"FillDepthMipmap: depth pyramid, level 1", 2}}, settings);

    fault = {"FillPrimitives", -1};
    fault.spoilGrid = [](Grid& grid) { repeatLast(grid, 0); };
    SerialExecutor executor;
    CpuBackend cpu(executor);
    cpu.build(room().mesh, room().camera, settings.grid);
    Grid less = cpu.grid();
    fault.spoilGrid(less);
    ASSERT_LT(less.ids.size(), cpu.grid().ids.size());
    expectCaught(fault, {{"FillPrimitives: lists", cpu.grid().ids.size() - less.ids.size()}},
                 settings);

    fault = {"FillPrimitives", -1};
    fault.spoilGrid = [](Grid& grid) { repeatLast(grid, 2); };
    Grid more = cpu.grid();
    fault.spoilGrid(more);
    ASSERT_GT(more.ids.size(), cpu.grid().ids.size());
    expectCaught(fault, {{"FillPrimitives: lists", more.ids.size() - cpu.grid().ids.size()}},
                 settings);

    fault = {"FillPrimitives", -1};
    fault.spoilGrid = [](Grid& grid) { grid.atEye = {1, 2}; };
    expectCaught(fault, {{"FillPrimitives: triangles at the eye", 2}}, settings);

    fault = {"FillDepth", -1};
    fault.pass = "transform";
    fault.spoilGeometry = [](FrameGeometry& geometry) {
        geometry.triangles[5].b.y = nextAbove(geometry.triangles[5].b.y);
        geometry.triangles[9].a.x = nextAbove(geometry.triangles[9].a.x);
    };
    expectCaught(fault, {{"FillDepth: triangle buffer", 2}}, settings);
}

/// One fault does not hide the next.
TEST(Check, ShowsEveryFaultOfSeveral) {
    SerialExecutor executor;
    CpuBackend cpu(executor), inner(executor);
    Fault trace{"Trace", 1}, shade{"Shade", 1};
    trace.spoilPaths = [](PathBuffers& paths) {
        for (Hit& hit : paths.hits) hit = {};
    };
    shade.spoilPaths = [](PathBuffers& paths) { paths.radiance[100] = glm::vec3(-1.0f); };
    FaultyBackend first(inner, trace), second(first, shade);
    uint64_t hits = 0, radiance = 0;
    for (const CheckRow& row : checkBackends(room(), smallImage(), cpu, second).rows) {
        if (nameOf(row) == "Trace 1: hit buffer")
            hits += row.different;
        else if (nameOf(row) == "Shade 1: radiance")
            radiance += row.different;
        else
            EXPECT_EQ(row.different, 0u) << text(row);
    }
    EXPECT_GT(hits, 1000u);
    EXPECT_EQ(radiance, 2u); // one in each direction
}

/// Says that its arithmetic is not IEEE.
class LooseBackend final : public ForwardingBackend {
public:
    using ForwardingBackend::ForwardingBackend;
    bool isIeee() const override { return false; }
};

TEST(Check, ToleratesRoundingWhereArithmeticIsNotIeee) {
    SerialExecutor executor;
    for (const float off : {5e-6f, 2e-5f}) {
        CpuBackend cpu(executor), inner(executor);
        Fault fault{"Shade", 1};
        uint64_t lit = 0;
        fault.spoilPaths = [&](PathBuffers& paths) {
            lit = 0;
            for (glm::vec3& radiance : paths.radiance) {
                if (radiance.x > 0.0f) ++lit;
                radiance.x *= 1.0f + off;
            }
        };
        FaultyBackend faulty(inner, fault);
        LooseBackend loose(faulty);
        for (const CheckRow& row : checkBackends(room(), smallImage(), cpu, loose).rows) {
            if (nameOf(row) != "Shade 1: radiance") continue;
            EXPECT_EQ(off < 1e-5f ? row.withinTolerance : row.different, lit) << text(row);
            EXPECT_EQ(row.compared, row.equal + lit);
        }
        EXPECT_GT(lit, 500u);
    }
}

} // namespace
} // namespace dirt::test
