// Layers beside an image, against plain means over the buffers of each sample, the mesh itself, and
// the variance of renders of one sample each.

#include "core/aov/aovs.h"

#include "backend_cpu/cpu_backend.h"
#include "core/base/error.h"
#include "core/frame/forwarding_backend.h"
#include "core/frame/renderer.h"
#include "tests/frame/shapes.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

/// Counts what is read of it.
class CountingBackend final : public ForwardingBackend {
public:
    using ForwardingBackend::ForwardingBackend;
    std::vector<SurfacePoint> readPoints() const override {
        ++points;
        return inner_.readPoints();
    }
    std::vector<glm::vec3> readRadiance() const override {
        ++radiance;
        return inner_.readRadiance();
    }
    PathBuffers readPaths() const override {
        ADD_FAILURE() << "all buffers are read";
        return {};
    }
    mutable int points = 0, radiance = 0;
};

const std::vector<std::string> kAll = {"albedo",          "emission", "normal",
                                       "geometricNormal", "depth",    "roughness",
                                       "position",        "id",       "variance"};

/// A layer's channel by its name, of all pixels.
using Channels = std::map<std::string, std::vector<uint32_t>>;

class AovTest : public testing::TestWithParam<std::tuple<ViewMode, Shading>> {
protected:
    SerialExecutor serial_;
    CpuBackend cpu_{serial_};
    Scene scene_ = test::room();
    RenderSettings settings_;

    void SetUp() override {
        settings_.grid.mode = std::get<0>(GetParam());
        settings_.shading = std::get<1>(GetParam());
        settings_.grid.width = 37;
        settings_.grid.height = 29;
        settings_.grid.tile = 8;
        settings_.grid.bins = 4;
        settings_.samples = 1;
        settings_.bounces = 2;
        // Something beside the room for rays to miss, and something that shines in view.
        scene_.camera.target = {1.2f, 1.4f, -1};
        scene_.materials[2].emission = {0.5f, 0.25f, 0.125f};
    }

    Channels layersOf(Backend& backend, const std::vector<std::string>& names,
                      const std::function<bool()>& stop = {}) {
        Aovs aovs(aovKindsOf(names), scene_, settings_);
        RenderHooks hooks;
        hooks.stop = stop;
        hooks.observe = [&](uint32_t, int event) { aovs.observe(backend, event); };
        hooks.progress = [&](int, int) { aovs.finishSample(); };
        const RenderResult result = Renderer(scene_, settings_, backend).render(hooks);
        const ExrPart part = aovs.picture(result.image);
        Channels channels;
        const size_t count = part.channels.size();
        for (size_t i = 0; i < part.values.size(); ++i)
            channels[part.channels[i % count].name].push_back(part.values[i]);
        for (size_t pixel = 0; pixel < result.image.pixels.size(); ++pixel)
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(std::bit_cast<float>(channels[std::string(1, "RGB"[c])][pixel]),
                          result.image.pixels[pixel][c]);
        return channels;
    }

    /// G[1] of each sample.
    std::vector<std::vector<SurfacePoint>> firstHits() {
        std::vector<std::vector<SurfacePoint>> samples;
        RenderHooks hooks;
        hooks.observe = [&](uint32_t, int event) {
            if (event == 0) samples.push_back(cpu_.readPaths().next);
        };
        Renderer(scene_, settings_, cpu_).render(hooks);
        return samples;
    }
};

float valueOf(const Channels& channels, const std::string& name, size_t pixel) {
    return std::bit_cast<float>(channels.at(name).at(pixel));
}

glm::dvec3 vectorOf(const Channels& channels, const std::string& name, const char* letters,
                    size_t pixel) {
    glm::dvec3 v;
    for (int i = 0; i < 3; ++i) v[i] = valueOf(channels, name + "." + letters[i], pixel);
    return v;
}

TEST_P(AovTest, OfOneSampleAreItsFirstHits) {
    std::vector<std::string> names = kAll;
    names.pop_back(); // variance
    const Channels layers = layersOf(cpu_, names);
    EXPECT_EQ(layers.size(), 3u + 3u * 5u + 3u);
    const std::vector<SurfacePoint> points = firstHits().front();
    const bool full = settings_.grid.mode == ViewMode::full;
    const bool packed = settings_.shading == Shading::packed;
    const glm::dvec3 eye = scene_.camera.eye;
    const glm::dvec3 forward = glm::normalize(glm::dvec3(scene_.camera.target) - eye);
    size_t hits = 0, misses = 0, shining = 0;
    for (size_t pixel = 0; pixel < points.size(); ++pixel) {
        const SurfacePoint& point = points[pixel];
        EXPECT_EQ(layers.at("id.X")[pixel], point.primitive);
        if (!point.found()) {
            ++misses;
            for (const auto& [name, values] : layers) {
                if (name.find('.') == name.npos || name == "id.X") continue;
                EXPECT_EQ(valueOf(layers, name, pixel), name == "depth.Z" ? 1e10f : 0.0f) << name;
            }
            continue;
        }
        ++hits;
        shining += point.emission.x > 0.0f;
        EXPECT_EQ(vectorOf(layers, "albedo", "RGB", pixel), glm::dvec3(point.diffuse));
        EXPECT_EQ(vectorOf(layers, "emission", "RGB", pixel), glm::dvec3(point.emission));
        EXPECT_EQ(valueOf(layers, "roughness.X", pixel), point.roughness);
        const glm::dvec3 normal = vectorOf(layers, "normal", "XYZ", pixel);
        const glm::dvec3 geometric = vectorOf(layers, "geometricNormal", "XYZ", pixel);
        if (full) {
            EXPECT_EQ(normal, glm::dvec3(point.shadingNormal));
            EXPECT_EQ(geometric, glm::dvec3(point.geometricNormal));
        }
        // The point and its normal once more, from the mesh: few roundings of a room of size 4.
        const auto& corners = scene_.mesh.triangles[point.primitive];
        const auto corner = [&](size_t i) { return glm::dvec3(scene_.mesh.positions[corners[i]]); };
        const glm::dvec3 a = corner(0), b = corner(1), c = corner(2);
        const double u = point.u, v = point.v;
        const glm::dvec3 position = a * (1.0 - u - v) + b * u + c * v;
        const double few = 0x1p-19;
        EXPECT_LT(glm::length(vectorOf(layers, "position", "XYZ", pixel) - position), 4.0 * few);
        EXPECT_NEAR(valueOf(layers, "depth.Z", pixel), glm::dot(position - eye, forward),
                    8.0 * few);
        glm::dvec3 due = glm::normalize(glm::cross(b - a, c - a));
        if (glm::dot(due, position - eye) > 0.0) due = -due;
        EXPECT_LT(glm::length(geometric - due), packed ? 1e-3 : 4.0 * few);
        EXPECT_GT(glm::dot(normal, due), 0.5);
    }
    EXPECT_GT(hits, 200u);
    EXPECT_GT(misses, 50u);
    EXPECT_GT(shining, 10u);
}

TEST_P(AovTest, OfSeveralAreMeansOverThemOrOverThoseThatHit) {
    settings_.samples = 5;
    const Channels layers = layersOf(cpu_, kAll);
    settings_.samples = 1;
    std::vector<Channels> single;
    for (int sample = 0; sample < 5; ++sample) {
        Aovs aovs(aovKindsOf(kAll), scene_, settings_);
        RenderHooks hooks;
        hooks.observe = [&](uint32_t, int event) { aovs.observe(cpu_, event); };
        hooks.progress = [&](int, int) { aovs.finishSample(); };
        Renderer renderer(scene_, settings_, cpu_);
        renderer.beginAt((uint32_t) sample);
        const ExrPart part = aovs.picture(renderer.render(hooks).image);
        Channels& channels = single.emplace_back();
        for (size_t i = 0; i < part.values.size(); ++i)
            channels[part.channels[i % part.channels.size()].name].push_back(part.values[i]);
    }
    size_t edges = 0;
    const size_t pixels = layers.at("id.X").size();
    for (size_t pixel = 0; pixel < pixels; ++pixel) {
        EXPECT_EQ(layers.at("id.X")[pixel], single[0].at("id.X")[pixel]);
        int hits = 0;
        for (const Channels& one : single) hits += one.at("id.X")[pixel] != kNoPrimitive;
        edges += hits > 0 && hits < 5;
        for (const auto& [name, values] : layers) {
            const bool ofHits =
                name == "depth.Z" || name == "roughness.X" || name.starts_with("position");
            if (name.find('.') == name.npos || name == "id.X" || name.starts_with("variance"))
                continue;
            double sum = 0.0;
            for (const Channels& one : single)
                if (!ofHits || one.at("id.X")[pixel] != kNoPrimitive)
                    sum += valueOf(one, name, pixel);
            const double mean = sum / (ofHits ? hits : 5);
            const double due = ofHits && hits == 0 ? (name == "depth.Z" ? 1e10 : 0.0) : mean;
            // Single samples are rounded once, the mean once more.
            EXPECT_NEAR(valueOf(layers, name, pixel), due, 4.0 * 0x1p-23 + 1e10 * (due > 1e9))
                << name << " of pixel " << pixel;
        }
    }
    EXPECT_GT(edges, 5u);
}

TEST_P(AovTest, VarianceIsThatOfRendersOfOneSample) {
    constexpr int kSamples = 6;
    settings_.samples = kSamples;
    const Channels layers = layersOf(cpu_, {"variance"});
    settings_.samples = 1;
    std::vector<Image> images;
    for (int sample = 0; sample < kSamples; ++sample) {
        Renderer renderer(scene_, settings_, cpu_);
        renderer.beginAt((uint32_t) sample);
        images.push_back(renderer.render().image);
    }
    size_t varied = 0;
    for (size_t pixel = 0; pixel < images[0].pixels.size(); ++pixel)
        for (int c = 0; c < 3; ++c) {
            double mean = 0.0, squares = 0.0;
            for (const Image& image : images) mean += image.pixels[pixel][c] / (double) kSamples;
            for (const Image& image : images) {
                const double distance = image.pixels[pixel][c] - mean;
                squares += distance * distance;
            }
            const double due = squares / (kSamples - 1);
            const float found = valueOf(layers, std::string("variance.") + "RGB"[c], pixel);
            // Rounded to float; both sums in double, whose errors are 2^-52 of the mean's square.
            EXPECT_NEAR(found, due, 0x1p-23 * due + 0x1p-48 * mean * mean);
            varied += due > 1e-6;
        }
    EXPECT_GT(varied, 500u);
}

TEST_P(AovTest, AnUnfinishedSampleIsForgotten) {
    settings_.samples = 2;
    const Channels two = layersOf(cpu_, kAll);
    settings_.samples = 4;
    // The third sample ends after its first event.
    int shades = 0;
    class Shading final : public ForwardingBackend {
    public:
        Shading(Backend& inner, int& shades) : ForwardingBackend(inner), shades_(shades) {}
        void shade(int event) override {
            ++shades_;
            inner_.shade(event);
        }

    private:
        int& shades_;
    } backend(cpu_, shades);
    EXPECT_EQ(layersOf(backend, kAll, [&] { return shades > 5; }), two);
    EXPECT_EQ(shades, 6);
}

TEST_P(AovTest, ReadNoMoreThanTheyNeed) {
    settings_.samples = 3;
    CountingBackend backend(cpu_);
    layersOf(backend, {});
    EXPECT_EQ(backend.points + backend.radiance, 0);
    layersOf(backend, {"variance"});
    EXPECT_EQ(backend.points, 0);
    EXPECT_EQ(backend.radiance, 3);
    layersOf(backend, {"albedo", "id"});
    EXPECT_EQ(backend.points, 3);
    EXPECT_EQ(backend.radiance, 3);
}

TEST_P(AovTest, PartsOfTheBuffersAreThoseOfAllBuffers) {
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int) {
        const PathBuffers paths = cpu_.readPaths();
        const std::vector<SurfacePoint> points = cpu_.readPoints();
        ASSERT_EQ(points.size(), paths.next.size());
        EXPECT_EQ(std::memcmp(points.data(), paths.next.data(), points.size() * sizeof points[0]),
                  0);
        EXPECT_EQ(cpu_.readRadiance(), paths.radiance);
    };
    Renderer(scene_, settings_, cpu_).render(hooks);
}

INSTANTIATE_TEST_SUITE_P(Modes, AovTest,
                         testing::Combine(testing::Values(ViewMode::full, ViewMode::single),
                                          testing::Values(Shading::full, Shading::packed)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param) == ViewMode::full
                                                    ? "FullView"
                                                    : "SingleView") +
                                    (std::get<1>(info.param) == Shading::full ? "" : "Packed");
                         });

TEST(AovNames, AreOneAnother) {
    EXPECT_EQ(aovKindsOf({"id", "albedo"}).size(), 2u);
    EXPECT_THROW(aovKindsOf({"id", "colour"}), InputError);
    EXPECT_THROW(aovKindsOf({"id", "albedo", "id"}), InputError);
    EXPECT_EQ(aovNames(),
              "albedo,emission,normal,geometricNormal,roughness,depth,position,id,variance");
}

} // namespace
} // namespace dirt
