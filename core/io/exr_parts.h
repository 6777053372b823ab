#pragma once

#include "core/io/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dirt {

/// A named channel of 32-bit values.
struct ExrChannel {
    enum class Type { uint32, float32 };
    std::string name;
    Type type = Type::float32;
};

/// One part of a multi-part EXR file: an image with any channels.
struct ExrPart {
    std::string name; ///< may be empty where there is no other
    int width = 0, height = 0;
    std::vector<ExrChannel> channels;
    std::vector<uint32_t> values; ///< bits, row-major, the channels of a pixel together
};

/// One part of a deep EXR file: any number of samples in each pixel.
struct DeepExrPart {
    std::string name;
    int width = 0, height = 0;
    std::vector<ExrChannel> channels;
    std::vector<uint32_t> counts; ///< samples of each pixel, row-major
    std::vector<uint32_t> values; ///< bits, sample after sample, its channels together
};

/// Writes the parts in their order, zip-compressed. The file appears whole or not at all, and equal
/// input gives equal bytes. Throws InputError where it cannot be written.
void writeExr(const std::string& path, std::span<const ExrPart> parts,
              const ImageMetadata& metadata);
void writeExr(const std::string& path, std::span<const DeepExrPart> parts,
              const ImageMetadata& metadata);

} // namespace dirt
