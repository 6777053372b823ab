#pragma once

#include "core/io/memory_budget.h"
#include "core/scene/scalar_texture.h"
#include "core/scene/texture.h"

#include <concepts>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <glm/vec3.hpp>

namespace dirt {

/// An image: a file, or the bytes of one with a name that stands for the file's.
struct ImageFile {
    template <typename Path>
    requires std::convertible_to<Path, std::filesystem::path> ImageFile(const Path& file)
        : name(file) {}
    ImageFile(std::filesystem::path standIn, std::string fileBytes)
        : ImageFile(std::move(standIn), std::make_shared<std::string>(std::move(fileBytes))) {}
    ImageFile(std::filesystem::path standIn, std::shared_ptr<const std::string> fileBytes)
        : name(std::move(standIn)), bytes(std::move(fileBytes)) {}

    std::filesystem::path name;
    std::shared_ptr<const std::string> bytes; ///< null: those of the file
};

/// An image that is decoded once, whatever is then read of it. Its constructor and what reads it
/// throw InputError ("file: what is wrong") where the file is damaged, absurdly large or no image;
/// MemoryError where \p budget has not got what it claims. What is made of it is spent for good.
class DecodedImage {
public:
    explicit DecodedImage(const ImageFile& file, const MemoryBudget& budget = {});
    ~DecodedImage();

    /// Which numbers of what was read last had to be taken for others; empty: none. Once.
    std::string takeFault() const;

    struct Pixels;
    Pixels& pixels() const { return *pixels_; }

private:
    std::unique_ptr<Pixels> pixels_;
};

/// An image as a colour texture: integer formats as sRGB with 8 bits, float formats as they are.
/// One channel is grey; alpha is dropped and does not scale the colour. A float is taken for the
/// nearest from 0 to kMostRadiance, a NaN for 0 (takeFault).
Texture readTexture(const DecodedImage& image);

/// Three channels of an image as data: 8-bit formats as linear bytes, others as floats, integers
/// from 0 to 1. One channel is all three. Floats may be negative; an infinite one is taken for the
/// nearest that is finite, a NaN for 0 (takeFault).
Texture readDataTexture(const DecodedImage& image);

/// What of an image makes data of one channel. In an image of grey, red, green and blue are its
/// grey; in one without alpha, alpha is 1. Luminance is Rec.709's and mean a third of the sum, of
/// the channels as they are.
enum class ImageChannel { red, green, blue, alpha, luminance, mean };

/// One channel of an image as data: 8-bit formats as 0 to 1 (luminance and mean as floats), others
/// as floats. What is not finite is taken for what readDataTexture takes it for.
ScalarTexture readScalarTexture(const DecodedImage& image,
                                ImageChannel channel = ImageChannel::red);

/// Whether an image that stands for a relief holds normals (2 c - 1 of its channels c) and not
/// heights: they point out of the surface on the whole, and are nearer to unit length than to grey,
/// in the sum of squares over all texels.
bool isNormalMap(const DecodedImage& image);

/// An image's alpha, if it has any that is not the same everywhere.
std::optional<ScalarTexture> readAlpha(const DecodedImage& image);

/// Whether \p alpha cuts out a part of the image and leaves one: texels below \p limit and others.
bool cutsOut(const ScalarTexture& alpha, float limit = 0.5f);

} // namespace dirt
