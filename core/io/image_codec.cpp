#include "core/io/image_codec.h"

#include <array>

namespace dirt {

namespace {

struct Marked {
    std::string_view mark;
    ImageCodec codec;
};

/// Deflate makes at most 258 bytes of two bits: 1032 to 1. A byte may hold eight texels of a
/// palette, of three channels each.
constexpr uint64_t kDeflated = 1032 * 8 * 3;

/// LZW makes at most 3837 bytes of a code of 12 bits, and CCITT a row of one.
constexpr uint64_t kTiff = 3 * 8 * 3837;

/// Blocks that are all alike take next to nothing where a format predicts them (WebP), or codes how
/// often a code repeats (EXR's PIZ, old runs of HDR): no format bounds them. A file of 10 KB may
/// claim 16384 x 16384 texels of three channels.
constexpr uint64_t kPredicted = uint64_t(1) << 17;

/// JPEG: a bit or more for each block of 8 x 8 samples, of which one row and column in two may be
/// left out.
constexpr uint64_t kJpeg = 8 * 64 * 4;

/// TGA: 128 texels of four channels in a run of two bytes; BMP: 255 of three; DDS: 16 of four in
/// eight bytes; PNM and PFM: eight of one channel, read as three.
constexpr uint64_t kRuns = 512;

constexpr std::array<Marked, 17> kMarks{{
    {"\x89PNG", {"png", kDeflated}},
    {"\xff\xd8\xff", {"jpeg", kJpeg}},
    {"\x76\x2f\x31\x01", {"openexr", kPredicted}},
    {"#?RADIANCE", {"hdr", kPredicted}},
    {"#?RGBE", {"hdr", kPredicted}},
    {{"II*\0", 4}, {"tiff", kTiff}},
    {{"MM\0*", 4}, {"tiff", kTiff}},
    {"BM", {"bmp", kRuns}},
    {"DDS ", {"dds", kRuns}},
    {"P1", {"pnm", kRuns}},
    {"P2", {"pnm", kRuns}},
    {"P3", {"pnm", kRuns}},
    {"P4", {"pnm", kRuns}},
    {"P5", {"pnm", kRuns}},
    {"P6", {"pnm", kRuns}},
    {"PF", {"pnm", kRuns}},
    {"Pf", {"pnm", kRuns}},
}};

constexpr ImageCodec kWebp{"webp", kPredicted};
constexpr ImageCodec kTarga{"targa", kRuns};

/// Truevision's TGA 2.0, the fields of the header that take few values.
bool isTarga(std::string_view bytes) {
    if (bytes.size() < 18) return false;
    const auto at = [&](size_t i) { return (unsigned char) bytes[i]; };
    const int palette = at(1), type = at(2) & ~8, bits = at(16);
    return palette <= 1 && at(2) <= 11 && type >= 1 && type <= 3 && (type != 1 || palette == 1) &&
           (bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32);
}

/// DXT2 and DXT4, whose colours are multiplied by alpha: OpenImageIO 2.4 divides by it, and ends
/// the process where it is zero.
bool isPremultipliedDds(std::string_view bytes) {
    constexpr size_t kFourCc = 84; // bytes before it
    if (!bytes.starts_with("DDS ") || bytes.size() < kFourCc + 4) return false;
    const std::string_view fourCc = bytes.substr(kFourCc, 4);
    return fourCc == "DXT2" || fourCc == "DXT4";
}

} // namespace

const char* const kCodecNames =
    "PNG, JPEG, OpenEXR, Radiance HDR, TIFF, BMP, TGA, WebP, DDS, PNM and PFM";

const ImageCodec* codecOf(std::string_view bytes) {
    if (isPremultipliedDds(bytes)) return nullptr;
    for (const Marked& marked : kMarks)
        if (bytes.starts_with(marked.mark)) return &marked.codec;
    if (bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP")
        return &kWebp;
    return isTarga(bytes) ? &kTarga : nullptr;
}

} // namespace dirt
