#include "core/io/png_file.h"

#include "core/io/load_report.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace dirt {

namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::array<std::string_view, 5> kEssential{"IHDR", "PLTE", "tRNS", "IDAT", "IEND"};
/// Length, name, data, checksum.
constexpr size_t kChunkOverhead = 12;

uint32_t bigEndian(std::string_view bytes) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | (unsigned char) bytes[i];
    return value;
}

constexpr std::array<uint32_t, 256> makeTable() {
    std::array<uint32_t, 256> table{};
    for (uint32_t i = 0; i < 256; ++i) {
        table[i] = i;
        for (int bit = 0; bit < 8; ++bit)
            table[i] = table[i] & 1 ? 0xedb88320u ^ table[i] >> 1 : table[i] >> 1;
    }
    return table;
}

/// CRC-32 of ISO 3309, as PNG has it.
uint32_t checksum(std::string_view bytes) {
    static constexpr auto kTable = makeTable();
    uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) crc = kTable[(crc ^ (unsigned char) byte) & 0xff] ^ crc >> 8;
    return ~crc;
}

} // namespace

bool isPng(const std::string& bytes) {
    return bytes.rfind(kSignature.substr(0, 4), 0) == 0;
}

std::string essentialPng(const std::string& bytes, const std::filesystem::path& file) {
    if (bytes.rfind(kSignature, 0) != 0)
        failAt(file, 0, "damaged image: the first bytes are wrong");
    std::string essential(kSignature);
    std::string_view rest = std::string_view(bytes).substr(kSignature.size());
    for (std::string_view name; name != "IEND";) {
        if (rest.size() < kChunkOverhead || rest.size() - kChunkOverhead < bigEndian(rest))
            failAt(file, 0, "damaged image: the file ends early");
        const std::string_view chunk = rest.substr(0, kChunkOverhead + bigEndian(rest));
        rest.remove_prefix(chunk.size());
        name = chunk.substr(4, 4);
        if (checksum(chunk.substr(4, chunk.size() - 8)) !=
            bigEndian(chunk.substr(chunk.size() - 4)))
            failAt(file, 0, "damaged image: a checksum is wrong");
        if (std::find(kEssential.begin(), kEssential.end(), name) != kEssential.end())
            essential += chunk;
    }
    return essential;
}

} // namespace dirt
