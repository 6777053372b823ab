// The reader of .scene files. What they name is not loaded.

#include "core/io/scene_file.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        dirt::LoadReport report;
        const dirt::SceneFile scene = dirt::readSceneFile(file, report);
        // Keys may move them apart; frames in which they do not are refused one by one.
        if (!scene.animation.camera && scene.camera.eye == scene.camera.target) std::abort();
        if (!(scene.camera.verticalFov > 0.0f && scene.camera.verticalFov < 180.0f)) std::abort();
        if (scene.light && scene.light->position == scene.light->target) std::abort();
    });
}
