#include "backend_gl/programs.h"

namespace dirt {
namespace {

std::string views(ViewMode mode) {
    return std::string("DIRT_VIEWS ") + (mode == ViewMode::full ? "6" : "1");
}

std::string triangles(Proposal proposal) {
    return std::string("DIRT_TRIANGLES ") + (proposal == Proposal::triangles ? "1" : "0");
}

std::string cases() {
    return "DIRT_CASES " + std::to_string(kSelfTestCases);
}

} // namespace

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

ProgramSource traceSource(bool anyHit, int segments, int segmentBits) {
    return {anyHit ? "Visibility" : "Trace",
            {"trace.comp"},
            {std::string("DIRT_ANY_HIT ") + (anyHit ? "1" : "0"),
             "DIRT_SEGMENTS " + std::to_string(segments),
             "DIRT_SEGMENT_BITS " + std::to_string(segmentBits)},
            {}};
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
    if (found == programs_.end()) found = programs_.emplace(key, Program(shaders_, source)).first;
    found->second.use();
    return found->second;
}

} // namespace dirt
