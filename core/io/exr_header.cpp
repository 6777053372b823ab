#include "core/io/exr_header.h"

#include "core/io/bytes.h"

#include <bit>
#include <cstdint>
#include <span>

namespace dirt {

namespace {

/// Names end within 255 bytes, those of old files within 31.
constexpr size_t kLongestName = 255;
/// DWAB's chunks, the tallest.
constexpr uint64_t kMostRowsPerChunk = 256;
constexpr uint64_t kBytesPerOffset = 8;
/// Deflate, by which a manifest of ids is compressed, makes at most 258 bytes of two bits.
constexpr uint64_t kDeflated = 1032;

static_assert(std::endian::native == std::endian::little); // as the format is

struct HeaderFault {
    std::string text;
};

class Bytes {
public:
    explicit Bytes(std::string_view rest) : rest_(rest) {}

    size_t left() const { return rest_.size(); }
    bool atZero() const { return !rest_.empty() && rest_.front() == '\0'; }

    std::string_view take(uint64_t count) {
        if (count > rest_.size()) throw HeaderFault{"ends within its header"};
        const std::string_view taken = rest_.substr(0, (size_t) count);
        rest_.remove_prefix((size_t) count);
        return taken;
    }
    template <typename Number>
    Number number() {
        return valueAt<Number>(std::as_bytes(std::span(take(sizeof(Number)))), 0);
    }
    std::string_view name() {
        const size_t end = rest_.substr(0, kLongestName + 1).find('\0');
        if (end == std::string_view::npos)
            throw HeaderFault{"has a name without end in its header"};
        return take(end + 1).substr(0, end);
    }

private:
    std::string_view rest_;
};

/// What one part's attributes say of its chunks.
struct Chunks {
    uint64_t width = 0, height = 0;
    uint64_t tileWidth = 0, tileHeight = 0; ///< 0: rows

    /// The least number there may be.
    uint64_t count() const {
        const auto over = [](uint64_t size, uint64_t step) { return (size + step - 1) / step; };
        if (tileWidth > 0 && tileHeight > 0)
            return over(width, tileWidth) * over(height, tileHeight);
        return over(height, kMostRowsPerChunk);
    }
};

uint64_t extentOf(int32_t low, int32_t high) {
    return high < low ? 0 : (uint64_t) ((int64_t) high - low + 1);
}

void checkValue(std::string_view name, std::string_view type, Bytes value, Chunks& chunks) {
    const size_t size = value.left();
    const auto fault = [&](const char* what) {
        return HeaderFault{"has an attribute whose " + std::string(what) + " do not fit into it"};
    };
    if (type == "stringvector") {
        while (value.left() > 0) {
            const auto length = value.number<uint32_t>();
            if (length > value.left()) throw fault("texts");
            value.take(length);
        }
    } else if (type == "preview") {
        const uint64_t width = value.number<uint32_t>(), height = value.number<uint32_t>();
        if (width * height > size / 4) throw fault("texels");
    } else if (type == "idmanifest") {
        value.number<uint32_t>(); // its version
        if (value.number<uint64_t>() > kDeflated * size) throw fault("names");
    } else if (name == "dataWindow" && type == "box2i") {
        const auto left = value.number<int32_t>(), top = value.number<int32_t>();
        const auto right = value.number<int32_t>(), bottom = value.number<int32_t>();
        chunks.width = extentOf(left, right), chunks.height = extentOf(top, bottom);
    } else if (name == "tiles" && type == "tiledesc") {
        chunks.tileWidth = value.number<uint32_t>(), chunks.tileHeight = value.number<uint32_t>();
    }
}

/// The attributes of one part.
void checkPart(Bytes& bytes) {
    Chunks chunks;
    while (!bytes.atZero()) {
        const std::string_view name = bytes.name(), type = bytes.name();
        const auto size = bytes.number<uint32_t>();
        if (size > bytes.left()) throw HeaderFault{"ends within an attribute of its header"};
        checkValue(name, type, Bytes(bytes.take(size)), chunks);
    }
    bytes.take(1);
    if (chunks.count() > bytes.left() / kBytesPerOffset)
        throw HeaderFault{"is shorter than the table of the chunks that its header claims"};
}

} // namespace

std::optional<std::string> exrHeaderFault(std::string_view file) {
    constexpr uint32_t kSeveralParts = 0x1000; // a bit of the version
    try {
        Bytes bytes(file);
        bytes.number<uint32_t>(); // its mark
        const bool several = (bytes.number<uint32_t>() & kSeveralParts) != 0;
        do checkPart(bytes);
        while (several && !bytes.atZero());
        return std::nullopt;
    } catch (const HeaderFault& fault) {
        return fault.text;
    }
}

} // namespace dirt
