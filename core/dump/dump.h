#pragma once

#include "core/dump/channels.h"
#include "core/dump/shadow_rays.h"
#include "core/frame/path_buffers.h"
#include "core/grid/grid.h"

#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// A dumped file and what it holds, for the manifest.
struct DumpedFile {
    std::string file; ///< name in the dump's folder
    std::string buffer;
    std::optional<int> event; ///< path event, where the buffer has several
    std::vector<std::string> parts;
    std::vector<ChannelInfo> channels;
};

/// Writes the buffers of a frame as EXR files, one channel for every number of a record, bits as
/// they are; lists as text, too. Throws InputError where a file cannot be written.
class Dump {
public:
    /// \p folder must exist. Images are \p width x \p height pixels.
    Dump(std::string folder, int width, int height, ImageMetadata metadata);

    /// Triangle buffer: the pixel (id mod 4096, id / 4096).
    void triangles(const FrameGeometry& geometry);
    /// Depth bounds and pyramid: a part for each view and level, a pixel for each tile.
    void depth(const Grid& grid);
    /// Id buffer: a deep part for each view, a pixel for each tile, a sample for each list entry in
    /// the order (bin, Z, id). And ids.csv: a line for each, sorted by view, row, column, bin, id.
    void ids(const Grid& grid, const FrameGeometry& geometry);
    /// The light's shadow map: a pixel for each texel. Writes nothing where there is none.
    void shadowMap(const std::vector<float>& depths);
    /// G[1] as the first pass of a sample has it.
    void direct(const PathBuffers& paths);

    // Buffers of path event \p event, between its Shade and the shift.
    void rays(const PathBuffers& paths, int event);
    void hits(const PathBuffers& paths, int event);
    void mask(const PathBuffers& paths, int event);
    /// Writes nothing where there are none.
    void shadowRays(const std::vector<ShadowRecord>& rays, int event);
    void visibility(const PathBuffers& paths, int event);
    /// G[k-1], G[k], G[k+1] as previous, current and next.
    void shading(const PathBuffers& paths, int event);
    /// Radiance gathered so far.
    void image(const PathBuffers& paths, int event);

    /// What has been written, in order.
    const std::vector<DumpedFile>& files() const { return files_; }

private:
    struct Layer {
        std::vector<ChannelInfo> channels;
        const void* records;
        size_t stride;
    };
    ExrPart gather(const std::string& name, int width, int height,
                   const std::vector<Layer>& layers) const;
    void write(const std::string& buffer, std::optional<int> event,
               const std::vector<ExrPart>& parts, std::vector<ChannelInfo> channels);
    void writePixels(const std::string& buffer, std::optional<int> event,
                     const std::vector<Layer>& layers);
    void idsAsText(const Grid& grid);
    void flags(const std::string& buffer, int event, const std::vector<uint8_t>& values,
               const std::vector<ChannelInfo>& channels);

    std::string folder_;
    int width_, height_;
    ImageMetadata metadata_;
    std::vector<DumpedFile> files_;
};

/// "+X" … "-Z" in full mode, "camera" in single mode.
std::string viewName(const Grid& grid, size_t view);

} // namespace dirt
