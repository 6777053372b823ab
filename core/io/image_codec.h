#pragma once

#include <cstdint>
#include <string_view>

namespace dirt {

/// A format that images are read in. Those, and no others of OpenImageIO's, are fuzzed.
struct ImageCodec {
    const char* name; ///< OpenImageIO's
    /// The most samples (channels of texels) that a byte of such a file can stand for: what a
    /// header claims beyond it is not there.
    uint64_t samplesPerByte;
};

/// The format that a file's first bytes are of, whatever its name says; of TGA, which has no such
/// mark, what is a sound header. Null: none that is read.
const ImageCodec* codecOf(std::string_view bytes);

/// All of them, for messages: "PNG, JPEG, …".
extern const char* const kCodecNames;

} // namespace dirt
