#pragma once

#include "core/io/json_value.h"
#include "core/io/load_report.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace dirt {

/// What a glTF file has that has no effect, and how often.
class GltfIgnored {
public:
    /// \p what is "node skin" or "material extension FOO".
    void add(const std::string& what, uint64_t times = 1) { counts_[what] += times; }
    /// Each once: "glTF node extension FOO (12)".
    void reportTo(LoadReport& report) const;

private:
    std::map<std::string, uint64_t> counts_;
};

/// Counts every member, extension and vertex attribute in the document that this program does not
/// know, at every level but the asset's. Names, extras, hints (min, max, target) and what lies in
/// unknown members do not count. Of an unknown list of objects each counts.
void countUnknownMembers(const nlohmann::json& document, GltfIgnored& ignored);

/// Whether an extension is honoured, if only in part; such a one may be required.
bool knowsGltfExtension(std::string_view name);

/// Of an extension that is not known: "which is not known here", or what this program lacks.
std::string whyUnknown(std::string_view extension);

/// The first extension of an object that is not known.
std::optional<std::string> unknownExtension(const JsonValue& object);

} // namespace dirt
