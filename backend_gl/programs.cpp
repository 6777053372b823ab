#include "backend_gl/programs.h"

namespace dirt {
namespace {

std::string views(ViewMode mode) {
    return std::string("DIRT_VIEWS ") + (mode == ViewMode::full ? "6" : "1");
}

std::string triangles(Proposal proposal) {
    return std::string("DIRT_TRIANGLES ") + (proposal == Proposal::triangles ? "1" : "0");
}

std::string define(const char* name, int value) {
    return std::string(name) + " " + std::to_string(value);
}

std::vector<std::string> surfaceDefines(const SurfaceVariant& surfaces) {
    std::vector<std::string> defines = {define("DIRT_NORMALS", surfaces.normals),
                                        define("DIRT_TEXTURES", surfaces.textures),
                                        define("DIRT_BUMPS", surfaces.bumps),
                                        define("DIRT_NORMAL_MAPS", surfaces.normalMaps),
                                        define("DIRT_ROUGHNESS_MAPS", surfaces.roughnessMaps),
                                        define("DIRT_METALLIC_MAPS", surfaces.metallicMaps),
                                        define("DIRT_TEXTURE_FACTORS", surfaces.factors),
                                        define("DIRT_TEXTURE_WRAPS", surfaces.wraps),
                                        define("DIRT_TEXTURE_TRANSFORMS", surfaces.transforms),
                                        define("DIRT_LINEAR_BYTES", surfaces.linearBytes),
                                        define("DIRT_COLORS", surfaces.colors)};
    if (surfaces.textures) {
        defines.push_back(define("DIRT_TEXEL_PIECES", surfaces.texelPieces));
        defines.push_back(define("DIRT_TEXEL_PIECE_BITS", surfaces.texelPieceBits));
    }
    return defines;
}

/// The same with the size of what a rasterized triangle leaves.
std::vector<std::string> depositDefines(const SurfaceVariant& surfaces) {
    std::vector<std::string> defines = surfaceDefines(surfaces);
    defines.push_back("DIRT_DEPOSIT " + std::to_string(surfaces.depositWords()) + "u");
    return defines;
}

/// What decides whether a surface is there.
std::vector<std::string> cutOutDefines(const SurfaceVariant& surfaces) {
    std::vector<std::string> defines = {define("DIRT_CUT_OUTS", surfaces.cutOuts)};
    if (surfaces.cutOuts)
        for (std::string& line : surfaceDefines(surfaces)) defines.push_back(std::move(line));
    return defines;
}

/// How points are kept.
ProgramSource withPoints(const PointFormat& format, ProgramSource source) {
    if (!format.packed()) return source;
    const auto add = [&](const char* name, uint32_t value) {
        source.defines.push_back(std::string(name) + " " + std::to_string(value) + "u");
    };
    add("DIRT_POINT_WORDS", format.words);
    if (format.normal) add("DIRT_POINT_NORMAL", format.normal);
    if (format.emission) add("DIRT_POINT_EMISSION", format.emission);
    if (format.gloss) add("DIRT_POINT_GLOSS", format.gloss);
    return source;
}

std::string cases() {
    return "DIRT_CASES " + std::to_string(kSelfTestCases);
}

} // namespace

ProgramSource loopProbeSource() {
    return {"loop probe", {"loop_probe.comp"}, {}, {}};
}

ProgramSource transformSource() {
    return {"transform", {"transform.vert"}, {}, {"corner"}};
}

ProgramSource largestCoordinateSource() {
    return {"largest coordinate", {"largest_coordinate.comp"}, {}, {}};
}

ProgramSource scaleTrianglesSource() {
    return {"scale", {"scale_triangles.comp"}, {}, {}};
}

ProgramSource trianglesAtEyeSource() {
    return {"triangles at the eye", {"triangles_at_eye.comp"}, {}, {}};
}

ProgramSource fillDepthSource(ViewMode mode, Proposal proposal) {
    return {"FillDepth",
            {"triangles.vert", "propose_tiles.geom", "fill_depth.frag"},
            {views(mode), triangles(proposal)},
            {}};
}

ProgramSource fillDepthMipmapSource() {
    return {"FillDepthMipmap", {"fill_depth_mipmap.comp"}, {}, {}};
}

ProgramSource fillPrimitivesSource(ViewMode mode, Proposal proposal, int segments,
                                   int segmentBits) {
    return {"FillPrimitives",
            {"triangles.vert", "propose_tiles.geom", "fill_primitives.frag"},
            {views(mode), triangles(proposal), "DIRT_SEGMENTS " + std::to_string(segments),
             "DIRT_SEGMENT_BITS " + std::to_string(segmentBits)},
            {}};
}

ProgramSource traceSource(Search search, Precision precision, bool resumes, int segments,
                          int segmentBits, const SurfaceVariant* cutOuts) {
    std::vector<std::string> defines = {define("DIRT_ANY_HIT", search == Search::any),
                                        define("DIRT_PATHS", search == Search::paths),
                                        define("DIRT_RESUMES", resumes),
                                        define("DIRT_SEGMENTS", segments),
                                        define("DIRT_SEGMENT_BITS", segmentBits),
                                        define("DIRT_CUT_OUTS", cutOuts != nullptr)};
    if (cutOuts)
        for (std::string& line : surfaceDefines(*cutOuts)) defines.push_back(std::move(line));
    const char* const file = precision == Precision::exact ? "trace.comp" : "trace_fast.comp";
    return {search == Search::any ? "Visibility" : "Trace", {file}, std::move(defines), {}};
}

ProgramSource clearPathsSource(const PointFormat& format, bool rays, bool current) {
    return withPoints(format, {"Clear of the paths",
                               {"clear_paths.comp"},
                               {define("DIRT_RAYS", rays), define("DIRT_CURRENT", current)},
                               {}});
}

ProgramSource depthMaskSource(const PointFormat& format) {
    return withPoints(format, {"DepthMask", {"depth_mask.comp"}, {}, {}});
}

ProgramSource raysSource(const PointFormat& format, bool scatters, bool gloss) {
    return withPoints(format, {"Rays",
                               {"rays.comp"},
                               {define("DIRT_SCATTERS", scatters), define("DIRT_GLOSS", gloss)},
                               {}});
}

ProgramSource directVisibilitySource(const SurfaceVariant& surfaces) {
    return {"DirectVisibility",
            {"direct_visibility.vert", "direct_visibility.frag"},
            cutOutDefines(surfaces),
            {}};
}

ProgramSource shadowMapSource(const SurfaceVariant& surfaces) {
    return {"ShadowMap",
            {"triangles.vert", "shadow_map.geom", "shadow_map.frag"},
            cutOutDefines(surfaces),
            {}};
}

ProgramSource firstPointsSource(const PointFormat& format, const SurfaceVariant& surfaces) {
    return withPoints(
        format, {"DirectVisibility's points", {"first_points.comp"}, surfaceDefines(surfaces), {}});
}

ProgramSource fetchSource(const PointFormat& format, const SurfaceVariant& surfaces, bool raster) {
    std::vector<std::string> defines = raster ? depositDefines(surfaces) : surfaceDefines(surfaces);
    defines.push_back(define("DIRT_RASTER", raster));
    return withPoints(format, {"Fetch", {"fetch.comp"}, std::move(defines), {}});
}

ProgramSource groupHitsSource() {
    return {"Fetch's groups", {"group_hits.comp"}, {}, {}};
}

ProgramSource rasterFetchSource(ViewMode mode, const SurfaceVariant& surfaces) {
    std::vector<std::string> defines = depositDefines(surfaces);
    defines.push_back(views(mode));
    defines.push_back(triangles(Proposal::rectangles));
    return {"Fetch's rasterization",
            {"triangles.vert", "propose_tiles.geom", "fetch.frag"},
            std::move(defines),
            {}};
}

ProgramSource fetchAtEyeSource(const SurfaceVariant& surfaces) {
    return {"Fetch at the eye", {"fetch_at_eye.comp"}, depositDefines(surfaces), {}};
}

ProgramSource shadowRaysSource(const PointFormat& format, ViewMode mode, bool gloss) {
    return withPoints(
        format, {"shadow rays",
                 {"shadow_rays.comp"},
                 {define("DIRT_SINGLE", mode == ViewMode::single), define("DIRT_GLOSS", gloss)},
                 {}});
}

ProgramSource visibilitySource() {
    return {"Visibility's answers", {"visibility.comp"}, {}, {}};
}

ProgramSource shadeSource(const PointFormat& format, bool secondary, bool emission, bool background,
                          LightShading light, bool gloss) {
    return withPoints(
        format,
        {"Shade",
         {"shade.comp"},
         {define("DIRT_SECONDARY", secondary), define("DIRT_EMISSION", emission),
          define("DIRT_BACKGROUND", background),
          define("DIRT_LIGHT", light == LightShading::traced || light == LightShading::open),
          define("DIRT_OPEN_LIGHT", light == LightShading::open),
          define("DIRT_SHADOW_MAP", light == LightShading::shadowMap), define("DIRT_GLOSS", gloss)},
         {}});
}

ProgramSource resolveSource() {
    return {"Resolve", {"resolve.comp"}, {}, {}};
}

ProgramSource selfTestRasterSource() {
    return {"self-test", {"self_test.vert", "self_test.geom", "self_test.frag"}, {cases()}, {}};
}

ProgramSource selfTestComputeSource() {
    return {"self-test of compute", {"self_test.comp"}, {cases()}, {}};
}

const Program& Programs::use(const ProgramSource& source) {
    std::string key = source.name;
    for (const std::string& define : source.defines) key += "," + define;
    auto found = programs_.find(key);
    if (found == programs_.end())
        found = programs_.emplace(key, Compiled{source, Program(shaders_, source)}).first;
    const Program& program = found->second.program;
    program.use();
    return program;
}

void Programs::reload() {
    std::map<std::string, Compiled> fresh;
    for (const auto& [key, known] : programs_)
        fresh.emplace(key, Compiled{known.source, Program(shaders_, known.source)});
    programs_ = std::move(fresh);
}

} // namespace dirt
