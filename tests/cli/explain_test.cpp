// `dirt explain` as its users run it.

#include "app/cli/explain_text.h"
#include "core/io/image.h"
#include "tests/cli/program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace dirt::test {
namespace {

class Explain : public testing::Test {
protected:
    Outcome explain(std::vector<std::string> options) {
        options.insert(options.begin(), {"explain", scene_, "--size", "32x32", "--quiet"});
        return dirt(options);
    }
    nlohmann::json json(std::vector<std::string> options) {
        options.push_back("--json");
        const Outcome run = explain(options);
        EXPECT_EQ(run.status, 0) << run.err;
        return nlohmann::json::parse(run.out);
    }
    /// The one line of an error.
    std::string error(const std::vector<std::string>& options) {
        const Outcome run = explain(options);
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(run.out, "");
        return run.err;
    }

    TemporaryFolder folder_;
    std::string scene_ = litTriangle(folder_);
};

TEST_F(Explain, TellsThePathOfAPixel) {
    const Outcome run = explain({"--pixel", "16,16"});
    EXPECT_EQ(run.status, 0) << run.err;
    for (const char* said :
         {"pixel (16, 16), sample 0 of a, cpu", "event 0, found by rasterization",
          "point    primitive 0", "light    reaches the point", "primary ray, grid frame",
          "hits 0 at t", "shadow ray", "open", "view ", "tile (", "lists 1", ": hit", "radiance ("})
        EXPECT_NE(run.out.find(said), std::string::npos) << said << "\n" << run.out;
}

TEST_F(Explain, SaysTheSameAsJson) {
    const nlohmann::json all = json({"--pixel", "16,16", "--bounces", "2"});
    ASSERT_EQ(all["events"].size(), 2u);
    const nlohmann::json& first = all["events"][0];
    EXPECT_EQ(first["point"]["primitive"], 0);
    EXPECT_EQ(first["rasterized"], true);
    EXPECT_EQ(first["lit"], true);
    ASSERT_EQ(first["rays"].size(), 2u);
    EXPECT_EQ(first["rays"][0]["kind"], "primary");
    EXPECT_EQ(first["rays"][0]["hit"]["primitive"], 0);
    EXPECT_EQ(first["rays"][1]["kind"], "shadow");
    EXPECT_EQ(first["rays"][1]["blocked"], false);
    // The second event leaves for the background.
    EXPECT_EQ(all["events"][1]["point"], nlohmann::json());
    EXPECT_EQ(all["events"][1]["rays"][0]["kind"], "indirect");
    EXPECT_EQ(all["events"][1]["rays"][0]["skip"], 0);
    for (int c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (const nlohmann::json& event : all["events"]) sum += event["added"][c].get<double>();
        EXPECT_NEAR(sum, all["radiance"][c].get<double>(), 1e-6);
    }
    EXPECT_EQ(json({"--pixel", "16,16", "--bounces", "2", "--event", "1"})["events"].size(), 1u);
    // Another sample has another ray.
    EXPECT_NE(json({"--pixel", "16,16", "--sample", "5"})["events"][0]["rays"][0]["direction"],
              first["rays"][0]["direction"]);
}

TEST_F(Explain, ListsATileAndAPrimitive) {
    const nlohmann::json ofPrimitive = json({"--primitive", "0", "--tile", "8", "--bins", "4"});
    ASSERT_FALSE(ofPrimitive["entries"].empty());
    for (const nlohmann::json& entry : ofPrimitive["entries"]) {
        EXPECT_EQ(entry["right"], true);
        ASSERT_GE(entry["polygon"].size(), 3u);
        for (const nlohmann::json& corner : entry["polygon"]) {
            EXPECT_GE(corner[2], entry["depths"][0]);
            EXPECT_LE(corner[2], entry["depths"][1]);
        }
        const std::string at = std::to_string(entry["view"].get<int>()) + "," +
                               std::to_string(entry["tile"][0].get<int>()) + "," +
                               std::to_string(entry["tile"][1].get<int>());
        const nlohmann::json ofTile = json({"--tile", "8", "--tile", at, "--bins", "4"});
        ASSERT_EQ(ofTile["entries"].size(), 1u) << at;
        EXPECT_EQ(ofTile["entries"][0], entry);
    }
    const Outcome text = explain({"--primitive", "0"});
    EXPECT_NE(text.out.find(", 0 wrong\n"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("    corners (x, y, w) ("), std::string::npos) << text.out;
}

/// Beside the same text; a disagreement would be drawn, too.
TEST_F(Explain, DrawsTheRays) {
    const std::string picture = folder_ / "rays.png";
    const std::vector<std::string> pixel{"--pixel", "16,16", "--bounces", "2"};
    std::vector<std::string> drawn = pixel;
    drawn.insert(drawn.end(), {"--image", picture});
    const Outcome run = explain(drawn);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out, explain(pixel).out);
    const Image all = readImage(picture);
    const ImageMetadata metadata = readMetadata(picture);
    ASSERT_EQ(metadata.size(), 1u);
    EXPECT_EQ(metadata[0].first, "dirt:rays");
    EXPECT_EQ(metadata[0].second, "pixel (16, 16), sample 0 of a, cpu");
    drawn.insert(drawn.end(), {"--event", "1"});
    EXPECT_EQ(explain(drawn).status, 0);
    EXPECT_LT(readImage(picture).height, all.height);
    std::filesystem::remove(picture);
    EXPECT_EQ(explain({"--ray", "0,0,0,0,0,-1", "--image", picture}).status, 0);
    EXPECT_EQ(readMetadata(picture).at(0).second, "a ray of a, cpu");
    std::filesystem::remove(picture);
    EXPECT_EQ(explain({"--tile", "5,0,0", "--image", picture}).status, 0);
    EXPECT_EQ(readMetadata(picture).at(0).second.find("tile (0, 0) of view 5"), 0u);
    std::filesystem::remove(picture);
    EXPECT_EQ(error({"--primitive", "0", "--image", picture}),
              "dirt: --image: has no effect without --pixel, --ray or --tile VIEW,X,Y\n");
    EXPECT_NE(error({"--pixel", "0,0", "--image", folder_ / "a.exr"}).find("is a PNG"),
              std::string::npos);
    EXPECT_NE(error({"--pixel", "0,0", "--image", folder_ / "none/a.png"}).find("none"),
              std::string::npos);
}

TEST_F(Explain, TellsOfARay) {
    // The camera's ray, which hits the triangle 2 units away; the grid frame's scale is 1/2.
    const nlohmann::json hit = json({"--ray", "0,0,0,0,0,-1"});
    EXPECT_EQ(hit["traced_hit"]["primitive"], 0);
    EXPECT_EQ(hit["exact"]["primitives"], nlohmann::json({0}));
    EXPECT_EQ(hit["exact"]["t"], hit["traced_hit"]["t"]);
    EXPECT_EQ(hit["ray"]["hit"]["primitive"], 0);
    EXPECT_FALSE(hit["ray"]["views"].empty());
    EXPECT_EQ(hit["disagreements"], nlohmann::json::array());
    const double t = hit["exact"]["t"].get<double>();
    EXPECT_EQ(json({"--ray", "0,0,0,0,0,-1", "--max-t", std::to_string(t * 1.01)})["blocked"],
              true);
    EXPECT_EQ(json({"--ray", "0,0,0,0,0,-1", "--max-t", std::to_string(t * 0.99)})["blocked"],
              false);
    const nlohmann::json skipped = json({"--ray", "0,0,0,0,0,-1", "--skip", "0"});
    EXPECT_EQ(skipped["traced_hit"], nlohmann::json());
    EXPECT_EQ(skipped["exact"]["t"], nlohmann::json());
    const Outcome text = explain({"--ray=-0.5,0,0,0,0,-1"});
    EXPECT_EQ(text.status, 0) << text.err;
    for (const char* said : {"a ray of a, cpu\n", "  asked ray, grid frame: from (-0.5, 0, 0)",
                             "\n  backend  ", "\n  exact    "})
        EXPECT_NE(text.out.find(said), text.out.npos) << said << "\n" << text.out;
}

TEST_F(Explain, AsksForWhatThereIs) {
    EXPECT_EQ(error({}),
              "dirt: explain: one of --pixel X,Y, --tile VIEW,X,Y, --primitive ID and --ray says "
              "what\n");
    EXPECT_EQ(error({"--primitive", "0", "--event", "1"}),
              "dirt: --event: has no effect without --pixel\n");
    EXPECT_EQ(error({"--pixel", "1,1", "--max-t", "1"}),
              "dirt: --max-t: has no effect without --ray\n");
    EXPECT_EQ(error({"--ray", "0,0,0,0,0"}),
              "dirt: --ray: '0,0,0,0,0' is not six numbers OX,OY,OZ,DX,DY,DZ\n");
    EXPECT_EQ(error({"--pixel", "1,1", "--primitive", "0"}), error({}));
    EXPECT_EQ(error({"--pixel", "32,0"}), "dirt: --pixel 32,0: the image has 32x32 pixels\n");
    EXPECT_EQ(error({"--pixel", "3"}),
              "dirt: --pixel: '3' is not X,Y, whole numbers from 0 to 65535\n");
    EXPECT_EQ(error({"--pixel", "3,4,"}),
              "dirt: --pixel: '3,4,' is not X,Y, whole numbers from 0 to 65535\n");
    EXPECT_EQ(error({"--primitive", "1"}), "dirt: --primitive 1: there are 1, counted from 0\n");
    EXPECT_EQ(error({"--tile", "6,0,0"}), "dirt: --tile: view 6: there are 6, counted from 0\n");
    EXPECT_EQ(error({"--tile", "0,9,0", "--tile", "16"}), "dirt: --tile: the view has 2x2 tiles\n");
    EXPECT_EQ(error({"--pixel", "0,0", "--tile", "0"}),
              "dirt: --tile: '0' is not a number from 1 to 64\n");
    EXPECT_EQ(error({"--pixel", "1,1", "--event", "3"}),
              "dirt: --event 3: the path events of 3 bounces are 0 to 2\n");
    EXPECT_NE(error({"--pixel", "1,1", "--spp", "4"}).find("no effect"), std::string::npos);
}

/// A backend that answers otherwise than the definition over its own grid is told so.
TEST(ExplainText, NamesWhatIsDifferent) {
    EventAccount event;
    event.hit = {3, 0.5f};
    event.ray.direction = {0, 0, 1};
    ExplainedRay ray{"indirect", {{}, {0, 0, 1}}, {}, RayTrail()};
    ray.trail->hit = {3, 0.5f};
    EXPECT_EQ(disagreement(event, ray), "");
    ray.trail->hit.t = 0.25f;
    EXPECT_EQ(disagreement(event, ray), "the backend hits 3 at t 0.5, the definition 3 at 0.25");
    ray.trail->hit = {2, 0.5f};
    EXPECT_EQ(disagreement(event, ray), "the backend hits 3 at t 0.5, the definition 2 at 0.5");
    event.rasterized = true;
    event.point.primitive = 3;
    EXPECT_EQ(disagreement(event, ray), "rasterization sees primitive 3, the ray hits 2");
    event.shadowRay = ShadowRay();
    ray.maxT = 1.0f;
    ray.trail->blocked = true;
    EXPECT_EQ(disagreement(event, ray), "");
    event.lit = true;
    EXPECT_EQ(disagreement(event, ray), "the backend says that the light reaches the point");
}

#ifdef DIRT_HAVE_EMBREE
/// Embree has no grid: its rays and hits are told, without a way.
TEST_F(Explain, ToldOfEmbreeToo) {
    const nlohmann::json all = json({"--pixel", "16,16", "--backend", "embree"});
    EXPECT_EQ(all["events"][0]["traced_hit"]["primitive"], 0);
    EXPECT_FALSE(all["events"][0]["rays"][0].contains("views"));
    EXPECT_NE(error({"--primitive", "0", "--backend", "embree"}).find("has no lists"),
              std::string::npos);
    EXPECT_NE(error({"--pixel", "16,16", "--backend", "embree", "--image", folder_ / "a.png"})
                  .find("has no grid to draw"),
              std::string::npos);
}
#endif

} // namespace
} // namespace dirt::test
