#pragma once

#include "backend_cpu/thread_pool.h"
#include "core/verify/verify_extremes.h"
#include "tests/extremes/small_scene.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <iostream>
#include <memory>

#include <gtest/gtest.h>

namespace dirt::test {

/// What is wrong in a variant.
inline std::string describe(const ExtremeReport& report, const std::string& scene) {
    const ExtremeBackendReport& r = report.backends[0];
    std::string text = std::string(report.extreme->name) + " of " + scene + ": missed " +
                       std::to_string(r.rays.missed) + ", false " +
                       std::to_string(r.rays.falseHits) + ", wrong " +
                       std::to_string(r.rays.wrongPrimitive) + ", t off by " +
                       std::to_string(r.rays.maxUlpTError) + " ulp, pixels not finite " +
                       std::to_string(r.nonFinitePixels);
    if (r.leaks) text += ", leaks " + std::to_string(*r.leaks);
    if (r.selfShadows) text += ", self-shadows " + std::to_string(*r.selfShadows);
    for (const WrongAnswer& wrong : report.wrong)
        text += "; ray " + std::to_string(wrong.index) + " of kind " +
                std::string(rayKindName(wrong.kind));
    return text;
}

/// Verifies all variants of scenes.
class Extremes : public testing::Test {
protected:
    ThreadPool pool_;
    std::vector<std::unique_ptr<Backend>> peers_;
    bool emptyViews_ = false; ///< the camera may see nothing through 0.01 degrees

    /// Runs all variants, on \p tested and beside it on Embree.
    void verify(const Scene& scene, const std::string& name, ViewMode mode, Backend& tested,
                uint32_t rays) {
        RenderSettings settings = smallSettings();
        settings.grid.mode = mode;
        verify(scene, name, settings, tested, rays);
    }
    void verify(const Scene& scene, const std::string& name, const RenderSettings& settings,
                Backend& tested, uint32_t rays) {
        std::vector<Backend*> backends{&tested};
#ifdef DIRT_HAVE_EMBREE
        peers_.clear();
        for (const bool robust : {false, true})
            peers_.push_back(std::make_unique<EmbreeBackend>(pool_, robust, EmbreeDecision::plain));
        for (const auto& peer : peers_) backends.push_back(peer.get());
#endif
        VerifySettings verify;
        verify.rays = rays;
        ExtremeVerifier verifier(scene, settings, backends, verify, pool_);
        std::vector<uint64_t> errors(backends.size());
        uint64_t cast = 0;
        for (const Extreme& extreme : extremes()) {
            const ExtremeReport report = verifier.run(extreme);
            EXPECT_EQ(report.leftOut, "") << extreme.name;
            EXPECT_TRUE(report.backends[0].right()) << describe(report, name);
            // So far away float32 leaves a few points, and the eye may be one of them, from where
            // a surface through it is not seen.
            EXPECT_TRUE(report.hits > 0 || emptyViews_ || extreme.name.ends_with("moved-1e7"))
                << extreme.name << " proves nothing";
            EXPECT_EQ(report.backends[0].leaks.has_value(),
                      extreme.body == Extreme::Body::closedBox);
            EXPECT_EQ(report.backends[0].selfShadows.has_value(),
                      extreme.body == Extreme::Body::ball);
            cast += report.rays;
            for (size_t b = 0; b < backends.size(); b++)
                errors[b] += report.backends[b].rays.errors();
        }
        std::cout << name << ": " << cast << " rays, wrong:";
        for (size_t b = 0; b < backends.size(); b++)
            std::cout << " " << backends[b]->name() << " " << errors[b];
        std::cout << std::endl;
#ifdef DIRT_HAVE_EMBREE
        EXPECT_GT(errors[1], 0u) << "rays that are not hard prove little";
#endif
    }
};

} // namespace dirt::test
