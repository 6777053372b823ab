#include "app/viewer/viewer.h"

#include "app/cli/again.h"
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
    std::fprintf(stderr, "dirt: %s\n", line.c_str());
}

void savePicture(Viewer& viewer) {
    const std::shared_ptr<const ViewPicture> shown = viewer.model.picture();
    if (!shown || shown->loading) return viewer.say("there is no picture yet");
    const std::string stem = freeName(viewer.model.sceneName());
    try {
        const ImageMetadata metadata{{"dirt:scene", viewer.model.sceneName()},
                                     {"dirt:samples", std::to_string(shown->samples)}};
        const Picture& picture = shown->picture;
        writePng(stem + ".png", picture.width, picture.height, picture.rgb, metadata);
        if (!shown->image.pixels.empty()) writeExr(stem + ".exr", shown->image, metadata);
        viewer.say("saved " + stem + ".png" + (shown->image.pixels.empty() ? "" : " and .exr"));
    } catch (const std::exception& error) { // a full disk ends nothing
        viewer.say(error.what());
    }
}

void logCamera(Viewer& viewer) {
    if (!viewer.model.loaded()) return viewer.say("there is no camera yet");
    const Camera camera = viewer.model.state().camera;
    const glm::dvec3 origin = viewer.model.origin();
    viewer.say(cameraOptions(origin, camera).substr(1));
    std::fprintf(stderr,
                 "<camera name=\"view\" aperture=\"%.9g\"/>\n"
                 "<user name=\"default_user\" position=\"%s\" target=\"%s\" "
                 "up=\"%.9g,%.9g,%.9g\"/>\n",
                 camera.verticalFov, pointOption(origin, camera.eye).c_str(),
                 pointOption(origin, camera.target).c_str(), camera.up.x, camera.up.y, camera.up.z);
}

} // namespace dirt
