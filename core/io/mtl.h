#pragma once

#include "core/io/load_report.h"
#include "core/io/memory_budget.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// What a texture statement of an MTL file is for.
enum class MtlUse : uint8_t {
    diffuse,   ///< map_Kd
    emission,  ///< map_Ke
    specular,  ///< map_Ks
    exponent,  ///< map_Ns
    opacity,   ///< map_d
    bump,      ///< map_bump or bump
    normal,    ///< norm or map_Kn
    roughness, ///< map_Pr
    metalness, ///< map_Pm
    count
};

/// A texture statement.
struct MtlMap {
    std::string file; ///< as written, without quotes; empty: none
    size_t line = 0;
    std::string_view key;          ///< "map_Kd"
    glm::vec2 scale{1.0f};         ///< -s; texture coordinates times this
    glm::vec2 offset{0.0f};        ///< -o; and plus this
    bool clamps = false;           ///< -clamp on: no repetition
    char channel = 0;              ///< -imfchan: r, g, b, m (alpha) or l (luminance); 0: not said
    bool isLinear = false;         ///< -colorspace linear
    std::optional<float> strength; ///< -bm
};

/// One `newmtl` of an MTL file, as written: what is not there is empty. What it means depends on
/// a MaterialConvention (see mtl_material.h).
struct MtlMaterial {
    std::string name; ///< as in the file, without blanks around it; may be empty
    size_t line = 0;

    std::optional<glm::vec3> ambient, diffuse, specular, emission; ///< Ka, Kd, Ks, Ke
    std::optional<float> exponent;                                 ///< Ns
    std::optional<float> opacity;                                  ///< d
    std::optional<float> transparency;                             ///< Tr
    std::optional<float> metallic;                                 ///< metallic, the demo's
    std::optional<float> roughness, metalness;                     ///< Pr, Pm
    std::optional<int> illumination;                               ///< illum
    std::optional<float> bumpScale; ///< -bm of the last bump statement that has it
    size_t opacityLine = 0;         ///< of d or Tr
    std::array<MtlMap, (size_t) MtlUse::count> maps;

    const MtlMap& map(MtlUse use) const { return maps[(size_t) use]; }
};

struct MtlFile {
    std::filesystem::path file;
    std::vector<MtlMaterial> materials;
    /// Keys and options that no convention knows, each once: "map_Kd -blendu".
    std::vector<std::string> others;
    std::vector<Fault> faults; ///< values that are not read

    /// Whether the key `metallic` is there.
    bool saysMetallic() const;
};

/// Reads an MTL file. Keys count in any letter case. A number that is malformed, negative or not
/// finite is a fault, and its key counts as not there; one beyond what there can be (1; of Ke
/// kMostRadiance; Ns and illum may be anything) is one as well, and taken for that. Throws
/// InputError where the file cannot be read.
MtlFile readMtl(const std::filesystem::path& file);
/// The same; \p memory takes what the result needs.
MtlFile readMtl(const std::filesystem::path& file, MemoryClaim& memory);

} // namespace dirt
