#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace dirt {

/// What the numbers of an MTL file mean.
enum class MaterialConvention : uint8_t {
    demo,     ///< as the 2017 demo has them: Ks is F0, Ns of 127 a mirror
    wavefront ///< as other programs have them: Kd the colour, Ks a highlight, Ns to 1000
};

/// "demo" or "wavefront".
std::string_view nameOf(MaterialConvention convention);

/// The convention of that name; nothing where there is none.
std::optional<MaterialConvention> parseMaterialConvention(std::string_view name);

/// What is said of an object's convention, and who says it.
struct MaterialChoice {
    enum class By : uint8_t {
        option,    ///< --materials
        object,    ///< the attribute of `<object>`
        world,     ///< that of `<world>`
        sceneFile, ///< nobody: what a .scene file places
        bareModel  ///< nobody: a model by itself
    };

    By by = By::bareModel;
    MaterialConvention convention = MaterialConvention::wavefront;

    auto operator<=>(const MaterialChoice&) const = default;

    /// Of an object of a .scene file: what the file says, the object's word before the world's.
    static MaterialChoice inSceneFile(std::optional<MaterialConvention> world,
                                      std::optional<MaterialConvention> object);
};

/// How an MTL file was taken.
struct MaterialFile {
    std::filesystem::path file;
    MaterialConvention convention;
    std::string reason; ///< "it says metallic"

    bool operator==(const MaterialFile&) const = default;
};

/// How \p file is taken. Where nobody chooses, a file with the key `metallic`, which the demo's
/// alone have, is the demo's.
MaterialFile decideConvention(const std::filesystem::path& file, const MaterialChoice& choice,
                              bool saysMetallic);

} // namespace dirt
