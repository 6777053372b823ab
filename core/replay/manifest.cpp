#include "core/replay/manifest.h"

#include "core/io/json_value.h"
#include "core/io/load_report.h"
#include "core/io/text_file.h"
#include "core/replay/dumped_view.h"

#include <algorithm>
#include <tuple>

#include <nlohmann/json.hpp>

namespace dirt {

namespace {

using Names = std::vector<std::string>;

/// Beyond the tangent of half the largest float below 180 degrees, 2^24, in images 2^16 times as
/// wide as high.
constexpr float kSteepest = 0x1p40f;

constexpr int kMaxSize = 65536, kMaxBins = 256, kMaxTile = 64, kMaxEvent = 1023;

/// What a dump says besides; none of it bears on whether the buffers are right.
const Names kOtherKeys = {"scene",   "animation_frame", "backend", "device",    "views",
                          "shading", "bounces",         "seed",    "clamped",   "list_entries",
                          "sample",  "origin",          "frame",   "shadow_map"};
const Names kKeys = {"view",      "tile",     "bins",        "size",   "exact", "fov",
                     "triangles", "cut_outs", "view_frames", "at_eye", "files"};
const Names kViewKeys = {"name", "axes", "sign", "size", "tiles", "s", "t"};
const Names kFileKeys = {"file", "buffer", "event", "parts", "channels"};

const Names kRead = {"triangles", "depth", "ids", "rays", "hits", "shadowrays"};
/// Those of them that each path event has.
const Names kOfEvents = {"rays", "hits", "shadowrays"};
/// Buffers of a dump that no judge needs.
const Names kOtherBuffers = {"shadowmap", "direct", "mask", "visibility", "shading", "image"};

bool isIn(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void ignore(const std::string& text, Names& ignored) {
    if (!isIn(ignored, text)) ignored.push_back(text);
}

void ignoreOthers(const JsonValue& object, const Names& known, const std::string& of,
                  Names& ignored) {
    for (const std::string& name : object.names())
        if (!isIn(known, name)) ignore("manifest.json: " + of + "key " + printable(name), ignored);
}

std::string requiredText(const JsonValue& object, const char* name) {
    object.required(name);
    return *object.text(name);
}

/// A pair of whole numbers from 1 to \p highest.
std::pair<int, int> pairOf(const JsonValue& object, const char* name, int highest) {
    const JsonValue value = object.required(name);
    const std::vector<uint64_t> list = object.integers(name, (uint64_t) highest);
    if (list.size() != 2 || list[0] < 1 || list[1] < 1)
        value.fail("is not a pair of whole numbers from 1 to " + std::to_string(highest));
    return {(int) list[0], (int) list[1]};
}

int positive(const JsonValue& object, const char* name, int highest) {
    const auto value = (int) object.requiredInteger(name, (uint64_t) highest);
    if (value < 1) object.required(name).fail("is 0");
    return value;
}

std::vector<float> bordersOf(const JsonValue& object, const char* name, int tiles) {
    const JsonValue value = object.required(name);
    const std::vector<double> numbers = *object.numbers(name, (size_t) tiles + 1);
    std::vector<float> borders(numbers.begin(), numbers.end());
    for (size_t i = 1; i < borders.size(); ++i)
        if (!(borders[i - 1] < borders[i])) value.fail("does not increase");
    if (borders.front() < -kSteepest || borders.back() > kSteepest)
        value.fail("has slopes beyond those of all fields of view");
    return borders;
}

View viewOf(const JsonValue& object, int tile) {
    View view;
    const std::vector<uint64_t> axes = object.integers("axes", 2);
    if (axes.size() != 3 || axes[0] == axes[1] || axes[1] == axes[2] || axes[2] == axes[0])
        object.fail("has no axes: 0, 1 and 2 in some order");
    view.axisX = (int) axes[0];
    view.axisY = (int) axes[1];
    view.axisW = (int) axes[2];
    object.required("sign");
    view.signW = (float) *object.number("sign", -1.0, 1.0);
    if (view.signW != 1.0f && view.signW != -1.0f) object.required("sign").fail("is not 1 or -1");
    std::tie(view.width, view.height) = pairOf(object, "size", kMaxSize);
    std::tie(view.columns, view.rows) = pairOf(object, "tiles", kMaxTiles);
    if (view.columns != (view.width + tile - 1) / tile ||
        view.rows != (view.height + tile - 1) / tile)
        object.required("tiles").fail("is not size by tile, rounded up");
    view.s = bordersOf(object, "s", view.columns);
    view.t = bordersOf(object, "t", view.rows);
    return view;
}

/// Whether full view is six different faces that meet, and single view the camera's alone.
void checkViews(const JsonValue& root, const Manifest& manifest) {
    const JsonValue frames = root.required("view_frames");
    const bool single = manifest.settings.mode == ViewMode::single;
    if (manifest.views.size() != (single ? 1u : 6u))
        frames.fail(single ? "has not one view, as single view has"
                           : "has not six views, as full view has");
    const View& first = manifest.views.front();
    if (single) {
        if (first.axisX != 0 || first.axisY != 1 || first.signW != 1.0f)
            frames.fail("of single view has other axes than 0, 1, 2 and sign 1");
        if (first.width != manifest.settings.width || first.height != manifest.settings.height)
            frames.fail("of single view has not the image's size");
        return;
    }
    int faces = 0;
    for (const View& view : manifest.views) {
        faces |= 1 << (2 * view.axisW + (view.signW < 0.0f));
        if (view.width != first.width || view.height != first.width)
            frames.fail("of full view are not squares of one size");
        for (const std::vector<float>* borders : {&view.s, &view.t})
            if (borders->front() != -1.0f || borders->back() != 1.0f)
                frames.fail("of full view do not reach from slope -1 to 1");
    }
    if (faces != 63) frames.fail("of full view are not six different faces");
}

void readViews(const JsonValue& root, Manifest& manifest, Names& ignored) {
    for (const JsonValue& object : root.objects("view_frames")) {
        ignoreOthers(object, kViewKeys, "of a view: ", ignored);
        const std::string name = requiredText(object, "name");
        if (isIn(manifest.viewNames, name)) object.fail("has the name of another view");
        manifest.viewNames.push_back(name);
        manifest.views.push_back(viewOf(object, manifest.settings.tile));
    }
    if (root.has("view_frames")) {
        checkViews(root, manifest);
        manifest.settings.viewSize =
            manifest.settings.mode == ViewMode::full ? manifest.views.front().width : 0;
    }
    addGuardBands(manifest.views, manifest.settings, manifest.fov);
}

void readFiles(const JsonValue& root, const nlohmann::json& json,
               const std::filesystem::path& folder, Manifest& manifest, Names& ignored) {
    root.required("files");
    const std::vector<JsonValue> files = root.objects("files");
    for (size_t i = 0; i < files.size(); ++i) {
        const JsonValue& object = files[i];
        ignoreOthers(object, kFileKeys, "of a file: ", ignored);
        const std::string name = requiredText(object, "file");
        const std::string buffer = requiredText(object, "buffer");
        if (std::filesystem::path(name).filename() != name || name == "." || name == "..")
            object.fail("has a file that is not in the dump's folder");
        if (!isIn(kRead, buffer)) {
            if (!isIn(kOtherBuffers, buffer)) ignore("buffer " + printable(buffer), ignored);
            continue;
        }
        ManifestFile file{folder / name, buffer, {}};
        const nlohmann::json& raw = json["files"][i];
        if (raw.contains("event") && !raw["event"].is_null())
            file.event = (int) *object.integer("event", kMaxEvent);
        const bool hasEvents = isIn(kOfEvents, buffer);
        if (hasEvents != file.event.has_value())
            object.fail(hasEvents ? "has no event" : "has an event, of which there is none");
        manifest.files.push_back(std::move(file));
    }
}

} // namespace

Manifest readManifest(const std::filesystem::path& folder, Names& ignored) {
    Manifest manifest;
    manifest.file = folder / "manifest.json";
    const nlohmann::json json = parseJson(manifest.file, readTextFile(manifest.file), true);
    const JsonValue root(manifest.file, json);
    if (!root.isObject()) root.fail("is not an object");
    Names known = kKeys;
    known.insert(known.end(), kOtherKeys.begin(), kOtherKeys.end());
    ignoreOthers(root, known, "", ignored);

    GridSettings& settings = manifest.settings;
    const std::string mode = requiredText(root, "view");
    if (mode != "full" && mode != "single") root.required("view").fail("is not full or single");
    settings.mode = mode == "full" ? ViewMode::full : ViewMode::single;
    settings.tile = positive(root, "tile", kMaxTile);
    settings.bins = positive(root, "bins", kMaxBins);
    std::tie(settings.width, settings.height) = pairOf(root, "size", kMaxSize);
    if (!root.boolean("exact").value_or(true))
        failAt(
            manifest.file, 0,
            "the dump was made with --precision fast, which promises nothing that can be judged");
    if (const auto fov = root.number("fov", 0.0, 180.0)) {
        if (!(*fov > 0.0 && *fov < 180.0)) root.required("fov").fail("is not between 0 and 180");
        manifest.fov = (float) *fov;
    }
    if (const auto count = root.integer("triangles", UINT32_MAX - 1)) manifest.triangles = *count;
    manifest.cutOuts = root.boolean("cut_outs").value_or(false);
    readViews(root, manifest, ignored);
    if (root.has("at_eye")) {
        const std::vector<uint64_t> ids = root.integers("at_eye", UINT32_MAX - 1);
        manifest.atEye.emplace(ids.begin(), ids.end());
    }
    readFiles(root, json, folder, manifest, ignored);
    return manifest;
}

} // namespace dirt
