#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/thread_limit.h"
#include "core/base/error.h"
#include "core/cost/cost_model.h"
#include "core/cost/forecast.h"
#include "core/frame/memory_plan.h"
#include "core/frame/precision.h"
#include "core/frame/requirements.h"
#include "core/io/memory_budget.h"

#ifdef DIRT_HAVE_GL
#include "backend_gl/gl_context.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <set>

#include <glm/common.hpp>

namespace dirt {

namespace {

struct InfoOptions {
    CommonOptions common;
    bool json = false;
};

/// What there is to say of a scene besides its run.
struct SceneCounts {
    size_t emissiveTriangles = 0;
    size_t texturesFound = 0, texturesNamed = 0, textureBytes = 0;
    glm::vec3 low{0.0f}, high{0.0f}; ///< box of the triangles, world space
};

SceneCounts count(const Input& input) {
    const Scene& scene = input.scene;
    SceneCounts counts;
    counts.low = counts.high = scene.mesh.positions[scene.mesh.triangles.front()[0]];
    for (size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
        for (uint32_t corner : scene.mesh.triangles[i]) {
            counts.low = glm::min(counts.low, scene.mesh.positions[corner]);
            counts.high = glm::max(counts.high, scene.mesh.positions[corner]);
        }
        if (scene.materials[scene.mesh.materials[i]].emission != glm::vec3(0.0f))
            ++counts.emissiveTriangles;
    }
    const auto missing =
        std::count_if(input.warnings.begin(), input.warnings.end(), [](const Warning& warning) {
            return warning.kind == WarningKind::unusableTexture;
        });
    counts.texturesFound = scene.textures.size() + scene.scalarTextures.size();
    counts.texturesNamed = counts.texturesFound + (size_t) missing;
    std::set<const void*> counted; // some share their texels
    const auto count = [&](const auto& texture) {
        if (counted.insert(texture.identity()).second) counts.textureBytes += texture.bytes();
    };
    for (const Texture& texture : scene.textures) count(texture);
    for (const ScalarTexture& texture : scene.scalarTextures) count(texture);
    return counts;
}

Json materialFilesJson(const std::vector<MaterialFile>& files) {
    Json rows = Json::array();
    for (const MaterialFile& file : files)
        rows.push_back({{"file", printable(file.file.string())},
                        {"convention", nameOf(file.convention)},
                        {"reason", file.reason}});
    return rows;
}

/// Of the model files.
Json camerasJson(const Input& input) {
    Json list = Json::array();
    for (size_t i = 0; i < input.cameras.size(); ++i)
        list.push_back({{"name", input.cameras[i].name},
                        {"perspective", !input.cameras[i].halfHeight},
                        {"used", input.modelCamera == i}});
    return list;
}

Json animationJson(const Animation& animation) {
    size_t vertices = 0;
    for (const MovingPart& part : animation.parts) vertices += part.positions.size();
    return {{"fps", animation.fps},
            {"last_frame", animation.lastFrame()},
            {"moving_vertices", vertices},
            {"moving_camera", animation.camera.has_value()}};
}

Json requirementsJson(const Requirements& need, const Input& input, bool rasterizes) {
    Json json = Json::object();
    for (const RequirementReason& row : explain(need, input.scene, input.settings, rasterizes))
        json[row.name] = {{"required", row.required}, {"reason", row.reason}};
    return json;
}

/// Every buffer of a frame: those of the structure as they are after the build, those of the paths
/// as they will be.
Json bufferJson(const Requirements& need, const Input& input, const Backend& backend) {
    const Scene& scene = input.scene;
    const GridSettings& grid = input.settings.grid;
    std::map<std::string, std::string> reasons;
    for (const PlannedBuffer& row :
         planStructure(grid, scene.camera, scene.mesh.triangles.size(), backend.listEntries()))
        reasons[row.name] = row.reason;
    reasons["light grid"] = "triangles as the light sees them, for shadow rays";
    reasons["leaf blocks"] = "the lists as the CPU traces them: boxes and ids, sixteen at a time";
    reasons["fragments"] = "pairs of triangles and tiles on their way into lists";
    reasons["states of rays"] = "where rays stand between dispatches";
    reasons["embree scene"] = "Embree's copy of the triangles, and its tree";
    Json rows = Json::array();
    for (const BufferSize& buffer : backend.memory()) {
        const auto known = reasons.find(buffer.name);
        rows.push_back({{"name", buffer.name},
                        {"bytes", buffer.bytes},
                        {"reason", known == reasons.end() ? "the backend's own" : known->second}});
    }
    for (const PlannedBuffer& row : planPaths(need, grid))
        rows.push_back({{"name", row.name}, {"bytes", row.bytes}, {"reason", row.reason}});
    return rows;
}

Json precisionJson(const PrecisionReach& reach) {
    return {{"diagonal", reach.diagonal},
            {"world_spacing", reach.worldSpacing},
            {"frame_spacing", reach.frameSpacing},
            {"triangles_without_area", reach.withoutArea},
            {"triangles_flattened", reach.flattened}};
}

Json costJson(const Footprint& footprint, const Input& input) {
    const GridCost cost = gridCost(footprint, input.settings.grid);
    return {{"tile_chosen", input.tileChosen},
            {"bins_chosen", input.binsChosen},
            {"build_ns", cost.build},
            {"ray_ns", cost.ray}};
}

Json predictedJson(const Forecast& forecast, double listEntries) {
    return {{"build_ms", forecast.buildMs},
            {"sample_ms", forecast.sampleMs},
            {"frame_ms", forecast.frameMs},
            {"rays", std::llround(forecast.rays)},
            {"shadow_rays", std::llround(forecast.shadowRays)},
            {"memory", forecast.memory},
            {"list_entries", std::llround(listEntries)}};
}

Json describe(const Input& input, const Backend& backend, const Executor& executor,
              std::span<const PassTime> build) {
    const Scene& scene = input.scene;
    const SceneCounts counts = count(input);
    Json json = reportOf(input, backend, executor, build);
    json["materials"] = scene.materials.size();
    json["material_files"] = materialFilesJson(input.materialFiles);
    json["textures"] = {{"found", counts.texturesFound},
                        {"named", counts.texturesNamed},
                        {"bytes", counts.textureBytes}};
    json["lights"] = scene.lights.size();
    json["emissive_triangles"] = counts.emissiveTriangles;
    json["background"] = vectorJson(scene.background);
    json["bounds"] = {{"min", vectorJson(scene.inFiles(counts.low))},
                      {"max", vectorJson(scene.inFiles(counts.high))}};
    json["origin"] = vectorJson(scene.origin);
    json["camera"] = {{"eye", vectorJson(scene.inFiles(scene.camera.eye))},
                      {"target", vectorJson(scene.inFiles(scene.camera.target))},
                      {"up", vectorJson(scene.camera.up)},
                      {"fov", scene.camera.verticalFov}};
    json["cameras"] = camerasJson(input);
    json["animation"] = animationJson(scene.animation);
    const bool rasterizes = backend.rasterizes();
    const Requirements need = requirementsOf(scene, input.settings, rasterizes);
    json["requirements"] = requirementsJson(need, input, rasterizes);
    json["buffers"] = bufferJson(need, input, backend);
    json["precision"] = precisionJson(input.precision);
    json["memory_budget"] = {{"limit", input.memory.limit},
                             {"scene", input.memory.scene},
                             {"frame", input.memory.frame}};
    json["warnings"] = Json::array();
    for (const Warning& warning : input.warnings) json["warnings"].push_back(warning.text);
    json["ignored"] = input.ignored;
    return json;
}

void printRow(const char* label, const std::string& text) {
    std::printf("  %-22s %s\n", label, text.c_str());
}

std::string megabytes(uint64_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%10.2f MB", (double) bytes / 1e6);
    return text;
}

std::string vectorText(const Json& v) {
    char text[96];
    std::snprintf(text, sizeof text, "(%g, %g, %g)", v[0].get<double>(), v[1].get<double>(),
                  v[2].get<double>());
    return text;
}

/// With all digits that a scene far from 0 needs.
std::string pointText(const Json& v, const Json& origin) {
    if (origin == Json{0.0, 0.0, 0.0}) return vectorText(v);
    char text[96];
    std::snprintf(text, sizeof text, "(%.12g, %.12g, %.12g)", v[0].get<double>(),
                  v[1].get<double>(), v[2].get<double>());
    return text;
}

std::string countText(const Json& number) {
    return std::to_string(number.get<uint64_t>());
}

void printList(const char* label, const Json& lines) {
    printRow(label, lines.empty() ? "none" : std::to_string(lines.size()));
    for (const Json& line : lines) std::printf("    %s\n", line.get<std::string>().c_str());
}

std::string animationText(const Json& animation) {
    const bool moves = animation["moving_vertices"] > 0, looks = animation["moving_camera"];
    if (!moves && !looks) return "none";
    char fps[32];
    std::snprintf(fps, sizeof fps, "%g", animation["fps"].get<double>());
    return countText(animation["moving_vertices"]) + " vertices" + (looks ? ", the camera" : "") +
           "; the last frame is " + countText(animation["last_frame"]) + ", at " + fps +
           " a second";
}

std::string camerasText(const Json& cameras) {
    std::string text;
    for (size_t i = 0; i < cameras.size(); ++i) {
        const Json& camera = cameras[i];
        text += (i == 0 ? "" : ", ") + std::to_string(i);
        if (camera["name"] != "") text += " " + inQuotes(camera["name"].get<std::string>());
        if (!camera["perspective"]) text += " (orthographic)";
        if (camera["used"]) text += " (used)";
    }
    return text.empty() ? "none" : text;
}

void printScene(const Json& info) {
    std::printf("%s\n", info["scene"].get<std::string>().c_str());
    printRow("triangles", countText(info["triangles"]));
    printRow("of them emissive", countText(info["emissive_triangles"]));
    printRow("materials", countText(info["materials"]));
    std::vector<std::string> files;
    for (const Json& row : info["material_files"])
        files.push_back(row["file"].get<std::string>() + ": " +
                        row["convention"].get<std::string>() + ", as " +
                        row["reason"].get<std::string>());
    printList("material files", files);
    printRow("textures", countText(info["textures"]["found"]) + " of " +
                             countText(info["textures"]["named"]) + " that are named, " +
                             megabytes(info["textures"]["bytes"]));
    printRow("lights", countText(info["lights"]));
    printRow("background", vectorText(info["background"]));
    const Json& origin = info["origin"];
    const auto points = [&](const Json& a, const char* between, const Json& b) {
        return pointText(a, origin) + between + pointText(b, origin);
    };
    printRow("box", points(info["bounds"]["min"], " .. ", info["bounds"]["max"]));
    printRow("origin", pointText(origin, origin));
    printRow("camera", points(info["camera"]["eye"], " to ", info["camera"]["target"]));
    printRow("of the files", camerasText(info["cameras"]));
    printRow("animation", animationText(info["animation"]));
    printRow("without area", countText(info["precision"]["triangles_without_area"]) +
                                 " triangles, which no ray hits");
    printList("warnings", info["warnings"]);
    printList("without effect", info["ignored"]);
}

void printStructure(const Json& info) {
    std::printf("structure (%s, %s)\n", info["backend"].get<std::string>().c_str(),
                info["device"].get<std::string>().c_str());
    printRow("image", countText(info["size"][0]) + "x" + countText(info["size"][1]) + ", " +
                          countText(info["spp"]) + " samples, " + countText(info["bounces"]) +
                          " bounces");
    printRow("views", countText(info["views"]) + ", " + info["view"].get<std::string>());
    const Json& cost = info["cost_model"];
    const auto chosen = [&](const char* key) { return cost[key] ? " (by cost)" : ""; };
    printRow("tile and bins", countText(info["tile"]) + " pixels" + chosen("tile_chosen") + ", " +
                                  countText(info["bins"]) + chosen("bins_chosen"));
    char costs[96];
    std::snprintf(costs, sizeof costs, "%.1f ms of a thread for the build, %.0f ns a diffuse ray",
                  cost["build_ns"].get<double>() / 1e6, cost["ray_ns"].get<double>());
    printRow("what they add", costs);
    printRow("list entries", countText(info["list_entries"]));
    for (const Json& pass : info["passes"]) {
        char text[32];
        std::snprintf(text, sizeof text, "%10.2f ms", pass["ms"].get<double>());
        printRow(pass["name"].get<std::string>().c_str(), text);
    }
}

void printRequirements(const Json& info) {
    std::printf("requirements\n");
    for (const auto& [name, row] : info["requirements"].items())
        printRow(name.c_str(), std::string(row["required"].get<bool>() ? "yes: " : "no: ") +
                                   row["reason"].get<std::string>());
    uint64_t total = 0;
    std::printf("buffers\n");
    for (const Json& row : info["buffers"]) {
        total += row["bytes"].get<uint64_t>();
        printRow(row["name"].get<std::string>().c_str(),
                 megabytes(row["bytes"].get<uint64_t>()) + "  " + row["reason"].get<std::string>());
    }
    printRow("total", megabytes(total));
    const Json& budget = info["memory_budget"];
    printRow("of a budget of", megabytes(budget["limit"]) + ", of which the scene takes " +
                                   memoryText(budget["scene"]) + " and a frame about " +
                                   memoryText(budget["frame"]));
}

void printPredicted(const Json& predicted) {
    const auto ms = [&](const char* key) {
        char text[32];
        std::snprintf(text, sizeof text, "%10.2f ms", predicted[key].get<double>());
        return std::string(text);
    };
    std::printf("predicted\n");
    printRow("build", ms("build_ms"));
    printRow("a sample", ms("sample_ms"));
    printRow("the frame", ms("frame_ms"));
    printRow("memory", megabytes(predicted["memory"]));
    printRow("rays", countText(predicted["rays"]) + ", and " + countText(predicted["shadow_rays"]) +
                         " to the light");
    printRow("list entries", countText(predicted["list_entries"]));
}

void runInfo(const InfoOptions& options) {
    const auto executor = makeExecutor(options.common);
    CommonOptions common = options.common;
    common.quiet = true; // the warnings are part of what is printed
    const Input input = openInput(common, *executor);
    const auto backend = makeBackend(options.common, *executor);
    const Scene& scene = input.scene;
    const bool light = requirementsOf(scene, input.settings, backend->rasterizes()).shadowRays;
    backend->expectLight(light ? &scene.lights.front() : nullptr);
    const auto build = backend->build(scene.mesh, scene.camera, input.settings.grid);

    Json info = describe(input, *backend, *executor, build);
    const Footprint footprint(scene.mesh, scene.camera, input.settings.grid, *executor);
    info["cost_model"] = costJson(footprint, input);
    const auto fresh = makeBackend(options.common, *executor);
    info["predicted"] = predictedJson(forecastFrame(scene, input.settings, *fresh),
                                      footprint.listEntries(input.settings.grid));
    if (options.json) {
        std::printf("%s\n", info.dump(2).c_str());
        return;
    }
    printScene(info);
    printStructure(info);
    printRequirements(info);
    printPredicted(info["predicted"]);
}

void printDevices() {
#ifdef DIRT_HAVE_GL
    spareThreads();
    const std::vector<GlDevice> devices = listGlDevices();
    for (size_t i = 0; i < devices.size(); ++i)
        std::printf("%zu  %s\n", i, (devices[i].name + devices[i].problem).c_str());
#else
    throw CapabilityError("--devices: built without the OpenGL backend");
#endif
}

} // namespace

void addInfo(Command program, int&) {
    const Command command =
        program.addCommand("info", "what a scene holds, and what its structure costs");
    const auto options = std::make_shared<InfoOptions>();
    addCommonOptions(command, options->common);
    command.addFlag("--json", options->json, "print one JSON object on standard output");
    command.addAction("--devices", "list the devices of --backend gl, and nothing else",
                      printDevices);
    command.onRun([options] { runInfo(*options); });
}

} // namespace dirt
