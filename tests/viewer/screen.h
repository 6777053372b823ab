#pragma once

#include "core/preview/picture.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <string>

namespace dirt::test {

/// The screen of an Xvfb that was started with -fbdir \p folder: an XWD file of 32-bit pixels.
inline Picture readScreen(const std::filesystem::path& folder) {
    const std::string file = readFile(folder / "Xvfb_screen0");
    const auto word = [&](size_t i) { // of the header: 32 bits, the highest first
        uint32_t value = 0;
        for (size_t b = 0; b < 4; ++b) value = value << 8 | (uint8_t) file.at(4 * i + b);
        return (size_t) value;
    };
    const size_t header = word(0), stride = word(12), colours = word(19);
    Picture screen((int) word(4), (int) word(5));
    const size_t pixels = header + 12 * colours;
    for (int y = 0; y < screen.height; ++y)
        for (int x = 0; x < screen.width; ++x) {
            const size_t at = pixels + (size_t) y * stride + 4 * (size_t) x; // B, G, R, nothing
            screen.set(
                x, y,
                {(uint8_t) file.at(at + 2), (uint8_t) file.at(at + 1), (uint8_t) file.at(at)});
        }
    return screen;
}

} // namespace dirt::test
