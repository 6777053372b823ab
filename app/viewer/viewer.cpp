#include "app/viewer/viewer.h"

#include "app/cli/again.h"
#include "app/cli/log.h"
#include "core/io/image.h"

#include <cstdio>
#include <filesystem>

namespace dirt {

namespace {

/// NAME-view.png, or NAME-view-2.png and so on: nothing is written over.
std::string freeName(const std::string& scene) {
    std::string stem = scene + "-view";
    const auto taken = [](const std::string& name) {
        return std::filesystem::exists(name + ".png") || std::filesystem::exists(name + ".exr");
    };
    for (int i = 2; taken(stem); ++i) stem = scene + "-view-" + std::to_string(i);
    return stem;
}

} // namespace

void Viewer::say(const std::string& line) {
    said = line;
    sayNote(line, false);
}

void savePicture(Viewer& viewer) {
    const std::shared_ptr<const ViewPicture> shown = viewer.model.picture();
    if (!shown) return viewer.say("there is no picture yet");
    const std::string stem = freeName(viewer.model.sceneName());
    try {
        const ImageMetadata metadata{{"dirt:scene", viewer.model.sceneName()},
                                     {"dirt:samples", std::to_string(shown->samples)}};
        const Picture& picture = shown->picture;
        writePng(stem + ".png", picture.width, picture.height, picture.rgb, metadata);
        if (!shown->image.pixels.empty()) writeExr(stem + ".exr", shown->image, metadata);
        viewer.say("saved " + stem + ".png" + (shown->image.pixels.empty() ? "" : " and .exr"));
    } catch (const std::exception& error) { // a full disk ends nothing
        viewer.said = error.what();
        sayError(viewer.said);
    }
}

void logCamera(Viewer& viewer) {
    if (!viewer.model.loaded()) return viewer.say("there is no camera yet");
    const Camera camera = viewer.model.state().camera;
    const glm::dvec3 origin = viewer.model.origin();
    viewer.say(cameraOptions(origin, camera).substr(1));
    char fov[32], up[96];
    std::snprintf(fov, sizeof fov, "%.9g", camera.verticalFov);
    std::snprintf(up, sizeof up, "%.9g,%.9g,%.9g", camera.up.x, camera.up.y, camera.up.z);
    sayPlain("<camera name=\"view\" aperture=\"" + std::string(fov) +
             "\"/>\n<user name=\"default_user\" position=\"" + pointOption(origin, camera.eye) +
             "\" target=\"" + pointOption(origin, camera.target) + "\" up=\"" + up + "\"/>");
}

} // namespace dirt
