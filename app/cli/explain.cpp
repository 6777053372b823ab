#include "app/cli/commands.h"
#include "app/cli/explain_json.h"
#include "app/cli/explain_ray.h"
#include "app/cli/explain_text.h"
#include "app/cli/input.h"
#include "app/cli/interrupt.h"
#include "app/cli/option_values.h"
#include "app/cli/pixel_option.h"
#include "app/cli/ray_image.h"
#include "core/base/error.h"
#include "core/preview/tile_picture.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

namespace dirt {

namespace {

struct ExplainOptions {
    CommonOptions common;
    std::optional<std::array<int, 2>> pixel;
    std::optional<std::array<int, 3>> tile; ///< view, column, row
    std::optional<int64_t> primitive;
    std::optional<int> event;       ///< none: all
    std::optional<uint32_t> sample; ///< none: the first
    std::optional<Ray> ray;
    std::optional<uint32_t> skip;
    std::optional<float> maxT;
    std::optional<std::string> image; ///< a PNG file of the rays
    bool json = false;
};

void print(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
}

/// 1 where the backend's answer is not that of the definition over its own grid.
int explainPixel(const ExplainOptions& options, const Input& input, Backend& backend) {
    const auto [x, y] = *options.pixel;
    const uint32_t sample = options.sample.value_or(0);
    checkPixel("--pixel", *options.pixel, input.settings);
    checkEvent(options.event, input.settings);
    catchInterrupts();
    const PathAccount account = accountOf(
        input.scene, input.settings, backend,
        (size_t) y * (size_t) input.settings.grid.width + (size_t) x, sample, interrupted);
    if (interrupted()) return interruptStatus();
    if (options.image) {
        const std::string place = std::to_string(x) + ", " + std::to_string(y);
        const std::string title = "pixel (" + place + "), sample " + std::to_string(sample) +
                                  " of " + input.scene.name + ", " + backend.name();
        writeRayImage(*options.image, drawRays(account, title, options.event), title);
    }
    Json json = {{"scene", input.scene.name},
                 {"backend", backend.name()},
                 {"pixel", {x, y}},
                 {"sample", sample},
                 {"events", Json::array()}};
    std::string text = "pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), sample " +
                       std::to_string(sample) + " of " + input.scene.name + ", " + backend.name() +
                       "\n";
    bool agrees = true;
    for (const EventAccount& event : account.events) {
        if (options.event && *options.event != event.event) continue;
        const std::vector<ExplainedRay> rays = raysOf(account, event);
        json["events"].push_back(eventJson(event, rays));
        text += eventText(input.scene, account, event);
        for (const ExplainedRay& ray : rays) {
            text += rayText(account.grid, ray);
            const std::string problem = disagreement(event, ray);
            agrees = agrees && problem.empty();
            if (!problem.empty()) text += "  DIFFERENT: " + problem + "\n";
        }
    }
    json["radiance"] = {account.radiance.x, account.radiance.y, account.radiance.z};
    char sum[128];
    std::snprintf(sum, sizeof sum, "radiance (%.9g, %.9g, %.9g)\n", (double) account.radiance.x,
                  (double) account.radiance.y, (double) account.radiance.z);
    print(options.json ? json.dump(2) + "\n" : text + sum);
    return agrees ? 0 : 1;
}

std::vector<TileEntry> entriesOf(const ExplainOptions& options, const Grid& grid,
                                 const FrameGeometry& geometry) {
    if (options.primitive) {
        const size_t count = geometry.triangles.size();
        if ((uint64_t) *options.primitive >= count)
            throw InputError("--primitive " + std::to_string(*options.primitive) + ": there are " +
                             std::to_string(count) + ", counted from 0");
        return entriesOfPrimitive(grid, geometry, (uint32_t) *options.primitive);
    }
    const auto [view, column, row] = *options.tile;
    if ((size_t) view >= grid.views.size())
        throw InputError("--tile: view " + std::to_string(view) + ": there are " +
                         std::to_string(grid.views.size()) + ", counted from 0");
    const View& seen = grid.views[(size_t) view];
    if (column >= seen.columns || row >= seen.rows)
        throw InputError("--tile: the view has " + std::to_string(seen.columns) + "x" +
                         std::to_string(seen.rows) + " tiles");
    return entriesOfTile(grid, geometry, view, column, row);
}

/// 1 where an entry is missing or not due.
int explainLists(const ExplainOptions& options, const Input& input, Backend& backend) {
    if (!backend.hasGrid())
        throw InputError("--tile VIEW,X,Y and --primitive: the backend " + backend.name() +
                         " has no lists");
    backend.build(input.scene.mesh, input.scene.camera, input.settings.grid);
    const Grid grid = backend.readGrid();
    const std::vector<TileEntry> entries = entriesOf(options, grid, backend.readGeometry());
    size_t wrong = 0;
    for (const TileEntry& entry : entries) wrong += !entry.isRight();
    std::string what;
    if (options.primitive)
        what = "primitive " + std::to_string(*options.primitive);
    else
        what = tileLine(grid, (*options.tile)[0], (*options.tile)[1], (*options.tile)[2]);
    if (options.image) {
        const auto [view, column, row] = *options.tile;
        const std::string title = what + " of " + input.scene.name + ", " + backend.name();
        writeRayImage(*options.image, drawEntries(grid, entries, view, column, row, title), title);
    }
    if (options.json)
        print(Json({{"scene", input.scene.name},
                    {"backend", backend.name()},
                    {"of", what},
                    {"entries", entriesJson(entries)}})
                  .dump(2) +
              "\n");
    else
        print(what + " of " + input.scene.name + ", " + backend.name() + ": " +
              std::to_string(entries.size()) + " entries, " + std::to_string(wrong) + " wrong\n" +
              entriesText(input.scene, grid, entries));
    return wrong == 0 ? 0 : 1;
}

/// Options that say more of a subject that is not asked about would have no effect.
void checkSubject(const ExplainOptions& o) {
    if (o.pixel.has_value() + o.tile.has_value() + o.primitive.has_value() + o.ray.has_value() != 1)
        throw InputError(
            "explain: one of --pixel X,Y, --tile VIEW,X,Y, --primitive ID and --ray says what");
    const auto refuse = [](bool given, const char* option, const char* subject) {
        if (given) throw InputError(std::string(option) + ": has no effect without " + subject);
    };
    refuse(o.event && !o.pixel, "--event", "--pixel");
    refuse(o.sample && !o.pixel, "--sample", "--pixel");
    refuse(o.skip && !o.ray, "--skip", "--ray");
    refuse(o.maxT && !o.ray, "--max-t", "--ray");
    refuse(o.image && !o.pixel && !o.ray && !o.tile, "--image",
           "--pixel, --ray or --tile VIEW,X,Y");
}

int runExplain(const ExplainOptions& options) {
    checkSubject(options);
    if (options.image) checkRayImage(*options.image);
    const auto executor = makeExecutor(options.common);
    const Input input = openInput(options.common, *executor);
    const auto backend = makeBackend(options.common, *executor);
    if (options.image) {
        checkRayImage(*options.image); // now that the inputs are known
        if (!backend->hasGrid())
            throw InputError("--image: the backend " + backend->name() + " has no grid to draw");
    }
    if (options.ray) {
        AskedRay asked{*options.ray, options.maxT};
        asked.ray.skip = options.skip.value_or(kNoPrimitive);
        return explainRay(input, *backend, asked, options.image, options.json);
    }
    return options.pixel ? explainPixel(options, input, *backend)
                         : explainLists(options, input, *backend);
}

/// --tile has two meanings here, and may be given twice: N pixels, as everywhere, and VIEW,X,Y, the
/// tile that is asked about.
void addTile(Command command, ExplainOptions& options) {
    const auto read = [&options, &common = options.common](const std::string& text) {
        if (text.find(',') != text.npos) {
            const auto at = readIntegers("--tile", text, 3, 65535, "VIEW,X,Y");
            options.tile = std::array{at[0], at[1], at[2]};
        } else {
            common.tile = readIntegers("--tile", text, 1, 64, "N or VIEW,X,Y").front();
            common.given.emplace_back("--tile");
            if (*common.tile == 0) throw InputError("--tile: '0' is not a number from 1 to 64");
        }
    };
    command.replaceByReader("--tile", "N|VIEW,X,Y", "; VIEW,X,Y: what that tile lists", read);
}

} // namespace

void addExplain(Command program, int& status) {
    const Command command = program.addCommand(
        "explain",
        "what happened to a pixel: its path, each ray's way through the grid, each test; "
        "or what a tile lists, or where a primitive is listed");
    const auto options = std::make_shared<ExplainOptions>();
    addCommonOptions(command, options->common);
    addTile(command, *options);
    addIntegers(command, "--pixel", 2, 65535, "X,Y", "from the top left, counted from 0",
                [options](const std::vector<int>& at) {
                    options->pixel = std::array{at[0], at[1]};
                });
    addInteger(command, "--primitive", 0, kNoPrimitive - 1, "where a triangle is listed",
               [options](int64_t id) { options->primitive = id; });
    addInteger(command, "--sample", 0, 0x7fffffff, "of the pixel (default: 0)",
               [options](int64_t n) { options->sample = (uint32_t) n; });
    addInteger(command, "--event", 0, 1023, "only this path event (default: all)",
               [options](int64_t k) { options->event = (int) k; });
    addNumbers(command, "--ray", 6, "OX,OY,OZ,DX,DY,DZ",
               "origin and direction of a ray, in the grid frame",
               [options](const std::vector<double>& v) {
                   options->ray = Ray{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, kNoPrimitive};
               });
    addInteger(command, "--skip", 0, kNoPrimitive - 1, "the triangle that the ray starts on",
               [options](int64_t id) { options->skip = (uint32_t) id; });
    addNumber(command, "--max-t", 0.0f, HUGE_VALF, "ask whether anything is hit before",
              [options](float t) { options->maxT = t; });
    command.addText(
        "--image", options->image,
        "draw the rays of --pixel, --ray, or what the tile of --tile lists, as a PNG file");
    command.addFlag("--json", options->json, "print JSON");
    command.onRun([options, &status] { status = runExplain(*options); });
}

} // namespace dirt
