#include "core/dump/dump.h"

#include "core/dump/entries.h"
#include "core/dump/manifest.h"
#include "core/io/output_file.h"

#include <cstring>
#include <utility>

namespace dirt {

namespace {

/// Triangles in a row of the triangle buffer's picture.
constexpr int kTrianglesPerRow = 4096;

std::vector<ChannelInfo> channelsOf(const auto& layers) {
    std::vector<ChannelInfo> channels;
    for (const auto& layer : layers)
        channels.insert(channels.end(), layer.channels.begin(), layer.channels.end());
    return channels;
}

} // namespace

std::string viewName(const Grid& grid, size_t view) {
    if (grid.settings.mode == ViewMode::single) return "camera";
    return std::string(1, grid.views[view].signW > 0.0f ? '+' : '-') +
           (char) ('X' + grid.views[view].axisW);
}

Dump::Dump(std::string folder, int width, int height, ImageMetadata metadata)
    : folder_(std::move(folder)), width_(width), height_(height), metadata_(std::move(metadata)) {}

ExrPart Dump::gather(const std::string& name, int width, int height,
                     const std::vector<Layer>& layers) const {
    ExrPart part{name, width, height, {}, {}};
    const std::vector<ChannelInfo> channels = channelsOf(layers);
    for (const ChannelInfo& info : channels)
        part.channels.push_back({info.inFile, info.channel.type});
    const size_t pixels = (size_t) width * height;
    part.values.resize(pixels * channels.size());
    uint32_t* value = part.values.data();
    for (size_t pixel = 0; pixel < pixels; ++pixel)
        for (const Layer& layer : layers) {
            const auto* record =
                static_cast<const std::byte*>(layer.records) + pixel * layer.stride;
            for (const ChannelInfo& info : layer.channels)
                std::memcpy(value++, record + info.offset, sizeof *value);
        }
    return part;
}

void Dump::write(const std::string& buffer, std::optional<int> event,
                 const std::vector<ExrPart>& parts, std::vector<ChannelInfo> channels) {
    const std::string file = dumpFileName(buffer, event);
    writeExr(folder_ + "/" + file, parts, metadata_);
    DumpedFile& dumped =
        files_.emplace_back(DumpedFile{file, buffer, event, {}, std::move(channels)});
    for (const ExrPart& part : parts) dumped.parts.push_back(part.name);
}

void Dump::writePixels(const std::string& buffer, std::optional<int> event,
                       const std::vector<Layer>& layers) {
    write(buffer, event, {gather(buffer, width_, height_, layers)}, channelsOf(layers));
}

void Dump::triangles(const FrameGeometry& geometry) {
    const int count = (int) geometry.triangles.size();
    const int width = std::min(count, kTrianglesPerRow);
    const int height = (count + width - 1) / width;
    std::vector<Triangle> padded = geometry.triangles;
    padded.resize((size_t) width * height, Triangle{});
    write("triangles", {},
          {gather("triangles", width, height,
                  {{triangleChannels(), padded.data(), sizeof(Triangle)}})},
          triangleChannels());
}

void Dump::depth(const Grid& grid) {
    std::vector<ExrPart> parts;
    for (size_t view = 0; view < grid.views.size(); ++view)
        for (size_t level = 0; level < grid.pyramids[view].levels.size(); ++level) {
            const DepthPyramid::Level& tiles = grid.pyramids[view].levels[level];
            parts.push_back(gather(viewName(grid, view) + ".level" + std::to_string(level),
                                   tiles.columns, tiles.rows,
                                   {{depthChannels(), tiles.bounds.data(), sizeof(DepthBounds)}}));
        }
    write("depth", {}, parts, depthChannels());
}

void Dump::ids(const Grid& grid, const FrameGeometry& geometry) {
    std::vector<DeepExrPart> parts;
    DumpedFile dumped{dumpFileName("ids", {}), "ids", {}, {}, entryChannels()};
    for (size_t view = 0; view < grid.views.size(); ++view) {
        const View& tiles = grid.views[view];
        DeepExrPart& part = parts.emplace_back(
            DeepExrPart{viewName(grid, view), tiles.columns, tiles.rows, {}, {}, {}});
        for (const ChannelInfo& info : entryChannels()) part.channels.push_back(info.channel);
        for (const std::vector<ListEntry>& entries : listEntriesOf(grid, geometry, (int) view)) {
            part.counts.push_back((uint32_t) entries.size());
            for (const ListEntry& entry : entries) {
                const auto* words = reinterpret_cast<const uint32_t*>(&entry);
                part.values.insert(part.values.end(), words, words + 5);
            }
        }
        dumped.parts.push_back(part.name);
    }
    writeExr(folder_ + "/" + dumped.file, parts, metadata_);
    files_.push_back(std::move(dumped));
    idsAsText(grid);
}

void Dump::idsAsText(const Grid& grid) {
    const std::vector<std::pair<const char*, const char*>> columns = {
        {"view", "view of the tile"},
        {"column", "of the tile"},
        {"row", "of the tile"},
        {"bin", "depth bin that lists it"},
        {"id", "primitive id of the list entry"}};
    DumpedFile& dumped = files_.emplace_back(DumpedFile{kIdsAsText, "ids", {}, {}, {}});
    std::string text;
    for (const auto& [name, meaning] : columns) {
        ChannelInfo& column = dumped.channels.emplace_back(flagChannels(name, meaning).front());
        column.inFile = name;
        text.append(text.empty() ? "" : ",").append(name);
    }
    text += "\n";
    for (size_t view = 0; view < grid.views.size(); ++view) {
        const View& tiles = grid.views[view];
        for (int tile = 0; tile < tiles.tiles(); ++tile) {
            const std::string place = std::to_string(view) + "," +
                                      std::to_string(tile % tiles.columns) + "," +
                                      std::to_string(tile / tiles.columns) + ",";
            for (int bin = 0; bin < grid.settings.bins; ++bin)
                for (const uint32_t id : grid.list((int) view, tile, bin))
                    text += place + std::to_string(bin) + "," + std::to_string(id) + "\n";
        }
    }
    writeFile(folder_ + "/" + kIdsAsText, text);
}

void Dump::shadowMap(const std::vector<float>& depths) {
    if (depths.empty()) return;
    const int side = (int) std::lround(std::sqrt((double) depths.size()));
    write("shadowmap", {},
          {gather("shadowmap", side, side, {{shadowMapChannels(), depths.data(), sizeof(float)}})},
          shadowMapChannels());
}

void Dump::direct(const PathBuffers& paths) {
    writePixels("direct", {}, {{surfacePointChannels(), paths.next.data(), sizeof(SurfacePoint)}});
}

void Dump::rays(const PathBuffers& paths, int event) {
    if (paths.rays.empty()) return;
    writePixels("rays", event, {{rayChannels(), paths.rays.data(), sizeof(PathRay)}});
}

void Dump::hits(const PathBuffers& paths, int event) {
    if (paths.hits.empty()) return;
    writePixels("hits", event, {{hitChannels(), paths.hits.data(), sizeof(Hit)}});
}

void Dump::flags(const std::string& buffer, int event, const std::vector<uint8_t>& values,
                 const std::vector<ChannelInfo>& channels) {
    if (values.empty()) return;
    const std::vector<uint32_t> words(values.begin(), values.end());
    writePixels(buffer, event, {{channels, words.data(), sizeof(uint32_t)}});
}

void Dump::mask(const PathBuffers& paths, int event) {
    flags("mask", event, paths.mask, flagChannels("alive", "1: the pixel's path goes on"));
}

void Dump::shadowRays(const std::vector<ShadowRecord>& rays, int event) {
    if (rays.empty()) return;
    writePixels("shadowrays", event, {{shadowRayChannels(), rays.data(), sizeof(ShadowRecord)}});
}

void Dump::visibility(const PathBuffers& paths, int event) {
    flags("visibility", event, paths.visibility,
          flagChannels("visible", "1: the light reaches the newest point and adds something"));
}

void Dump::shading(const PathBuffers& paths, int event) {
    std::vector<Layer> layers;
    const auto add = [&](const char* prefix, const std::vector<SurfacePoint>& points) {
        if (!points.empty())
            layers.push_back(
                {withPrefix(prefix, surfacePointChannels()), points.data(), sizeof(SurfacePoint)});
    };
    add("previous", paths.previous);
    add("current", paths.current);
    add("next", paths.next);
    writePixels("shading", event, layers);
}

void Dump::image(const PathBuffers& paths, int event) {
    writePixels("image", event, {{radianceChannels(), paths.radiance.data(), sizeof(glm::vec3)}});
}

} // namespace dirt
