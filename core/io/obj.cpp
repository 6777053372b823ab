#include "core/io/obj.h"

#include "core/io/number.h"
#include "core/io/text_file.h"

#include <array>
#include <charconv>
#include <map>
#include <string_view>

namespace dirt {

namespace {

/// Statements without effect on a picture that nobody needs to hear of.
bool isSilent(std::string_view keyword) {
    return keyword == "g" || keyword == "o" || keyword == "s" || keyword == "p" || keyword == "l";
}

class ObjReader {
public:
    ObjReader(const std::filesystem::path& file, LoadReport& report) : report_(report) {
        obj_.file = file;
    }

    ObjFile read(std::string_view text) {
        LineReader lines(text, LineReader::Continuation::backslash);
        while (lines.next()) {
            line_ = lines.number();
            std::string_view arguments = lines.line();
            const std::string_view keyword = takeWord(arguments);
            if (!keyword.empty() && keyword[0] != '#') statement(keyword, arguments);
        }
        checkRanges();
        return std::move(obj_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const { failAt(obj_.file, line_, message); }

    void statement(std::string_view keyword, std::string_view arguments) {
        if (keyword == "v")
            position(arguments);
        else if (keyword == "vn")
            obj_.normals.push_back(numbers(keyword, arguments, 3));
        else if (keyword == "vt")
            obj_.texcoords.emplace_back(numbers(keyword, arguments, 1));
        else if (keyword == "f")
            face(arguments);
        else if (keyword == "usemtl")
            material_ = addName(obj_.materialNames, names_, arguments);
        else if (keyword == "mtllib")
            addName(obj_.libraries, libraries_, arguments);
        else if (!isSilent(keyword))
            report_.ignore("OBJ " + std::string(keyword));
    }

    /// The first three of the line's numbers, of which \p needed must be there; others are 0.
    /// Further numbers (weights, colours) are only checked for their form.
    glm::dvec3 numbers(std::string_view keyword, std::string_view arguments, int needed) const {
        glm::dvec3 values(0.0);
        int count = 0;
        for (;;) {
            const std::string_view word = takeWord(arguments);
            if (word.empty() || word[0] == '#') break;
            const auto value = parseNumber(word);
            if (!value) fail("malformed number " + inQuotes(word));
            if (count < 3) values[count] = *value;
            ++count;
        }
        if (count < needed)
            fail(std::string(keyword) + " needs " + std::to_string(needed) +
                 (needed == 1 ? " number" : " numbers") + ", not " + std::to_string(count));
        return values;
    }

    void position(std::string_view arguments) {
        const glm::dvec3 p = numbers("v", arguments, 3);
        if (!fitsFloat(p)) fail("a coordinate is not a finite float32 number");
        obj_.positions.push_back(p);
    }

    void face(std::string_view arguments) {
        const size_t first = obj_.corners.size();
        for (;;) {
            const std::string_view word = takeWord(arguments);
            if (word.empty() || word[0] == '#') break;
            obj_.corners.push_back(corner(word));
        }
        const size_t count = obj_.corners.size() - first;
        if (count < 3) fail("a face needs 3 corners, not " + std::to_string(count));
        obj_.faces.push_back({line_, first, (uint32_t) count, material_});
    }

    /// "position", "position/texcoord", "position//normal" or "position/texcoord/normal".
    ObjFile::Corner corner(std::string_view word) {
        std::array<std::string_view, 3> parts;
        std::string_view rest = word;
        for (size_t i = 0; i < 3; ++i) {
            const size_t slash = rest.find('/');
            parts[i] = rest.substr(0, slash);
            if (slash == std::string_view::npos) break;
            rest.remove_prefix(slash + 1);
            if (i == 2) fail("malformed corner " + inQuotes(word));
        }
        if (parts[0].empty()) fail("malformed corner " + inQuotes(word));
        return {index(parts[0], word, obj_.positions.size(), "v"),
                index(parts[1], word, obj_.texcoords.size(), "vt"),
                index(parts[2], word, obj_.normals.size(), "vn")};
    }

    /// \p present: how many of these there are so far, from which negative indices count back.
    uint32_t index(std::string_view text, std::string_view word, size_t present, const char* what) {
        if (text.empty()) return ObjFile::kNone;
        int64_t value = 0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (stop != end || error == std::errc::invalid_argument)
            fail("malformed corner " + inQuotes(word));
        const bool fits = error == std::errc();
        if (fits && value < 0 && value >= -(int64_t) present)
            return (uint32_t) ((int64_t) present + value);
        if (fits && value > 0 && value < ObjFile::kNone) return (uint32_t) (value - 1);
        // An earlier face may turn out wrong when all vertices are known: that one is reported.
        if (rangeErrorLine_ == 0) {
            rangeErrorLine_ = line_;
            rangeError_ = outOfRange(std::string(text), what, present);
        }
        return ObjFile::kNone;
    }

    static std::string outOfRange(const std::string& index, const char* what, size_t present) {
        return std::string(what) + " index " + printable(index) + " is out of range (" +
               std::to_string(present) + " present)";
    }

    /// Reports the first index that is out of range, once all that indices may refer to is read.
    void checkRanges() {
        const auto check = [&](uint32_t index, size_t present, const char* what) {
            if (index != ObjFile::kNone && index >= present)
                fail(outOfRange(std::to_string(index + 1ull), what, present));
        };
        for (const ObjFile::Face& face : obj_.faces) {
            if (face.line == rangeErrorLine_) failAt(obj_.file, face.line, rangeError_);
            line_ = face.line;
            for (size_t i = 0; i < face.corners; ++i) {
                const ObjFile::Corner& corner = obj_.corners[face.firstCorner + i];
                check(corner.position, obj_.positions.size(), "v");
                check(corner.texcoord, obj_.texcoords.size(), "vt");
                check(corner.normal, obj_.normals.size(), "vn");
            }
        }
    }

    /// The place of a name in \p list, where it is appended if it is new.
    uint32_t addName(std::vector<ObjFile::Name>& list,
                     std::map<std::string, uint32_t, std::less<>>& known,
                     std::string_view arguments) {
        const std::string_view name = trimmed(arguments);
        const auto found = known.find(name);
        if (found != known.end()) return found->second;
        const uint32_t place = (uint32_t) list.size();
        list.push_back({std::string(name), line_});
        known.emplace(name, place);
        return place;
    }

    LoadReport& report_;
    ObjFile obj_;
    size_t line_ = 0;
    uint32_t material_ = ObjFile::kNone;
    size_t rangeErrorLine_ = 0; ///< of the first index that cannot be in range; 0: none
    std::string rangeError_;
    std::map<std::string, uint32_t, std::less<>> names_, libraries_;
};

} // namespace

ObjFile readObj(const std::filesystem::path& file, LoadReport& report) {
    return parseObj(file, readBytes(file), report);
}

ObjFile parseObj(const std::filesystem::path& file, std::string_view bytes, LoadReport& report) {
    return ObjReader(file, report).read(textOf(file, bytes));
}

} // namespace dirt
