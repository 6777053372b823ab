#include "core/io/mtl.h"

#include "core/io/number.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dirt {

namespace {

/// An option of a texture statement and how many values it takes at least and at most. Optional
/// values are numbers, which tells them from the file name.
struct MapOption {
    std::string_view name;
    int least, most;
};
constexpr std::array<MapOption, 13> kMapOptions{{{"-blendu", 1, 1},
                                                 {"-blendv", 1, 1},
                                                 {"-bm", 1, 1},
                                                 {"-boost", 1, 1},
                                                 {"-cc", 1, 1},
                                                 {"-clamp", 1, 1},
                                                 {"-imfchan", 1, 1},
                                                 {"-mm", 2, 2},
                                                 {"-o", 1, 3},
                                                 {"-s", 1, 3},
                                                 {"-t", 1, 3},
                                                 {"-texres", 1, 1},
                                                 {"-type", 1, 1}}};

class MtlReader {
public:
    MtlReader(const std::filesystem::path& file, LoadReport& report)
        : file_(file), report_(report) {}

    std::vector<MtlMaterial> read() {
        const std::string text = readTextFile(file_);
        LineReader lines(text);
        while (lines.next()) {
            line_ = lines.number();
            std::string_view arguments = lines.line();
            const std::string_view key = takeWord(arguments);
            if (!key.empty() && key[0] != '#') statement(key, trimmed(arguments));
        }
        return std::move(materials_);
    }

private:
    void statement(std::string_view key, std::string_view arguments) {
        if (key == "newmtl") {
            materials_.emplace_back();
            materials_.back().name = arguments;
            materials_.back().material.name = printable(arguments);
            return;
        }
        if (materials_.empty() || (!value(key, arguments) && !map(key, arguments)))
            report_.ignore("MTL " + std::string(key));
    }

    /// False if the key is none of a value.
    bool value(std::string_view key, std::string_view arguments) {
        Material& material = materials_.back().material;
        if (key == "Kd")
            material.diffuse = colour(key, arguments);
        else if (key == "Ke")
            material.emission = colour(key, arguments);
        else if (key == "Ks")
            material.reflectance = std::min(colour(key, arguments).x, 1.0f);
        else if (key == "Ns")
            material.roughness = 1.0f - std::min(number(key, arguments), 127.0f) / 127.0f;
        else if (key == "d")
            material.opacity = std::min(number(key, arguments), 1.0f);
        else if (key == "metallic")
            material.metallic = std::min(number(key, arguments), 1.0f);
        else
            return false;
        return true;
    }

    /// False if the key is none of a texture.
    bool map(std::string_view key, std::string_view arguments) {
        MtlMaterial& target = materials_.back();
        MtlMaterial::Map* const map = key == "map_Kd"   ? &target.diffuse
                                      : key == "map_Ke" ? &target.emission
                                      : key == "map_Ks" ? &target.reflectance
                                      : key == "map_d"  ? &target.opacity
                                      : key == "map_bump" || key == "map_Bump" || key == "bump"
                                          ? &target.bump
                                          : nullptr;
        if (!map) return false;
        *map = {fileName(key, arguments), line_};
        return true;
    }

    /// A number at the arguments' begin.
    float number(std::string_view key, std::string_view arguments) const {
        std::string_view word = takeWord(arguments);
        if (word == "-halo") word = takeWord(arguments);
        const auto value = parseNumber(word);
        if (!value)
            failAt(file_, line_, "malformed number " + inQuotes(word) + " in " + std::string(key));
        if (!fitsFloat(*value) || *value < 0.0)
            failAt(file_, line_, std::string(key) + " must be finite and not negative");
        return (float) *value;
    }

    /// Three numbers, or one for all three.
    glm::vec3 colour(std::string_view key, std::string_view arguments) const {
        std::array<double, 3> values{};
        int count = 0;
        for (std::string_view word = takeWord(arguments);
             !word.empty() && word[0] != '#' && count < 3; word = takeWord(arguments)) {
            const auto value = parseNumber(word);
            if (!value)
                failAt(file_, line_,
                       "malformed number " + inQuotes(word) + " in " + std::string(key));
            if (!fitsFloat(*value) || *value < 0.0)
                failAt(file_, line_, std::string(key) + " must be finite and not negative");
            values[(size_t) count++] = *value;
        }
        if (count != 1 && count != 3)
            failAt(file_, line_, std::string(key) + " needs three numbers");
        if (count == 1) values.fill(values[0]);
        return {(float) values[0], (float) values[1], (float) values[2]};
    }

    /// The rest of a texture statement after its options. It may hold blanks.
    std::string fileName(std::string_view key, std::string_view arguments) {
        for (;;) {
            std::string_view rest = arguments;
            const std::string_view word = takeWord(rest);
            const auto option = std::find_if(kMapOptions.begin(), kMapOptions.end(),
                                             [&](const MapOption& o) { return o.name == word; });
            if (option == kMapOptions.end()) return std::string(trimmed(arguments));
            if (word == "-bm" && key.ends_with("ump"))
                bumpScale(key, rest);
            else
                report_.ignore("MTL " + std::string(key) + " " + std::string(word));
            for (int i = 0; i < option->most; ++i) {
                std::string_view after = rest;
                const std::string_view value = takeWord(after);
                if (i >= option->least && !parseNumber(value)) break;
                rest = after;
            }
            arguments = rest;
        }
    }

    /// -bm may turn heights over.
    void bumpScale(std::string_view key, std::string_view arguments) {
        const std::string_view word = takeWord(arguments);
        const auto value = parseNumber(word);
        if (!value || !fitsFloat(*value))
            failAt(file_, line_,
                   "malformed number " + inQuotes(word) + " in " + std::string(key) + " -bm");
        materials_.back().material.bumpScale = (float) *value;
    }

    const std::filesystem::path& file_;
    LoadReport& report_;
    std::vector<MtlMaterial> materials_;
    size_t line_ = 0;
};

} // namespace

std::vector<MtlMaterial> readMtl(const std::filesystem::path& file, LoadReport& report) {
    return MtlReader(file, report).read();
}

} // namespace dirt
