#include "core/io/find_file.h"

#include "core/io/input_files.h"
#include "core/io/opened_file.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <system_error>
#include <utility>

#include <dirent.h>

namespace dirt {

namespace {

namespace fs = std::filesystem;

std::atomic<FolderListings*> listing{nullptr};

/// Calls \p visit(name, name in lower case) for all that is in \p folder. (The standard library's
/// iterator ends the process where memory is out.)
template <typename Visit>
void forEntries(const fs::path& folder, const Visit& visit) {
    const std::unique_ptr<DIR, int (*)(DIR*)> open(opendir(folder.c_str()), closedir);
    if (!open) return;
    while (const dirent* const entry = readdir(open.get())) {
        const std::string name = entry->d_name;
        if (name != "." && name != "..") visit(name, lowerCase(name));
    }
}

/// The entry of \p folder that equals \p part but for case.
std::optional<fs::path> findEntry(const fs::path& folder, const fs::path& part) {
    const std::string wanted = lowerCase(part.string());
    std::optional<std::string> best;
    if (FolderListings* listings = listing)
        best = listings->find(folder, wanted);
    else
        forEntries(folder, [&](const std::string& name, const std::string& lower) {
            if (lower == wanted && (!best || name < *best)) best = name;
        });
    if (!best) return std::nullopt;
    return folder / *best;
}

fs::path pathOf(std::string_view name) {
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    return fs::path(slashed).lexically_normal();
}

} // namespace

FolderListings::FolderListings() : outer_(listing.exchange(this)) {}

FolderListings::~FolderListings() {
    listing = outer_;
}

std::optional<std::string> FolderListings::find(const fs::path& folder,
                                                const std::string& lowerCase) {
    const std::lock_guard lock(mutex_);
    auto known = listings_.find(folder.string());
    if (known == listings_.end()) {
        Listing names;
        forEntries(folder, [&](const std::string& name, const std::string& lower) {
            std::string& first = names[lower];
            if (first.empty() || name < first) first = name;
        });
        known = listings_.emplace(folder.string(), std::move(names)).first;
    }
    const Listing& names = known->second;
    const auto found = names.find(lowerCase);
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

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
    refuseSpecialFile(path);
    if (!fs::is_regular_file(path, error)) return std::nullopt;
    return path.lexically_normal();
}

} // namespace dirt
