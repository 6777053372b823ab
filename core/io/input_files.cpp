#include "core/io/input_files.h"

#include "core/base/error.h"
#include "core/io/text_file.h"

#include <atomic>
#include <system_error>

#include <sys/stat.h>

namespace dirt {

namespace {

namespace fs = std::filesystem;

std::atomic<InputFiles*> counting{nullptr};

/// Without links, as far as it is there.
fs::path resolvedFolder(const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
    const fs::path resolved = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : resolved;
}

} // namespace

InputFiles::InputFiles() : outer_(counting.exchange(this)) {}

InputFiles::~InputFiles() {
    counting = outer_;
}

void InputFiles::note(const fs::path& file) {
    const std::lock_guard lock(mutex_);
    if (!log_.empty() && isLog(file)) {
        readsLog_ = true;
        throw InputError(log_.string() + ": cannot write: the input is read from this file");
    }
    if (noted_.insert(file).second) fresh_.insert(file);
}

void InputFiles::keepLog(const fs::path& file) {
    const std::lock_guard lock(mutex_);
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return;
    log_ = file;
    logIdentity_ = {status.st_dev, status.st_ino};
    logName_ = wholeName(linkTarget(file));
}

bool InputFiles::readsLog() {
    const std::lock_guard lock(mutex_);
    return readsLog_;
}

/// By its identity, or by its name in another case, which findFile would take for it.
bool InputFiles::isLog(const fs::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) == 0)
        return Identity(status.st_dev, status.st_ino) == logIdentity_;
    return wholeName(file) == logName_;
}

/// In lower case.
std::string InputFiles::wholeName(const fs::path& file) {
    const auto [folder, isNew] = folders_.try_emplace(file.parent_path());
    if (isNew) folder->second = resolvedFolder(folder->first);
    return lowerCase((folder->second / file.filename()).string());
}

void InputFiles::index(const fs::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) == 0) {
        there_.emplace(status.st_dev, status.st_ino);
        return;
    }
    missing_.insert(wholeName(file));
}

InputFiles::Use InputFiles::useOf(const fs::path& output) {
    const std::lock_guard lock(mutex_);
    for (const fs::path& file : fresh_) index(file);
    fresh_.clear();
    struct stat status {};
    if (stat(output.c_str(), &status) == 0) {
        const Identity identity(status.st_dev, status.st_ino);
        if (there_.contains(identity)) return Use::read;
        if (!log_.empty() && identity == logIdentity_) return Use::log;
    }
    if (missing_.empty()) return Use::none;
    const fs::path target = linkTarget(output);
    const fs::path whole = resolvedFolder(target.parent_path()) / target.filename();
    return missing_.contains(lowerCase(whole.string())) ? Use::wanted : Use::none;
}

void noteInput(const fs::path& file) {
    if (InputFiles* files = counting) files->note(file);
}

InputFiles::Use inputUseOf(const fs::path& output) {
    InputFiles* files = counting;
    return files ? files->useOf(output) : InputFiles::Use::none;
}

bool isSamePlace(const fs::path& a, const fs::path& b) {
    std::error_code error;
    if (fs::equivalent(a, b, error) && !error) return true;
    const fs::path first = linkTarget(a), second = linkTarget(b);
    return first.filename() == second.filename() &&
           resolvedFolder(first.parent_path()) == resolvedFolder(second.parent_path());
}

fs::path linkTarget(fs::path path) {
    constexpr int kMostLinks = 40; // as Linux follows
    std::error_code error;
    for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i) {
        const fs::path target = fs::read_symlink(path, error);
        if (error) break;
        path = target.is_absolute() ? target : path.parent_path() / target;
    }
    return path;
}

} // namespace dirt
