#include "core/io/find_file.h"

#include "core/io/input_files.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace dirt {

namespace {

namespace fs = std::filesystem;

std::string lowerCase(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = (char) (c - 'A' + 'a');
    return text;
}

/// The entry of \p folder that equals \p part but for case.
std::optional<fs::path> findEntry(const fs::path& folder, const fs::path& part) {
    const std::string wanted = lowerCase(part.string());
    std::optional<std::string> best;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        std::string found = entry->path().filename().string();
        if (lowerCase(found) == wanted && (!best || found < *best)) best = std::move(found);
    }
    if (!best) return std::nullopt;
    return folder / *best;
}

fs::path pathOf(std::string_view name) {
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    return fs::path(slashed).lexically_normal();
}

} // namespace

void noteNamedFile(const fs::path& folder, std::string_view name) {
    noteInput(folder / pathOf(name));
}

std::optional<fs::path> findFile(const fs::path& folder, std::string_view name) {
    const fs::path wanted = pathOf(name);
    if (wanted.empty()) return std::nullopt;
    noteInput(folder / wanted);

    std::error_code error;
    fs::path path = wanted.is_absolute() ? wanted.root_path() : folder;
    for (const fs::path& part : wanted.relative_path()) {
        if (part.empty()) return std::nullopt; // the name ends in a slash: a folder
        if (fs::exists(path / part, error)) {
            path /= part;
            continue;
        }
        const auto entry = findEntry(path.empty() ? fs::path(".") : path, part);
        if (!entry) return std::nullopt;
        path = *entry;
    }
    if (!fs::is_regular_file(path, error)) return std::nullopt;
    return path.lexically_normal();
}

} // namespace dirt
