#include "core/io/obj_cache.h"

#include "core/base/error.h"
#include "core/io/content_hash.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <type_traits>

namespace dirt {

namespace {

namespace fs = std::filesystem;

/// Counts up with each change of what readObj gives or of how it is stored.
constexpr uint32_t kVersion = 3;

/// Files that are shorter are read in a millisecond.
constexpr size_t kLeastSource = size_t(1) << 16;

/// The beginning of a cache; what follows are the arrays, each with its count before it.
struct Header {
    char magic[8] = {'d', 'i', 'r', 't', 's', 'b', 'i', 'n'};
    uint32_t version = kVersion;
    uint32_t byteOrder = 0x01020304;
    uint64_t layout = 0; ///< of the structures that are stored as they are
    uint64_t sourceSize = 0, sourceHash = 0;
    uint64_t contentSize = 0, contentHash = 0;
    uint64_t hash = 0; ///< of all above
};
static_assert(std::has_unique_object_representations_v<Header>);

template <typename Value>
std::span<const std::byte> bytesOf(const Value& value) {
    return std::as_bytes(std::span(&value, 1));
}

uint64_t layoutHash() {
    const uint64_t layout[] = {sizeof(ObjFile::Corner),
                               offsetof(ObjFile::Corner, texcoord),
                               offsetof(ObjFile::Corner, normal),
                               sizeof(ObjFile::Face),
                               offsetof(ObjFile::Face, firstCorner),
                               offsetof(ObjFile::Face, corners),
                               offsetof(ObjFile::Face, material),
                               sizeof(size_t),
                               sizeof(glm::dvec3),
                               sizeof(glm::dvec2)};
    return contentHash(std::as_bytes(std::span(layout)));
}

Header makeHeader(std::span<const std::byte> content, std::span<const std::byte> source) {
    Header header;
    header.layout = layoutHash();
    header.sourceSize = source.size();
    header.sourceHash = contentHash(source);
    header.contentSize = content.size();
    header.contentHash = contentHash(content);
    header.hash = contentHash(bytesOf(header).first(offsetof(Header, hash)));
    return header;
}

class Writer {
public:
    template <typename Value>
    void array(const std::vector<Value>& values) {
        static_assert(std::is_trivially_copyable_v<Value>);
        number(values.size());
        bytes_.append((const char*) values.data(), values.size() * sizeof(Value));
    }
    void text(const std::string& value) {
        number(value.size());
        bytes_ += value;
    }
    void names(const std::vector<ObjFile::Name>& names) {
        number(names.size());
        for (const ObjFile::Name& name : names) {
            number(name.line);
            text(name.text);
        }
    }
    void faults(const std::vector<Fault>& faults) {
        number(faults.size());
        for (const Fault& fault : faults) {
            number((uint64_t) fault.kind);
            number(fault.line);
            text(fault.message);
            number(fault.count);
        }
    }
    void number(uint64_t value) { bytes_.append((const char*) &value, sizeof value); }
    std::string& bytes() { return bytes_; }

private:
    std::string bytes_;
};

/// Its getters set failed() where the bytes do not last.
class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <typename Value>
    void array(std::vector<Value>& values) {
        const uint64_t count = number();
        if (count > rest_.size() / sizeof(Value)) return fail();
        values.resize(count);
        take(values.data(), count * sizeof(Value));
    }
    void text(std::string& value) {
        const uint64_t size = number();
        if (size > rest_.size()) return fail();
        value.resize(size);
        take(value.data(), size);
    }
    void names(std::vector<ObjFile::Name>& names) {
        for (uint64_t count = number(); count > 0 && !failed_; --count) {
            ObjFile::Name& name = names.emplace_back();
            name.line = number();
            text(name.text);
        }
    }
    void faults(std::vector<Fault>& faults) {
        for (uint64_t count = number(); count > 0 && !failed_; --count) {
            Fault& fault = faults.emplace_back();
            const uint64_t kind = number();
            if (kind > (uint64_t) kLastWarningKind) return fail();
            fault.kind = (WarningKind) kind;
            fault.line = number();
            text(fault.message);
            fault.count = number();
        }
    }
    uint64_t number() {
        uint64_t value = 0;
        if (rest_.size() < sizeof value) {
            fail();
            return 0;
        }
        take(&value, sizeof value);
        return value;
    }
    bool failed() const { return failed_ || !rest_.empty(); }

private:
    void fail() { failed_ = true; }
    void take(void* target, size_t size) {
        if (size > 0) std::memcpy(target, rest_.data(), size);
        rest_ = rest_.subspan(size);
    }

    std::span<const std::byte> rest_;
    bool failed_ = false;
};

/// Whether every index is in range: sums can be met by chance or on purpose.
bool isConsistent(const ObjFile& obj) {
    const auto within = [](uint32_t index, size_t count) {
        return index == ObjFile::kNone || index < count;
    };
    return (obj.colors.empty() || obj.colors.size() == obj.positions.size()) &&
           std::all_of(obj.corners.begin(), obj.corners.end(),
                       [&](const ObjFile::Corner& c) {
                           return c.position < obj.positions.size() &&
                                  within(c.texcoord, obj.texcoords.size()) &&
                                  within(c.normal, obj.normals.size());
                       }) &&
           std::all_of(obj.faces.begin(), obj.faces.end(), [&](const ObjFile::Face& f) {
               return f.corners >= 3 && f.firstCorner <= obj.corners.size() &&
                      f.corners <= obj.corners.size() - f.firstCorner &&
                      within(f.material, obj.materialNames.size());
           });
}

fs::path userFolder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    // A relative path there is to be ignored (XDG Base Directory Specification).
    if (cache && cache[0] == '/') return fs::path(cache) / "dirt";
    const char* home = std::getenv("HOME");
    return home && home[0] == '/' ? fs::path(home) / ".cache" / "dirt" : fs::path();
}

/// Whether someone has write permission to the folder, or to the one it would be made in: root
/// would write anywhere.
bool isWritable(fs::path folder) {
    std::error_code error;
    while (folder.has_relative_path() && !fs::exists(folder, error)) folder = folder.parent_path();
    constexpr fs::perms kWrite =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    return (fs::status(folder.empty() ? "." : folder, error).permissions() & kWrite) !=
               fs::perms::none &&
           !error;
}

/// Whether something is there that no cache is, and must stay.
bool isForeign(const fs::path& place) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(place, error))) return false;
    if (!fs::is_regular_file(place, error)) return true;
    const Header header;
    char magic[sizeof header.magic] = {};
    std::ifstream file(place, std::ios::binary);
    file.read(magic, sizeof magic);
    return file.gcount() > 0 && std::memcmp(magic, header.magic, sizeof magic) != 0;
}

/// In the first place that takes it; else not at all.
void keepCache(const std::vector<fs::path>& places, const std::string& cache, LoadReport& report) {
    for (const fs::path& place : places) {
        if (!isWritable(place.parent_path()) || isForeign(place)) continue;
        std::error_code error;
        if (&place != &places.front()) fs::create_directories(place.parent_path(), error);
        try {
            writeFile(place.string(), cache);
            noteInput(place);
            return report.keptCache(place);
        } catch (const InputError&) { // a full disk, a folder of that name
        }
    }
}

/// The first that is sound.
std::optional<ReadObj> findCache(const std::vector<fs::path>& places,
                                 std::span<const std::byte> source, const fs::path& file,
                                 MemoryClaim& memory) {
    for (const fs::path& place : places) {
        std::error_code error;
        if (!fs::is_regular_file(place, error)) continue;
        try {
            const std::string bytes = readOwnBytes(place, memory);
            // The arrays are what it holds.
            memory.take(bytes.size(), place, "the model");
            if (auto read = decodeCache(std::as_bytes(std::span(bytes)), source, file)) {
                noteInput(place);
                return read;
            }
        } catch (const MemoryError&) {
            throw;
        } catch (const InputError&) { // it cannot be read
        }
    }
    return std::nullopt;
}

} // namespace

std::vector<fs::path> cachePlaces(const fs::path& obj) {
    std::vector<fs::path> places{obj.string() + ".sbin"};
    const fs::path folder = userFolder();
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(obj, error), error);
    if (folder.empty() || error) return places;
    char name[32];
    const std::string text = whole.string();
    std::snprintf(name, sizeof name, "-%016llx.sbin",
                  (unsigned long long) contentHash(std::as_bytes(std::span(text))));
    places.push_back(folder / (obj.stem().string() + name));
    return places;
}

std::string sealCache(const std::string& content, std::span<const std::byte> source) {
    const Header header = makeHeader(std::as_bytes(std::span(content)), source);
    return std::string((const char*) &header, sizeof header) + content;
}

std::string encodeCache(const ReadObj& read, std::span<const std::byte> source) {
    Writer content;
    const ObjFile& obj = read.obj;
    content.array(obj.positions);
    content.array(obj.colors);
    content.array(obj.normals);
    content.array(obj.texcoords);
    content.array(obj.corners);
    content.array(obj.faces);
    content.names(obj.materialNames);
    content.names(obj.libraries);
    content.faults(obj.faults);
    content.number(read.ignored.size());
    for (const std::string& name : read.ignored) content.text(name);
    return sealCache(content.bytes(), source);
}

std::optional<ReadObj> decodeCache(std::span<const std::byte> cache,
                                   std::span<const std::byte> source, const fs::path& file) {
    if (cache.size() < sizeof(Header)) return std::nullopt;
    const auto content = cache.subspan(sizeof(Header));
    const Header expected = makeHeader(content, source);
    if (std::memcmp(cache.data(), &expected, sizeof expected) != 0) return std::nullopt;
    ReadObj read;
    ObjFile& obj = read.obj;
    obj.file = file;
    Reader reader(content);
    reader.array(obj.positions);
    reader.array(obj.colors);
    reader.array(obj.normals);
    reader.array(obj.texcoords);
    reader.array(obj.corners);
    reader.array(obj.faces);
    reader.names(obj.materialNames);
    reader.names(obj.libraries);
    reader.faults(obj.faults);
    for (uint64_t count = reader.number(); count > 0; --count) {
        reader.text(read.ignored.emplace_back());
        if (read.ignored.back().empty()) return std::nullopt; // or the bytes did not last
    }
    if (reader.failed() || !isConsistent(obj)) return std::nullopt;
    return read;
}

ObjFile readObjCached(const fs::path& file, LoadReport& report, MemoryClaim& memory) {
    const std::string text = readBytes(file, memory);
    const auto source = std::as_bytes(std::span(text));
    if (source.size() < kLeastSource) return parseObj(file, text, report, memory);
    const auto places = cachePlaces(file);
    auto read = findCache(places, source, file, memory);
    if (!read) {
        LoadReport own;
        ObjFile obj = parseObj(file, text, own, memory);
        read = {std::move(obj), own.ignored()};
        keepCache(places, encodeCache(*read, source), report);
    }
    report.warn(file, read->obj.faults);
    for (const std::string& name : read->ignored) report.addIgnored(name);
    return std::move(read->obj);
}

} // namespace dirt
