#pragma once

#include "backend_gl/program.h"
#include "core/frame/point_buffer.h"
#include "core/grid/geometry.h"

#include <map>

namespace dirt {

/// Nodes of the id buffer lie in at most this many segments.
inline constexpr int kMostSegments = 16;

/// Values that the self-test of a stage's arithmetic computes with.
inline constexpr int kSelfTestCases = 64;

/// What propose_tiles.geom draws: rectangles of tiles, or large triangles themselves, which only
/// conservative rasterization makes all their tiles of.
enum class Proposal { rectangles, triangles };

/// What trace.comp searches for: nearest or any hits of RayRecords, nearest hits of paths' rays.
enum class Search { nearest, any, paths };

/// How Shade knows whether the light reaches a point.
enum class LightShading { none, traced, shadowMap, open };

/// How surfaces are fetched: what the scene has, and how its texels are stored.
struct SurfaceVariant {
    bool normals = false, textures = false, bumps = false;
    bool cutOuts = false;
    int texelPieces = 1;
    int texelPieceBits = 0; ///< log2 of a piece's words
    bool normalMaps = false, roughnessMaps = false, metallicMaps = false;
    bool factors = false;                   ///< of maps of Kd
    bool wraps = false, transforms = false; ///< of textures
    bool linearBytes = false;               ///< textures of bytes that are data
    bool colors = false;                    ///< of vertices

    /// Texels of a material (include/materials.glsl).
    int materialTexels() const {
        return factors || normalMaps || roughnessMaps || metallicMaps ? 6 : 4;
    }
    /// Words that a rasterized triangle leaves with its hits.
    int depositWords() const {
        return 10 + (normals ? 9 : 0) + (textures ? 6 : 0) + (colors ? 9 : 0);
    }
};

/// The programs of the passes. Variants differ by what the frame asks for, and by the driver's
/// limits: \p segments of 2^\p segmentBits nodes each. \p format: how points are kept.
ProgramSource loopProbeSource();
ProgramSource transformSource();
ProgramSource largestCoordinateSource();
ProgramSource scaleTrianglesSource();
ProgramSource trianglesAtEyeSource();
ProgramSource fillDepthSource(ViewMode mode, Proposal proposal);
ProgramSource fillDepthMipmapSource();
ProgramSource fillPrimitivesSource(ViewMode mode, Proposal proposal, int segments, int segmentBits);
/// \p resumes: in turns, keeping the state of rays in between. \p cutOuts: surfaces with holes;
/// else null.
ProgramSource traceSource(Search search, Precision precision, bool resumes, int segments,
                          int segmentBits, const SurfaceVariant* cutOuts = nullptr);
ProgramSource clearPathsSource(const PointFormat& format, bool rays, bool current);
ProgramSource depthMaskSource(const PointFormat& format);
ProgramSource raysSource(const PointFormat& format, bool scatters, bool gloss);
ProgramSource directVisibilitySource(const SurfaceVariant& surfaces);
ProgramSource firstPointsSource(const PointFormat& format, const SurfaceVariant& surfaces);
ProgramSource shadowMapSource(const SurfaceVariant& surfaces);
ProgramSource fetchSource(const PointFormat& format, const SurfaceVariant& surfaces, bool raster);
ProgramSource groupHitsSource();
ProgramSource rasterFetchSource(ViewMode mode, const SurfaceVariant& surfaces);
ProgramSource fetchAtEyeSource(const SurfaceVariant& surfaces);
ProgramSource shadowRaysSource(const PointFormat& format, ViewMode mode, bool gloss);
ProgramSource visibilitySource();
ProgramSource shadeSource(const PointFormat& format, bool secondary, bool emission, bool background,
                          LightShading light, bool gloss);
ProgramSource resolveSource();
ProgramSource selfTestRasterSource();
ProgramSource selfTestComputeSource();

/// Compiles programs when they are first asked for, and keeps them.
class Programs {
public:
    explicit Programs(ShaderFiles shaders) : shaders_(std::move(shaders)) {}

    /// Makes the program current and gives it.
    const Program& use(const ProgramSource& source);

    /// Compiles all that were asked for again, so that files that were edited take effect. All stay
    /// as they are where one of them does not compile; throws what Program does.
    void reload();

private:
    struct Compiled {
        ProgramSource source;
        Program program;
    };
    ShaderFiles shaders_;
    std::map<std::string, Compiled> programs_; ///< by name and defines
};

} // namespace dirt
