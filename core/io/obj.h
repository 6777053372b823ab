#pragma once

#include "core/io/load_report.h"
#include "core/io/memory_budget.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// The statements of an OBJ file that matter to a renderer, in file order: polygons as they are,
/// numbers correctly rounded to double.
struct ObjFile {
    static constexpr uint32_t kNone = 0xffffffffu;

    /// Places in the arrays below, from 0; kNone where a corner has no such attribute.
    struct Corner {
        uint32_t position, texcoord, normal;
    };
    struct Face {
        size_t line;
        size_t firstCorner;
        uint32_t corners;  ///< at least 3
        uint32_t material; ///< into materialNames; kNone before the first usemtl
    };
    /// A name as written, without blanks around it, and where it is first used.
    struct Name {
        std::string text;
        size_t line;
    };

    std::filesystem::path file;
    std::vector<glm::dvec3> positions; ///< those that a face uses fit in float32
    std::vector<glm::vec3> colors;     ///< linear, one a position; empty where all are white
    std::vector<glm::dvec3> normals;   ///< may hold NaN and infinity, as the file does
    std::vector<glm::dvec2> texcoords; ///< may hold NaN and infinity, as the file does
    std::vector<Corner> corners;
    std::vector<Face> faces;
    std::vector<Name> materialNames; ///< of usemtl, each once
    std::vector<Name> libraries;     ///< arguments of mtllib, each once
    std::vector<Fault> faults;       ///< in the order of their first lines
};

/// Reads an OBJ file. Points, lines and groups are skipped, unknown statements reported as
/// ignored. Indices may refer to vertices that come later. A vertex may have a colour, `v x y z r g
/// b`, which is decoded from sRGB as Blender and three.js do.
///
/// Faults in what a picture can do without are warnings, one of each kind: normals that are not
/// finite or zero and texture coordinates that are not finite, which placeMesh leaves out, and
/// indices of either out of range, which become kNone; colours that are none; faces of fewer than
/// three corners, which are skipped; vertices that no face uses and that are not finite.
/// Throws InputError with the line where a number or an index is malformed, a position that a face
/// uses is not finite in float32, or its index is out of range.
///
/// tinyobjloader is not used here: it reads malformed numbers and NaN as 0, is silent about
/// indices out of range, and its float32 positions would be rounded again by a transform.
ObjFile readObj(const std::filesystem::path& file, LoadReport& report);

/// The same; \p memory takes what the result needs.
ObjFile readObj(const std::filesystem::path& file, LoadReport& report, MemoryClaim& memory);

/// The same of the file's \p bytes.
ObjFile parseObj(const std::filesystem::path& file, std::string_view bytes, LoadReport& report,
                 MemoryClaim& memory);

} // namespace dirt
