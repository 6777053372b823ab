#pragma once

#include "backend_cpu/build/fragments.h"
#include "backend_cpu/build/raster_tables.h"
#include "core/grid/grid.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dirt {

/// The fragments of triangles [begin, end), at most kTrianglesPerPiece of them: those that core's
/// scanTriangle emits, bit for bit. \p tables are those of \p grid.
inline constexpr size_t kTrianglesPerPiece = 1024;
void rasterize(const FrameGeometry& geometry, const Grid& grid, const RasterTables& tables,
               size_t begin, size_t end, RasterPiece& piece);

/// The same of some triangles only: \p ids, increasing and counted from triangle \p first.
void rasterizeSome(const FrameGeometry& geometry, const Grid& grid, const RasterTables& tables,
                   size_t first, std::span<const uint32_t> ids, RasterPiece& piece);

} // namespace dirt
