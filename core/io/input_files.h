#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace dirt {

/// The files that a run reads, so that it writes over none of them, and its log, which is written
/// while it reads. While one lives, whatever noteInput is told on any thread counts, and OutputFile
/// refuses to write there.
class InputFiles {
public:
    /// What an output would meet.
    enum class Use {
        none,   ///< no input
        read,   ///< a file that is read
        wanted, ///< the name of a file that would be read if it were there
        log     ///< the run's own log
    };

    InputFiles();
    ~InputFiles(); ///< what counted before it counts again
    InputFiles(const InputFiles&) = delete;
    InputFiles& operator=(const InputFiles&) = delete;

    /// Throws InputError where it is the log.
    void note(const std::filesystem::path& file);
    /// From now on \p file, which is there and was not noted, is the log.
    void keepLog(const std::filesystem::path& file);
    /// Whether the log was noted as a file that is read, or would be.
    bool readsLog();
    /// Files that are there are told by identity, through links of either kind; names of files that
    /// are not, as findFile compares them: but for the case of ASCII letters.
    Use useOf(const std::filesystem::path& output);

private:
    using Identity = std::pair<uint64_t, uint64_t>; ///< device and inode

    void index(const std::filesystem::path& file);
    std::string wholeName(const std::filesystem::path& file);
    bool isLog(const std::filesystem::path& file);

    InputFiles* const outer_;
    std::mutex mutex_;
    std::set<std::filesystem::path> noted_;
    std::set<std::filesystem::path> fresh_; ///< of these, the ones not yet in what follows
    std::set<Identity> there_;
    std::set<std::string> missing_;                                  ///< whole names in lower case
    std::map<std::filesystem::path, std::filesystem::path> folders_; ///< with links resolved
    std::filesystem::path log_;                                      ///< empty: none
    Identity logIdentity_{};
    std::string logName_; ///< as missing_ has names
    bool readsLog_ = false;
};

/// Notes a file that is read, or that a file which is read names, whether it is there or not.
/// Throws InputError where it is the run's log.
void noteInput(const std::filesystem::path& file);

/// InputFiles::useOf of the ones that count now.
InputFiles::Use inputUseOf(const std::filesystem::path& output);

/// Whether writing both would leave one: the same file, or the same place for one.
bool isSamePlace(const std::filesystem::path& a, const std::filesystem::path& b);

/// Where writing to \p path ends up: a symbolic link's target, be it there or not. A ring of links
/// gives one of them.
std::filesystem::path linkTarget(std::filesystem::path path);

} // namespace dirt
