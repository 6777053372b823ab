#include "core/io/obj.h"

#include "core/io/number.h"
#include "core/io/text_file.h"
#include "core/io/vertex_colours.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string_view>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

/// Statements without effect on a picture that nobody needs to hear of.
bool isSilent(std::string_view keyword) {
    return keyword == "g" || keyword == "o" || keyword == "s" || keyword == "p" || keyword == "l";
}

/// Statements of geometry and its materials.
bool isGeometry(std::string_view keyword) {
    return keyword == "v" || keyword == "vn" || keyword == "vt" || keyword == "f" ||
           keyword == "usemtl" || keyword == "mtllib";
}

class ObjReader {
public:
    ObjReader(const std::filesystem::path& file, LoadReport& report, MemoryClaim& memory)
        : report_(report), memory_(memory) {
        obj_.file = file;
    }

    ObjFile read(std::string_view text) {
        LineReader lines(text, LineReader::Continuation::backslash);
        while (lines.next()) {
            line_ = lines.number();
            std::string_view arguments = lines.line();
            const std::string_view keyword = takeWord(arguments);
            if (keyword == "#MRGB")
                ignore(keyword); // ZBrush's colours of vertices
            else if (!keyword.empty() && keyword[0] != '#')
                statement(keyword, arguments);
            if (++sinceCharged_ == kLinesPerCharge) charge();
        }
        if (unknownLine_ > 0 && !isObj_) {
            line_ = unknownLine_;
            fail(inQuotes(unknown_) + " is no statement of an OBJ file");
        }
        for (const std::string& name : ignored_) report_.ignore("OBJ " + name);
        charge();
        checkIndices();
        checkVertices();
        decodeColours();
        obj_.faults = faults_.faults();
        std::stable_sort(obj_.faults.begin(), obj_.faults.end(),
                         [](const Fault& a, const Fault& b) { return a.line < b.line; });
        return std::move(obj_);
    }

private:
    enum Attribute { kPosition, kTexcoord, kNormal };
    /// An index that cannot be in range, whatever follows.
    static constexpr uint32_t kNowhere = ObjFile::kNone - 1;

    /// Lines between two looks at how much memory they took: of a megabyte or so.
    static constexpr size_t kLinesPerCharge = 1 << 14;

    /// Takes what the arrays have now, and what the largest would take to grow.
    void charge() {
        sinceCharged_ = 0;
        const auto bytes = [](const auto& array) { return array.capacity() * sizeof array[0]; };
        const uint64_t sizes[] = {bytes(obj_.positions), bytes(obj_.normals), bytes(obj_.texcoords),
                                  bytes(obj_.corners), bytes(obj_.faces)};
        const uint64_t sum = std::accumulate(std::begin(sizes), std::end(sizes), uint64_t(0));
        memory_.reach(textBytes_ + sum + 2 * *std::max_element(std::begin(sizes), std::end(sizes)),
                      obj_.file, "the model");
    }

    [[noreturn]] void fail(const std::string& message) const { failAt(obj_.file, line_, message); }

    void fault(const char* message) {
        faults_.add(WarningKind::unusableAttribute, message, line_, [=] { return message; });
    }

    void statement(std::string_view keyword, std::string_view arguments) {
        isObj_ = isObj_ || isGeometry(keyword);
        if (keyword == "v")
            position(arguments);
        else if (keyword == "vn")
            normal(arguments);
        else if (keyword == "vt")
            texcoord(arguments);
        else if (keyword == "f")
            face(arguments);
        else if (keyword == "usemtl")
            material_ = addName(obj_.materialNames, names_, arguments);
        else if (keyword == "mtllib")
            addName(obj_.libraries, libraries_, arguments);
        else if (!isSilent(keyword))
            ignore(keyword);
    }

    /// They are told of at the end: of a file that is none of OBJ no more than its first is shown.
    void ignore(std::string_view keyword) {
        if (unknownLine_ == 0) {
            unknownLine_ = line_;
            unknown_ = keyword;
        }
        const auto [name, isNew] = ignoredNames_.emplace(keyword);
        if (isNew) ignored_.push_back(*name);
    }

    /// How many of the line's numbers there are, of which \p needed must be there. The first six
    /// go into values_; those that are not there are 0.
    size_t numbers(std::string_view keyword, std::string_view arguments, size_t needed) {
        values_ = {};
        size_t count = 0;
        for (;;) {
            const std::string_view word = takeWord(arguments);
            if (word.empty() || word[0] == '#') break;
            const auto value = parseNumber(word);
            if (!value) fail("malformed number " + inQuotes(word));
            if (count < values_.size()) values_[count] = *value;
            ++count;
        }
        if (count < needed)
            fail(std::string(keyword) + " needs " + std::to_string(needed) +
                 (needed == 1 ? " number" : " numbers") + ", not " + std::to_string(count));
        return count;
    }

    /// A fourth number is a weight; six are position and colour. What follows is alpha, or nothing
    /// that Blender or MeshLab would look at.
    void position(std::string_view arguments) {
        const size_t count = numbers("v", arguments, 3);
        const glm::dvec3 p(values_[0], values_[1], values_[2]);
        if (!fitsFloat(p)) unfit_.push_back({obj_.positions.size(), line_});
        if (count >= 6) {
            const glm::dvec3 colour(values_[3], values_[4], values_[5]);
            const bool bright = colours_.largest() > 1.0;
            if (!colours_.set(obj_.positions.size(), colour))
                fault("a vertex colour is negative or not finite: white is taken");
            if (!bright && colours_.largest() > 1.0) brightLine_ = line_;
        }
        obj_.positions.push_back(p);
    }

    void normal(std::string_view arguments) {
        numbers("vn", arguments, 3);
        const glm::dvec3 n(values_[0], values_[1], values_[2]);
        const double square = glm::dot(n, n);
        if (!std::isfinite(square))
            fault("a normal is not finite: triangles with it have their own");
        else if (!(square > 0.0))
            fault("a normal has no length: triangles with it have their own");
        obj_.normals.push_back(n);
    }

    void texcoord(std::string_view arguments) {
        numbers("vt", arguments, 1);
        if (!fitsFloat(values_[0]) || !fitsFloat(values_[1]))
            fault("texture coordinates are not finite: triangles with them have none");
        obj_.texcoords.emplace_back(values_[0], values_[1]);
    }

    void face(std::string_view arguments) {
        words_.clear();
        for (;;) {
            const std::string_view word = takeWord(arguments);
            if (word.empty() || word[0] == '#') break;
            words_.push_back(word);
        }
        const size_t count = words_.size();
        if (count < 3) {
            faults_.add(WarningKind::skippedGeometry, "face", line_, [=] {
                return "a face needs 3 corners, not " + std::to_string(count) + ": it is skipped";
            });
            return;
        }
        obj_.faces.push_back({line_, obj_.corners.size(), (uint32_t) count, material_});
        for (const std::string_view word : words_) obj_.corners.push_back(corner(word));
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
        return {index(parts[0], word, obj_.positions.size(), kPosition),
                index(parts[1], word, obj_.texcoords.size(), kTexcoord),
                index(parts[2], word, obj_.normals.size(), kNormal)};
    }

    /// \p present: how many of these there are so far, from which negative indices count back.
    uint32_t index(std::string_view text, std::string_view word, size_t present,
                   Attribute attribute) {
        if (text.empty()) return ObjFile::kNone;
        int64_t value = 0;
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (stop != end || error == std::errc::invalid_argument)
            fail("malformed corner " + inQuotes(word));
        const bool fits = error == std::errc();
        if (fits && value < 0 && value >= -(int64_t) present)
            return (uint32_t) ((int64_t) present + value);
        if (fits && value > 0 && value <= kNowhere) return (uint32_t) (value - 1);
        // An earlier face may turn out wrong when all vertices are known: that one is reported.
        if (nowhere_[attribute].empty())
            nowhere_[attribute] = outOfRange(std::string(text), attribute, present);
        return kNowhere;
    }

    static std::string outOfRange(const std::string& index, Attribute attribute, size_t present) {
        constexpr const char* kNames[] = {"v", "vt", "vn"};
        return std::string(kNames[attribute]) + " index " + printable(index) +
               " is out of range (" + std::to_string(present) + " present)";
    }

    /// Looks for indices that are out of range, once all that they may refer to is read.
    void checkIndices() {
        const auto textOf = [&](uint32_t index, size_t present, Attribute attribute) {
            return index == kNowhere ? nowhere_[attribute]
                                     : outOfRange(std::to_string(index + 1ull), attribute, present);
        };
        const auto optional = [&](uint32_t& index, size_t present, Attribute attribute,
                                  const char* fallback) {
            if (index == ObjFile::kNone || index < present) return;
            faults_.add(WarningKind::unusableAttribute, fallback, line_,
                        [&] { return textOf(index, present, attribute).append(fallback); });
            index = ObjFile::kNone;
        };
        const size_t positions = obj_.positions.size();
        for (const ObjFile::Face& face : obj_.faces) {
            line_ = face.line;
            for (ObjFile::Corner& c :
                 std::span(obj_.corners).subspan(face.firstCorner, face.corners)) {
                if (c.position >= positions) fail(textOf(c.position, positions, kPosition));
                optional(c.texcoord, obj_.texcoords.size(), kTexcoord,
                         ": triangles with it have no texture coordinates");
                optional(c.normal, obj_.normals.size(), kNormal,
                         ": triangles with it have their own normal");
            }
        }
    }

    /// A position that is not finite matters where a face uses it.
    void checkVertices() {
        if (unfit_.empty()) return;
        std::vector<bool> used(obj_.positions.size(), false);
        for (const ObjFile::Corner& corner : obj_.corners) used[corner.position] = true;
        for (const Unfit& vertex : unfit_) {
            line_ = vertex.line;
            const std::string what = "a coordinate is not a finite float32 number";
            if (used[vertex.index]) fail(what);
            faults_.add(WarningKind::skippedGeometry, "vertex", line_,
                        [&] { return what + ": no face uses the vertex"; });
        }
    }

    void decodeColours() {
        obj_.colors = colours_.decoded(obj_.positions.size());
        line_ = brightLine_;
        if (colours_.areOf255())
            fault("vertex colours are whole numbers above 1: they are taken as of 255");
        else if (brightLine_ > 0)
            fault("a vertex colour is above 1: 1 is taken");
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

    /// A position that does not fit in float32.
    struct Unfit {
        size_t index, line;
    };

    LoadReport& report_;
    MemoryClaim& memory_;
    const uint64_t textBytes_ = memory_.bytes(); ///< taken for the file's text
    size_t sinceCharged_ = 0;                    ///< lines
    bool isObj_ = false;                         ///< there was a statement that nothing else has
    size_t unknownLine_ = 0;                     ///< of the first statement that is not known,
    std::string unknown_;                        ///< and its keyword
    std::vector<std::string> ignored_;           ///< such keywords, each once
    std::set<std::string> ignoredNames_;         ///< the same
    ObjFile obj_;
    FaultCounter faults_;
    VertexColours colours_;
    std::vector<Unfit> unfit_;
    size_t line_ = 0;
    size_t brightLine_ = 0; ///< of the first colour above 1; 0: none
    uint32_t material_ = ObjFile::kNone;
    std::array<double, 6> values_{};      ///< of the line at hand
    std::vector<std::string_view> words_; ///< of the line at hand
    std::array<std::string, 3> nowhere_;  ///< of each attribute, what the first kNowhere was
    std::map<std::string, uint32_t, std::less<>> names_, libraries_;
};

} // namespace

ObjFile readObj(const std::filesystem::path& file, LoadReport& report) {
    MemoryClaim unlimited;
    return readObj(file, report, unlimited);
}

ObjFile readObj(const std::filesystem::path& file, LoadReport& report, MemoryClaim& memory) {
    const std::string bytes = readBytes(file, memory);
    return parseObj(file, bytes, report, memory);
}

ObjFile parseObj(const std::filesystem::path& file, std::string_view bytes, LoadReport& report,
                 MemoryClaim& memory) {
    ObjFile obj = ObjReader(file, report, memory).read(textOf(file, bytes));
    report.warn(file, obj.faults);
    return obj;
}

} // namespace dirt
