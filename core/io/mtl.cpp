#include "core/io/mtl.h"

#include "core/io/find_file.h"
#include "core/io/mtl_map_options.h"
#include "core/io/number.h"
#include "core/io/text_file.h"
#include "shaders/shared/radiance.h"

#include <algorithm>
#include <cfloat>
#include <cstdio>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace dirt {

namespace {

/// Larger components are taken for `most`.
struct ColourKey {
    std::string_view name;
    std::optional<glm::vec3> MtlMaterial::*value;
    float most;
};
const ColourKey kColours[] = {{"Ka", &MtlMaterial::ambient, 1.0f},
                              {"Kd", &MtlMaterial::diffuse, 1.0f},
                              {"Ks", &MtlMaterial::specular, 1.0f},
                              {"Ke", &MtlMaterial::emission, kMostRadiance}};

/// Larger numbers are taken for `most`; that of Ns depends on the convention.
struct NumberKey {
    std::string_view name;
    std::optional<float> MtlMaterial::*value;
    float most;
};
constexpr NumberKey kNumbers[] = {
    {"Ns", &MtlMaterial::exponent, FLT_MAX},  {"d", &MtlMaterial::opacity, 1.0f},
    {"Tr", &MtlMaterial::transparency, 1.0f}, {"metallic", &MtlMaterial::metallic, 1.0f},
    {"Pr", &MtlMaterial::roughness, 1.0f},    {"Pm", &MtlMaterial::metalness, 1.0f}};

struct MapKey {
    std::string_view name;
    MtlUse use;
};
constexpr MapKey kMaps[] = {
    {"map_Kd", MtlUse::diffuse},   {"map_Ke", MtlUse::emission}, {"map_Ks", MtlUse::specular},
    {"map_Ns", MtlUse::exponent},  {"map_d", MtlUse::opacity},   {"map_bump", MtlUse::bump},
    {"bump", MtlUse::bump},        {"norm", MtlUse::normal},     {"map_Kn", MtlUse::normal},
    {"map_Pr", MtlUse::roughness}, {"map_Pm", MtlUse::metalness}};

/// The entry of that name, in any letter case; null where there is none.
template <typename Key, size_t count>
const Key* find(const Key (&keys)[count], std::string_view name) {
    const auto* const found = std::find_if(std::begin(keys), std::end(keys), [&](const Key& key) {
        return equalButForCase(key.name, name);
    });
    return found == std::end(keys) ? nullptr : found;
}

class MtlReader {
public:
    MtlReader(const std::filesystem::path& file, MemoryClaim& memory) : memory_(memory) {
        result_.file = file;
    }

    MtlFile read() {
        const std::string text = readTextFile(result_.file, memory_);
        LineReader lines(text);
        while (lines.next()) {
            line_ = lines.number();
            std::string_view arguments = lines.line();
            const std::string_view key = takeWord(arguments);
            if (!key.empty() && key[0] != '#') statement(key, trimmed(arguments));
        }
        finish();
        result_.faults = faults_.faults();
        return std::move(result_);
    }

private:
    void statement(std::string_view key, std::string_view arguments) {
        if (equalButForCase(key, "newmtl")) {
            // And what the list takes while it grows.
            memory_.take(3 * sizeof(MtlMaterial), result_.file, "the list of materials");
            MtlMaterial& material = result_.materials.emplace_back();
            material.name = arguments;
            material.line = line_;
            if (!names_.insert(material.name).second)
                faults_.add(WarningKind::unusableValue, "newmtl", line_, [&] {
                    return "material " + inQuotes(arguments) +
                           " is defined again; the first definition counts";
                });
            for (std::string& key : std::exchange(before_, {})) ignore(std::move(key));
        } else if (result_.materials.empty()) {
            before(key);
        } else if (const ColourKey* colourKey = find(kColours, key)) {
            colour(*colourKey, arguments);
        } else if (const NumberKey* numberKey = find(kNumbers, key)) {
            number(*numberKey, arguments);
        } else if (equalButForCase(key, "illum")) {
            illumination(arguments);
        } else if (const MapKey* mapKey = find(kMaps, key)) {
            note(arguments);
            map(*mapKey, arguments);
        } else {
            note(arguments);
            ignore(std::string(key));
        }
    }

    /// Whatever a statement may name as a file, behind its options or with blanks in its name.
    void note(std::string_view arguments) {
        noteNamedFile(result_.file.parent_path(), arguments);
        noteNamedFile(result_.file.parent_path(),
                      arguments.substr(arguments.find_last_of(" \t") + 1));
    }

    /// What stands before the first material is told of when there is one: of a file that is none
    /// of MTL no more than the first line is shown.
    void before(std::string_view key) {
        if (before_.empty()) beforeLine_ = line_;
        before_.emplace_back(key);
    }

    void finish() {
        if (result_.materials.empty() && !before_.empty())
            faults_.add(WarningKind::missingMaterialLibrary, "no material", beforeLine_, [this] {
                return "this is no MTL file: no newmtl follows " + inQuotes(before_.front());
            });
    }

    void ignore(std::string what) {
        if (others_.insert(what).second) result_.others.push_back(std::move(what));
    }

    void fault(std::string_view key, const std::string& what) {
        faults_.add(WarningKind::unusableValue, key, line_,
                    [&] { return what + "; " + std::string(key) + " counts as not there"; });
    }

    /// Nothing, and a fault, where \p word is no number from 0 that float32 holds.
    std::optional<float> parse(std::string_view key, std::string_view word) {
        const auto value = parseNumber(word);
        if (!value)
            fault(key, "malformed number " + inQuotes(word) + " in " + std::string(key));
        else if (!fitsFloat(*value) || *value < 0.0)
            fault(key, std::string(key) + " " + printable(word) + " is negative or not finite");
        else
            return (float) *value;
        return std::nullopt;
    }

    /// A number at the arguments' begin.
    void number(const NumberKey& key, std::string_view arguments) {
        std::string_view word = takeWord(arguments);
        if (word == "-halo") word = takeWord(arguments);
        auto value = parse(key.name, word);
        if (!value) return;
        confine(key.name, {&*value, 1}, key.most);
        MtlMaterial& material = result_.materials.back();
        material.*key.value = value;
        if (key.value == &MtlMaterial::opacity || !material.opacity) opacityAt(key);
    }

    void opacityAt(const NumberKey& key) {
        if (key.value == &MtlMaterial::opacity || key.value == &MtlMaterial::transparency)
            result_.materials.back().opacityLine = line_;
    }

    /// Three numbers, or one for all three.
    void colour(const ColourKey& key, std::string_view arguments) {
        std::array<float, 3> values{};
        size_t count = 0;
        for (std::string_view word = takeWord(arguments);
             !word.empty() && word[0] != '#' && count < 3; word = takeWord(arguments)) {
            const auto value = parse(key.name, word);
            if (!value) return;
            values[count++] = *value;
        }
        if (count != 1 && count != 3)
            return fault(key.name, std::string(key.name) + " needs three numbers");
        if (count == 1) values.fill(values[0]);
        confine(key.name, values, key.most);
        result_.materials.back().*key.value = glm::vec3(values[0], values[1], values[2]);
    }

    /// Takes what is above \p most for it, which is a fault.
    void confine(std::string_view key, std::span<float> values, float most) {
        const float largest = *std::max_element(values.begin(), values.end());
        if (largest <= most) return;
        const auto message = [&] {
            char text[96];
            std::snprintf(text, sizeof text, "%s %g is above %g, and taken for it", key.data(),
                          (double) largest, (double) most);
            return std::string(text);
        };
        faults_.add(WarningKind::unusableValue, std::string(key) + " above", line_, message);
        for (float& value : values) value = std::min(value, most);
    }

    /// A whole number; some files write it as 2.0.
    void illumination(std::string_view arguments) {
        const auto value = parse("illum", takeWord(arguments));
        if (value) result_.materials.back().illumination = (int) std::min(*value, 1000.0f);
    }

    void map(const MapKey& key, std::string_view arguments) {
        MtlMap map;
        map.line = line_;
        map.key = key.name;
        MapOptionReader options(key.use, arguments, map);
        options.read();
        for (const std::string& option : options.ignored())
            ignore(std::string(key.name) + " " + option);
        for (const std::string& what : options.malformed())
            faults_.add(WarningKind::unusableValue, std::string(key.name) + what, line_, [&] {
                return "malformed " + what + " in " + std::string(key.name) + ", which is left out";
            });
        if (map.file.empty()) {
            faults_.add(WarningKind::unusableTexture, key.name, line_,
                        [&] { return std::string(key.name) + " names no file"; });
            return;
        }
        MtlMaterial& material = result_.materials.back();
        if (key.use == MtlUse::bump && map.strength) material.bumpScale = map.strength;
        material.maps[(size_t) key.use] = std::move(map);
    }

    MemoryClaim& memory_;
    std::vector<std::string> before_; ///< keys before the first material,
    size_t beforeLine_ = 0;           ///< and the first one's line
    MtlFile result_;
    FaultCounter faults_;
    std::set<std::string> others_; ///< those of result_
    std::set<std::string> names_;  ///< of materials
    size_t line_ = 0;
};

} // namespace

bool MtlFile::saysMetallic() const {
    return std::any_of(materials.begin(), materials.end(),
                       [](const MtlMaterial& material) { return material.metallic.has_value(); });
}

MtlFile readMtl(const std::filesystem::path& file) {
    MemoryClaim unlimited;
    return readMtl(file, unlimited);
}

MtlFile readMtl(const std::filesystem::path& file, MemoryClaim& memory) {
    return MtlReader(file, memory).read();
}

} // namespace dirt
