#pragma once

#include "core/io/load_report.h"
#include "core/scene/material.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace dirt {

/// One `newmtl` of an MTL file; its texture is not loaded yet.
struct MtlMaterial {
    std::string name; ///< as in the file, without blanks around it; may be empty
    Material material;
    std::string diffuseMap; ///< file name of map_Kd as written; empty: none
    size_t diffuseMapLine = 0;
};

/// Reads an MTL file: newmtl, Kd, Ke and map_Kd. Other keys, and map_Kd's options, are reported as
/// ignored. Throws InputError where the file cannot be read or a colour is malformed, negative or
/// not finite.
std::vector<MtlMaterial> readMtl(const std::filesystem::path& file, LoadReport& report);

} // namespace dirt
