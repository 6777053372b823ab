#pragma once

#include "core/io/exr_parts.h"

#include <span>
#include <string>
#include <vector>

namespace dirt {

/// What a channel of a dumped buffer holds.
struct ChannelInfo {
    ExrChannel channel;
    /// Its name in EXR files, LAYER.LETTER: compositors keep no other. The layer of a single number
    /// is its own name, the letter Z for a depth, X for all else. Deep files keep plain names.
    std::string inFile;
    size_t offset = 0; ///< of its four bytes in a record
    std::string space; ///< the space it lives in; empty where it has none
    std::string unit;  ///< empty where it has none
    std::string meaning;
};

/// The channels of each record, in the order of its bytes.
std::vector<ChannelInfo> triangleChannels();
std::vector<ChannelInfo> depthChannels();
std::vector<ChannelInfo> shadowMapChannels();
std::vector<ChannelInfo> rayChannels();
std::vector<ChannelInfo> shadowRayChannels(); ///< of ShadowRecord
std::vector<ChannelInfo> hitChannels();
std::vector<ChannelInfo> surfacePointChannels();
/// A single word named \p name.
std::vector<ChannelInfo> flagChannels(const std::string& name, const std::string& meaning);
std::vector<ChannelInfo> radianceChannels();
/// A sample of the deep id buffer: five words.
std::vector<ChannelInfo> entryChannels();

/// \p channels with "prefix." before each name.
std::vector<ChannelInfo> withPrefix(const std::string& prefix, std::vector<ChannelInfo> channels);

} // namespace dirt
