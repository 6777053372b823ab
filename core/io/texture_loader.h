#pragma once

#include "core/io/load_report.h"
#include "core/io/read_all.h"
#include "core/io/texture_file.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// Loads the textures that materials name into a Scene, each once; those that differ in their
/// sampling alone share their texels. One that is not there or damaged is a warning, and
/// kNoTexture.
class TextureLoader {
public:
    /// An image, and what names it.
    struct Source {
        std::optional<ImageFile> image; ///< none: it is not there
        std::string label;              ///< as written
        std::filesystem::path namedBy;
        size_t line = 0; ///< there
    };

    /// \p budget: for all that is read, where it ends with a MemoryError.
    TextureLoader(Scene& scene, LoadReport& report, MemoryBudget budget = {})
        : scene_(scene), report_(report), budget_(std::move(budget)) {}

    const MemoryBudget& budget() const { return budget_; }

    /// Which numbers a use takes as they are; of others, all in one line, it warns.
    enum class Numbers {
        any, ///< that a texture can hold
        unit ///< from 0 to 1: what is beyond is taken for the nearest
    };

    /// From now on textures are only taken note of, without warnings, and every answer is that
    /// there is none.
    void announce() { announcing_ = true; }
    /// Reads what another loader has taken note of, on threads; each image once.
    void readAhead(const TextureLoader& announced, Executor& executor,
                   const LoadProgress& progress);

    /// In Scene::textures: the image's colours, by the curve of sRGB unless they are floats; or
    /// where they are linear, its first three channels as data (see readDataTexture).
    uint32_t colour(const Source& source, const TextureSampling& sampling = {},
                    TexelEncoding encoding = TexelEncoding::srgb, Numbers numbers = Numbers::any);
    /// The same, of Numbers::unit: what a surface reflects.
    uint32_t reflectance(const Source& source, const TextureSampling& sampling,
                         TexelEncoding encoding = TexelEncoding::srgb);
    /// In Scene::scalarTextures: one channel of the image.
    uint32_t data(const Source& source, const TextureSampling& sampling = {},
                  ImageChannel channel = ImageChannel::red, Numbers numbers = Numbers::any);
    /// The same, of Numbers::unit: roughness, metal, reflectance.
    uint32_t part(const Source& source, const TextureSampling& sampling, ImageChannel channel);
    /// What an image holds of a relief; the other is kNoTexture.
    struct Relief {
        uint32_t heights; ///< in Scene::scalarTextures: one channel
        uint32_t normals; ///< in Scene::textures, linear, where the image is a normal map
    };
    Relief relief(const Source& source, const TextureSampling& sampling, ImageChannel channel);
    /// In Scene::scalarTextures: the image's alpha, if it cuts out a part (see cutsOut).
    uint32_t alpha(const Source& source, float limit = 0.5f, const TextureSampling& sampling = {});

private:
    /// Nothing: the image has no such part. A text: why it could not be read.
    using Value = std::variant<std::monostate, Texture, ScalarTexture, std::string>;
    struct Result {
        Value value;
        std::string fault;   ///< which numbers were taken for others; empty: none, or told of
        bool isUnit = false; ///< a use of Numbers::unit has been looked at
    };
    using Read = std::function<Value(const DecodedImage&)>;

    /// What tells images apart, and what is read of one: a path, a label where there is none, or
    /// of one that is embedded its size and a hash of its bytes, as several may be the same.
    using Key = std::pair<std::string, std::string>;
    struct Announced {
        Key key;
        ImageFile image;
        Read read;
    };

    static Key keyOf(const Source& source, const std::string& what);
    std::vector<Result> read(const ImageFile& image, std::span<const Read> reads) const;
    void warn(WarningKind kind, const Source& source, const std::string& what);
    void noteNumbers(const Source& source, Result& result, Numbers numbers);
    const Result& load(const Key& key, const Source& source, const Read& read, Numbers numbers);
    template <typename T>
    uint32_t place(const Source& source, const std::string& what, const TextureSampling& sampling,
                   std::vector<T>& textures, const Read& read, Numbers numbers);

    Scene& scene_;
    LoadReport& report_;
    MemoryBudget budget_;
    std::map<Key, Result> loaded_;
    std::map<std::pair<Key, std::string>, uint32_t> places_; ///< also by sampling
    bool announcing_ = false;
    std::vector<Announced> announced_;
    std::map<Key, Result> ahead_;
};

} // namespace dirt
