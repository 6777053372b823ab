#pragma once

#include "core/io/mtl.h"

#include <string>
#include <string_view>
#include <vector>

namespace dirt {

/// Reads what follows the key of a texture statement: options, then a file name, which may hold
/// blanks.
class MapOptionReader {
public:
    /// \p map, which gets what is read, must outlive the reader.
    MapOptionReader(MtlUse use, std::string_view arguments, MtlMap& map)
        : use_(use), rest_(arguments), map_(map) {}

    void read();

    /// Options without effect, as "-blendu".
    const std::vector<std::string>& ignored() const { return ignored_; }
    /// Options whose values cannot be read, as "number 'x' in -bm".
    const std::vector<std::string>& malformed() const { return malformed_; }

private:
    struct Option;
    static const Option kOptions[];

    void scale(std::string_view name, const std::vector<std::string_view>& values);
    void offset(std::string_view name, const std::vector<std::string_view>& values);
    void clamp(std::string_view name, const std::vector<std::string_view>& values);
    void strength(std::string_view name, const std::vector<std::string_view>& values);
    void channel(std::string_view name, const std::vector<std::string_view>& values);
    void encoding(std::string_view name, const std::vector<std::string_view>& values);
    void ignore(std::string_view name, const std::vector<std::string_view>& values);

    bool isColour() const;
    void plane(std::string_view name, const std::vector<std::string_view>& values, glm::vec2& out);
    std::vector<std::string_view> takeValues(const Option& option);

    MtlUse use_;
    std::string_view rest_;
    MtlMap& map_;
    std::vector<std::string> ignored_, malformed_;
};

} // namespace dirt
