#pragma once

#include "app/cli/options.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// What `dirt dump` was asked for.
struct DumpOptions {
    CommonOptions common;
    std::vector<std::string> buffers;        ///< empty: all
    std::string output;                      ///< a folder, or of a pixel a file
    std::optional<std::array<int, 2>> pixel; ///< none: all
    std::optional<int> event;                ///< none: all
    uint32_t sample = 0;
    bool json = false;
};

} // namespace dirt
