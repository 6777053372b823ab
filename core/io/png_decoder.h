#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace dirt {

/// What is wrong with a PNG file; it has no name here.
struct PngError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct PngHeader {
    int width, height;
    int channels; ///< grey, grey and alpha, three colours, and alpha
    int bits;     ///< 8 or 16
};

/// A PNG file in memory, by libpng, which prints nothing. Palettes become colours, fewer bits
/// eight, and a transparent colour becomes an alpha channel.
class PngDecoder {
public:
    /// \p bytes have to outlive this. Throws PngError.
    explicit PngDecoder(const std::string& bytes);
    ~PngDecoder();
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;

    const PngHeader& header() const;

    /// Keys and texts that stand before the texels.
    std::vector<std::pair<std::string, std::string>> texts() const;

    /// All samples, the first row on top; 16 bits as this machine has them. Once only. Throws
    /// PngError.
    std::vector<uint8_t> decode();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace dirt
