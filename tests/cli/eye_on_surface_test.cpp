// A surface through the eye is not seen: the same picture on every backend, rasterized or traced.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// A floor of two triangles, and a wall that stands behind it.
constexpr const char* kFloor = "v -10 0 -10\nv 10 0 -10\nv 10 0 10\nv -10 0 10\n"
                               "v -1 0 -4\nv 1 0 -4\nv 0 2 -4\nf 1 2 3 4\nf 5 6 7\n";
/// The wall alone.
constexpr const char* kWall = "v -10 5 -10\nv -1 0 -4\nv 1 0 -4\nv 0 2 -4\nf 2 3 4\n";

class EyeOnSurface : public testing::TestWithParam<const char*> {
protected:
    std::vector<std::string> at(const std::string& model) {
        return {model, std::string("--eye=") + GetParam(), "--target=0,0.3,-4", "--size", "48x32"};
    }
    /// Nothing where the backend is not there.
    std::optional<Image> render(const std::string& model, const std::string& backend,
                                const std::string& primary) {
        std::vector<std::string> arguments = at(model);
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(),
                         {"--backend", backend, "--spp", "2", "-o", folder_ / "a.exr"});
        if (backend != "embree") arguments.insert(arguments.end(), {"--primary", primary});
        const Outcome run = dirt(arguments);
        if (run.status == 3) return {};
        EXPECT_EQ(run.status, 0) << run.err;
        return readImage(folder_ / "a.exr");
    }

    TemporaryFolder folder_;
};

TEST_P(EyeOnSurface, EveryBackendShowsTheSame) {
    const std::string model = folder_.write("floor.obj", kFloor);
    const Image expected = *render(model, "cpu", "raster");
    EXPECT_EQ(render(model, "cpu", "traced")->pixels, expected.pixels);
    for (const char* backend : {"gl", "embree"})
        for (const char* primary : {"raster", "traced"})
            if (const auto image = render(model, backend, primary)) {
                EXPECT_EQ(image->pixels, expected.pixels) << backend << " " << primary;
            }
    for (const char* backends : {"cpu,gl", "cpu,embree"})
        for (const char* primary : {"raster", "traced"}) {
            std::vector<std::string> arguments = at(model);
            arguments.insert(arguments.begin(), "check");
            arguments.insert(arguments.end(), {"--backends", backends, "--primary", primary});
            const Outcome run = dirt(arguments);
            if (run.status == 3 || run.err.find("--primary") != std::string::npos) continue;
            EXPECT_EQ(run.status, 0) << backends << " " << primary << "\n" << run.err;
        }
}

/// The first hits are those of a scene without the floor, as many as it has.
TEST_P(EyeOnSurface, TheWallBehindIsSeen) {
    const auto isLit = [](glm::vec3 pixel) { return pixel != glm::vec3(0.5f); };
    const Image with = *render(folder_.write("floor.obj", kFloor), "cpu", "raster");
    const Image without = *render(folder_.write("wall.obj", kWall), "cpu", "raster");
    size_t seen = 0;
    for (size_t i = 0; i < with.pixels.size(); ++i) {
        EXPECT_EQ(isLit(with.pixels[i]), isLit(without.pixels[i])) << i;
        seen += isLit(with.pixels[i]);
    }
    EXPECT_GT(seen, 5u);
    EXPECT_LT(seen, with.pixels.size() / 2);
}

/// In the midst of both triangles' common edge; within one; at a corner; in the plane beside it.
INSTANTIATE_TEST_SUITE_P(Places, EyeOnSurface,
                         testing::Values("0,0,0", "1,0,-0.5", "10,0,10", "0,0,11"));

} // namespace
} // namespace dirt::test
