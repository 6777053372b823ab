#include "app/cli/dump_pixel.h"

#include "app/cli/dump_manifest.h"
#include "app/cli/interrupt.h"
#include "app/cli/log.h"
#include "app/cli/pixel_option.h"
#include "core/base/error.h"
#include "core/dump/channels.h"
#include "core/dump/shadow_rays.h"
#include "core/explain/path_account.h"
#include "core/explain/ray_trail.h"
#include "core/io/output_file.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace dirt {

namespace {

/// A record by its channels: NAME, or of those called NAME.X, NAME.Y, … an array.
Json recordJson(const std::vector<ChannelInfo>& channels, const void* record) {
    Json json = Json::object();
    for (const ChannelInfo& info : channels) {
        uint32_t bits;
        std::memcpy(&bits, static_cast<const std::byte*>(record) + info.offset, sizeof bits);
        const bool isWord = info.channel.type == ExrChannel::Type::uint32;
        const Json value = isWord ? Json(bits) : Json(std::bit_cast<float>(bits));
        const std::string& name = info.channel.name;
        const size_t dot = name.rfind('.');
        if (dot == name.npos)
            json[name] = value;
        else
            json[name.substr(0, dot)].push_back(value);
    }
    return json;
}

Json tileJson(const Grid& grid, const TileTrail& tile) {
    Json bins = Json::array();
    for (const BinTrail& bin : tile.bins) {
        const auto list = grid.list(tile.visit.view, tile.visit.tile, bin.bin);
        bins.push_back({{"bin", bin.bin}, {"ids", std::vector(list.begin(), list.end())}});
    }
    return {{"view", tile.visit.view},  {"column", tile.column},  {"row", tile.row},
            {"near", tile.bounds.near}, {"far", tile.bounds.far}, {"bins", bins}};
}

/// The tiles that a ray visits, in its order, with the lists of the bins that it looks into.
Json tilesJson(const Grid& grid, const RayTrail& trail) {
    Json tiles = Json::array();
    for (const ViewTrail& view : trail.views)
        for (const TileTrail& tile : view.tiles) tiles.push_back(tileJson(grid, tile));
    return tiles;
}

/// What the pixel has of a path event.
class EventWriter {
public:
    EventWriter(const PathAccount& account, Backend& backend, std::vector<View> views)
        : account_(account), backend_(backend), views_(std::move(views)) {}

    Json operator()(const EventAccount& event) const {
        Json json = {{"event", event.event}, {"rasterized", event.rasterized}};
        json["rays"] = recordJson(rayChannels(), &event.ray);
        json["hits"] = event.rasterized ? Json() : recordJson(hitChannels(), &event.hit);
        json["point"] =
            event.point.found() ? recordJson(surfacePointChannels(), &event.point) : Json();
        json["shadowrays"] = shadowJson(event);
        for (const auto& [name, radiance] : {std::pair("emitted", event.emitted),
                                             {"reflected", event.reflected},
                                             {"added", event.added}})
            json[name] = vectorJson(radiance);
        json["image"] = vectorJson(event.gathered);
        json["tiles"] = tilesJsonOf(event);
        return json;
    }

private:
    Json shadowJson(const EventAccount& event) const {
        if (!event.shadowRay) return {};
        ShadowRecord record = shadowRecordOf(*event.shadowRay, !event.lit);
        findBlockers(backend_, views_, {&record, 1});
        return recordJson(shadowRayChannels(), &record);
    }
    Json tilesJsonOf(const EventAccount& event) const {
        if (!account_.grid) return {};
        const Ray ray{event.ray.origin, event.ray.direction, event.ray.skip};
        Json json = {{"rays", tilesJson(*account_.grid,
                                        closestTrail(*account_.grid, account_.geometry, ray))},
                     {"shadowrays", Json()}};
        if (const auto& shadow = event.shadowRay)
            json["shadowrays"] =
                tilesJson(*account_.grid,
                          anyTrail(*account_.grid, account_.geometry, shadow->ray, shadow->maxT));
        return json;
    }

    const PathAccount& account_;
    Backend& backend_;
    std::vector<View> views_;
};

} // namespace

void checkPixelOptions(const DumpOptions& options) {
    if (!options.buffers.empty())
        throw InputError("--buffers: has no effect with --pixel, which takes of all its record");
    if (std::filesystem::path(options.output).extension() != ".json")
        throw InputError("-o " + options.output + ": with --pixel its name has to end in .json");
    checkWritable(options.output);
}

int dumpPixel(const DumpOptions& options, const Input& input, Backend& backend,
              const Executor& executor) {
    const auto [x, y] = *options.pixel;
    const GridSettings& grid = input.settings.grid;
    checkPixel("--pixel", *options.pixel, input.settings);
    checkWritable(options.output); // now that the inputs are known
    catchInterrupts();
    const PathAccount account =
        accountOf(input.scene, input.settings, backend,
                  (size_t) y * (size_t) grid.width + (size_t) x, options.sample, interrupted);
    if (interrupted()) return interruptStatus();

    Json json = dumpReport(input, backend, executor, options.sample, account.geometry.frame);
    json["pixel"] = {x, y};
    json["events"] = Json::array();
    const EventWriter write(account, backend, makeViews(grid, input.scene.camera));
    for (const EventAccount& event : account.events)
        if (!options.event || *options.event == event.event) json["events"].push_back(write(event));
    json["radiance"] = vectorJson(account.radiance);
    const std::string text = json.dump(2) + "\n";
    writeFile(options.output, text);
    if (options.json) std::fputs(text.c_str(), stdout);
    sayWritten(options.output, options.common.quiet);
    return 0;
}

} // namespace dirt
