#include "app/cli/model_camera.h"

#include "core/base/error.h"

#include <algorithm>

namespace dirt {

namespace {

bool isNumber(const std::string& text) {
    return !text.empty() && text.size() < 10 &&
           text.find_first_not_of("0123456789") == std::string::npos;
}

/// A number goes before a name that looks like one.
size_t find(const std::vector<ModelCamera>& cameras, const std::string& wanted) {
    if (isNumber(wanted)) {
        const auto index = (size_t) std::stoul(wanted);
        if (index < cameras.size()) return index;
    }
    const auto named = std::find_if(cameras.begin(), cameras.end(), [&](const ModelCamera& camera) {
        return camera.name == wanted;
    });
    if (named != cameras.end()) return (size_t) (named - cameras.begin());
    std::string known;
    for (size_t i = 0; i < std::min<size_t>(cameras.size(), 10); ++i)
        known += (i == 0 ? "; it has " : ", ") + cameraText(cameras, i);
    if (cameras.size() > 10) known += " and more";
    throw InputError("--camera " + inQuotes(wanted) + ": " +
                     (cameras.empty() ? "the scene's files have none" : "there is none" + known));
}

} // namespace

void chooseCamera(LoadedScene& loaded, const CommonOptions& options) {
    if ((options.eye || options.target) && loaded.modelCamera) {
        loaded.modelCamera.reset();
        loaded.hasCamera = false;
    }
    if (!options.camera) return;
    const size_t index = find(loaded.cameras, *options.camera);
    loaded.scene.camera = loaded.cameras[index].camera;
    loaded.scene.animation.camera.reset();
    loaded.modelCamera = index;
    loaded.hasCamera = true;
}

std::string cameraText(const std::vector<ModelCamera>& cameras, size_t index) {
    const ModelCamera& camera = cameras[index];
    return std::to_string(index) + (camera.name.empty() ? "" : " " + inQuotes(camera.name)) +
           (camera.halfHeight ? ", orthographic" : "");
}

} // namespace dirt
