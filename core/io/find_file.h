#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace dirt {

/// While one lives, findFile reads each folder once, on all threads: for a load that may look for
/// thousands of files that are not there.
class FolderListings {
public:
    FolderListings();
    ~FolderListings(); ///< what lived before it serves again
    FolderListings(const FolderListings&) = delete;
    FolderListings& operator=(const FolderListings&) = delete;

    /// The name in \p folder, the first in byte order, that is \p lowerCase but for case.
    std::optional<std::string> find(const std::filesystem::path& folder,
                                    const std::string& lowerCase);

private:
    /// Names by their lower case.
    using Listing = std::unordered_map<std::string, std::string>;

    FolderListings* const outer_;
    std::mutex mutex_;
    std::map<std::string, Listing> listings_;
};

/// The regular file that \p name, as written in a scene or material file, means below \p folder:
/// backslashes separate folders too, and where a part of the name is not there, one that differs
/// in the case of ASCII letters is taken (the first in byte order). Nothing where there is none, or
/// a folder. Throws InputError where it is a special file. The name is noted as one of an input.
std::optional<std::filesystem::path> findFile(const std::filesystem::path& folder,
                                              std::string_view name);

/// Notes the file that \p name means there as an input, whether it is read or not.
void noteNamedFile(const std::filesystem::path& folder, std::string_view name);

} // namespace dirt
