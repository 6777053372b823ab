#include "core/io/mtl_map_options.h"

#include "core/io/number.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <iterator>

namespace dirt {

/// An option, how many values it takes at least and at most, and what they do. Optional values are
/// numbers, which tells them from the file name.
struct MapOptionReader::Option {
    std::string_view name;
    int least, most;
    void (MapOptionReader::*take)(std::string_view name,
                                  const std::vector<std::string_view>& values);
};

const MapOptionReader::Option MapOptionReader::kOptions[] = {
    {"-s", 1, 3, &MapOptionReader::scale},
    {"-o", 1, 3, &MapOptionReader::offset},
    {"-clamp", 1, 1, &MapOptionReader::clamp},
    {"-bm", 1, 1, &MapOptionReader::strength},
    {"-imfchan", 1, 1, &MapOptionReader::channel},
    {"-colorspace", 1, 1, &MapOptionReader::encoding},
    {"-blendu", 1, 1, &MapOptionReader::ignore},
    {"-blendv", 1, 1, &MapOptionReader::ignore},
    {"-boost", 1, 1, &MapOptionReader::ignore},
    {"-cc", 1, 1, &MapOptionReader::ignore},
    {"-mm", 1, 2, &MapOptionReader::ignore},
    {"-t", 1, 3, &MapOptionReader::ignore},
    {"-texres", 1, 1, &MapOptionReader::ignore},
    {"-type", 1, 1, &MapOptionReader::ignore},
};

void MapOptionReader::read() {
    for (;;) {
        std::string_view rest = rest_;
        const std::string_view word = takeWord(rest);
        const auto* const option =
            std::find_if(std::begin(kOptions), std::end(kOptions),
                         [&](const Option& o) { return equalButForCase(o.name, word); });
        if (option == std::end(kOptions)) break;
        rest_ = rest;
        (this->*option->take)(option->name, takeValues(*option));
    }
    std::string_view name = trimmed(rest_);
    if (name.size() >= 2 && name.front() == '"' && name.back() == '"')
        name = trimmed(name.substr(1, name.size() - 2));
    map_.file = name;
}

std::vector<std::string_view> MapOptionReader::takeValues(const Option& option) {
    std::vector<std::string_view> values;
    for (int i = 0; i < option.most; ++i) {
        std::string_view after = rest_;
        const std::string_view value = takeWord(after);
        if (i >= option.least && !parseNumber(value)) break;
        values.push_back(value);
        rest_ = after;
    }
    return values;
}

/// The first two of \p values, where they are given; a texture has no depth for the third.
void MapOptionReader::plane(std::string_view name, const std::vector<std::string_view>& values,
                            glm::vec2& out) {
    glm::vec2 read = out;
    for (size_t i = 0; i < values.size() && i < 2; ++i) {
        const auto value = parseNumber(values[i]);
        if (!value || !fitsFloat(*value)) {
            malformed_.push_back("number " + inQuotes(values[i]) + " of " + std::string(name));
            return;
        }
        read[(int) i] = (float) *value;
    }
    out = read;
}

void MapOptionReader::scale(std::string_view name, const std::vector<std::string_view>& values) {
    plane(name, values, map_.scale);
}

void MapOptionReader::offset(std::string_view name, const std::vector<std::string_view>& values) {
    plane(name, values, map_.offset);
}

void MapOptionReader::clamp(std::string_view name, const std::vector<std::string_view>& values) {
    if (equalButForCase(values[0], "on"))
        map_.clamps = true;
    else if (equalButForCase(values[0], "off"))
        map_.clamps = false;
    else
        malformed_.push_back(inQuotes(values[0]) + " of " + std::string(name));
}

/// -bm may turn heights over.
void MapOptionReader::strength(std::string_view name, const std::vector<std::string_view>& values) {
    if (use_ != MtlUse::bump && use_ != MtlUse::normal) return ignore(name, values);
    const auto value = parseNumber(values[0]);
    if (!value || !fitsFloat(*value))
        malformed_.push_back("number " + inQuotes(values[0]) + " of " + std::string(name));
    else
        map_.strength = (float) *value;
}

void MapOptionReader::channel(std::string_view name, const std::vector<std::string_view>& values) {
    if (isColour() || use_ == MtlUse::normal) return ignore(name, values);
    constexpr std::string_view kChannels = "rgbml";
    const std::string_view value = values[0];
    const char letter = value.size() == 1 ? (char) (value[0] | 0x20) : ' ';
    if (kChannels.find(letter) == kChannels.npos)
        ignored_.push_back(std::string(name) + " " + std::string(value));
    else
        map_.channel = letter;
}

/// Data is linear, whatever it says.
void MapOptionReader::encoding(std::string_view name, const std::vector<std::string_view>& values) {
    const bool linear = equalButForCase(values[0], "linear");
    if (linear || (isColour() && equalButForCase(values[0], "srgb")))
        map_.isLinear = linear;
    else
        ignored_.push_back(std::string(name) + " " + std::string(values[0]));
}

bool MapOptionReader::isColour() const {
    return use_ == MtlUse::diffuse || use_ == MtlUse::emission;
}

void MapOptionReader::ignore(std::string_view name, const std::vector<std::string_view>&) {
    ignored_.emplace_back(name);
}

} // namespace dirt
