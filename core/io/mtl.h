#pragma once

#include "core/io/load_report.h"
#include "core/scene/material.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dirt {

/// One `newmtl` of an MTL file; its textures are not loaded yet.
struct MtlMaterial {
    /// A texture statement.
    struct Map {
        std::string file; ///< as written; empty: none
        size_t line = 0;
    };

    std::string name; ///< as in the file, without blanks around it; may be empty
    Material material;
    Map diffuse;     ///< map_Kd
    Map emission;    ///< map_Ke
    Map reflectance; ///< map_Ks
    Map opacity;     ///< map_d
    Map bump;        ///< map_bump or bump
};

/// Reads an MTL file: newmtl, Kd, Ke, Ks, Ns, d, metallic, their maps, and map_bump. Other keys,
/// and the maps' options but bump's -bm, are reported as ignored. Throws InputError where the file
/// cannot be read or a number is malformed, negative or not finite. Reflectance, metallic and
/// opacity beyond 1, and gloss beyond 127, are taken for these.
std::vector<MtlMaterial> readMtl(const std::filesystem::path& file, LoadReport& report);

} // namespace dirt
