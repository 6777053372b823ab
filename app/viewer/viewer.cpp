#include "app/viewer/viewer.h"

#include "app/cli/again.h"
#include "app/cli/log.h"
#include "app/viewer/inspect.h"
#include "core/io/image.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// Of the plot.
constexpr size_t kFramesKept = 120;

/// NAME-view.png, or NAME-view-2.png and so on: nothing is written over.
std::string freeName(const std::string& scene) {
    std::string stem = scene + "-view";
    const auto taken = [](const std::string& name) {
        return std::filesystem::exists(name + ".png") || std::filesystem::exists(name + ".exr");
    };
    for (int i = 2; taken(stem); ++i) stem = scene + "-view-" + std::to_string(i);
    return stem;
}

/// The numbers of a buffer as an image, a pixel for each element; of views, as they stand in the
/// picture. Of an overview, which has several, those of its image.
Image imageOf(const std::vector<PictureValues>& parts) {
    Image image;
    const bool isOverview = parts.front().view >= 0 && parts.back().view < 0;
    const size_t first = isOverview ? parts.size() - 1 : 0;
    const int times = parts.back().times;
    const glm::ivec2 corner =
        isOverview ? glm::ivec2(parts.back().pixels.left, parts.back().pixels.top) : glm::ivec2(0);
    for (size_t i = first; i < parts.size(); ++i) {
        image.width = std::max(image.width, (parts[i].pixels.right() - corner.x) / times);
        image.height = std::max(image.height, (parts[i].pixels.bottom() - corner.y) / times);
    }
    image.pixels.resize((size_t) image.width * (size_t) image.height);
    for (size_t i = first; i < parts.size(); ++i) {
        const PictureValues& part = parts[i];
        const int left = (part.pixels.left - corner.x) / times;
        const int top = (part.pixels.top - corner.y) / times;
        size_t from = 0;
        for (int y = 0; y < part.rows(); ++y)
            for (int x = 0; x < part.columns(); ++x, from += (size_t) part.channels) {
                glm::vec3& pixel =
                    image.pixels[(size_t) (top + y) * (size_t) image.width + (size_t) (left + x)];
                for (int c = 0; c < 3; ++c)
                    pixel[c] = (float) part.numbers[from + (size_t) (part.channels == 3 ? c : 0)];
            }
    }
    return image;
}

/// The least and the greatest depth of a box before a camera, the least not so near that a depth
/// buffer loses its digits; far 0: all of it is behind.
std::pair<double, double> planesOf(const Bounds& box, const Camera& camera) {
    const glm::dvec3 eye(camera.eye), ahead = glm::normalize(glm::dvec3(camera.target) - eye);
    const glm::dvec3 low = (box.low - eye) * ahead, high = (box.high - eye) * ahead;
    const glm::dvec3 one(1.0);
    const double far = std::max(glm::dot(glm::max(low, high), one), 0.0);
    return {std::max(glm::dot(glm::min(low, high), one), 1e-5 * far), far};
}

} // namespace

const PathStep* Viewer::stepOf(const ViewPicture& picture) const {
    if (picture.path.empty()) return nullptr;
    return &picture.path[std::min((size_t) step, picture.path.size() - 1)];
}

void Viewer::count(const ViewPicture& picture) {
    if (frames.size() == kFramesKept) frames.erase(frames.begin());
    frames.push_back((float) picture.sampleMs);
}

void Viewer::say(const std::string& line) {
    said = line;
    sayNote(line, false);
}

void savePicture(Viewer& viewer) {
    const std::shared_ptr<const ViewPicture> shown = viewer.model.picture();
    if (!shown || shown->loading) return viewer.say("there is no picture yet");
    const std::string scene = viewer.model.facts().name;
    const std::string stem = freeName(scene);
    try {
        const ImageMetadata metadata{{"dirt:scene", scene},
                                     {"dirt:samples", std::to_string(shown->samples)}};
        Picture picture = shown->picture;
        Canvas canvas(picture);
        drawMarks(canvas, shown->marks, glm::dvec2(0.0), 1);
        if (const PathStep* path = viewer.stepOf(*shown))
            drawMarks(canvas, path->marks, glm::dvec2(0.0), 1);
        writePng(stem + ".png", picture.width, picture.height, picture.rgb, metadata);
        writeExr(stem + ".exr", shown->image.pixels.empty() ? imageOf(shown->values) : shown->image,
                 metadata);
        viewer.say("saved " + stem + ".png and .exr");
    } catch (const std::exception& error) { // a full disk ends nothing
        viewer.said = error.what();
        sayError(viewer.said);
    }
}

void logCamera(Viewer& viewer) {
    if (!viewer.model.loaded() || !viewer.model.picture())
        return viewer.say("there is no camera yet");
    const Camera camera = viewer.model.state().camera;
    const glm::dvec3 origin = viewer.model.facts().origin;
    const glm::dvec3 ahead = glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
    viewer.say(cameraOptions(origin, camera).substr(1));
    char lens[96], up[96], along[96];
    const auto [near, far] = planesOf(viewer.model.picture()->box, camera);
    const int length = std::snprintf(lens, sizeof lens, "aperture=\"%.9g\"", camera.verticalFov);
    if (far > 0.0) // for rasterizers: rays need no planes
        std::snprintf(lens + length, sizeof lens - (size_t) length, " near=\"%.9g\" far=\"%.9g\"",
                      near, far);
    std::snprintf(up, sizeof up, "%.9g,%.9g,%.9g", camera.up.x, camera.up.y, camera.up.z);
    std::snprintf(along, sizeof along, "%.9g,%.9g,%.9g", ahead.x, ahead.y, ahead.z);
    sayPlain("<camera name=\"view\" " + std::string(lens) +
             "/>\n<user name=\"default_user\" position=\"" + pointOption(origin, camera.eye) +
             "\" target=\"" + pointOption(origin, camera.target) + "\" up=\"" + up +
             "\"/> <!-- looks along " + along + " -->");
}

void clickPicture(Viewer& viewer, const ViewPicture& shown, int x, int y) {
    const Inspection there = inspect(shown, x, y);
    if (there.tile)
        viewer.model.change([&](ViewState& s) {
            s.tile = s.tile == there.tile ? std::nullopt : there.tile; // again: no longer
        });
    else if (there.place && viewer.model.state().ray) {
        viewer.model.change([&](ViewState& s) { showRay(s, there.place->x, there.place->y); });
        viewer.step = 0;
    } else if (!there.text.empty())
        viewer.say(there.text);
}

} // namespace dirt
