#include "core/dump/channels.h"

#include "core/dump/shadow_rays.h"
#include "core/grid/grid.h"
#include "shaders/shared/layouts.h"

#include <cstddef>

namespace dirt {

namespace {

using Type = ExrChannel::Type;

constexpr const char* kGrid = "grid frame";
constexpr const char* kView = "view frame";
constexpr const char* kColor = "linear Rec.709";
constexpr const char* kLength = "world unit * frame.scale";
constexpr const char* kRadiance = "radiance";
constexpr const char* kPixelOrder = "XYZ";
constexpr const char* kColorOrder = "RGB";

class Table {
public:
    Table& word(const std::string& name, size_t offset, const std::string& meaning) {
        return add(name, name + ".X", Type::uint32, offset, "", "", meaning);
    }
    Table& number(const std::string& name, size_t offset, const char* space, const char* unit,
                  const std::string& meaning) {
        return add(name, name + ".X", Type::float32, offset, space, unit, meaning);
    }
    Table& depth(const std::string& name, size_t offset, const char* space,
                 const std::string& meaning) {
        return add(name, name + ".Z", Type::float32, offset, space, kLength, meaning);
    }
    /// Three channels, called by \p letters.
    Table& vector(const std::string& name, size_t offset, const char* letters, const char* space,
                  const char* unit, const std::string& meaning) {
        for (size_t i = 0; i < 3; ++i) {
            const std::string full = (name.empty() ? "" : name + ".") + letters[i];
            add(full, full, Type::float32, offset + i * sizeof(float), space, unit, meaning);
        }
        return *this;
    }
    /// As deep files have them: words, or depths of a view.
    Table& ofDeep(const std::string& name, Type type, size_t offset, const std::string& meaning) {
        const bool isDepth = type == Type::float32;
        return add(name, name, type, offset, isDepth ? kView : "", isDepth ? kLength : "", meaning);
    }
    operator std::vector<ChannelInfo>() const { return rows_; }

private:
    Table& add(const std::string& name, const std::string& inFile, Type type, size_t offset,
               const char* space, const char* unit, const std::string& meaning) {
        ChannelInfo& row = rows_.emplace_back();
        row.channel = {name, type};
        row.inFile = inFile;
        row.offset = offset;
        row.space = space;
        row.unit = unit;
        row.meaning = meaning;
        return *this;
    }

    std::vector<ChannelInfo> rows_;
};

const std::string kNone = "; 4294967295: none";

} // namespace

std::vector<ChannelInfo> triangleChannels() {
    return Table()
        .vector("a", offsetof(Triangle, a), kPixelOrder, kGrid, kLength, "first vertex")
        .vector("b", offsetof(Triangle, b), kPixelOrder, kGrid, kLength, "second vertex")
        .vector("c", offsetof(Triangle, c), kPixelOrder, kGrid, kLength, "third vertex");
}

std::vector<ChannelInfo> depthChannels() {
    return Table()
        .depth("near", offsetof(DepthBounds, near), kView,
               "least depth w of any primitive part in the tile; above far where there is none")
        .depth("far", offsetof(DepthBounds, far), kView,
               "greatest depth w of any primitive part in the tile");
}

std::vector<ChannelInfo> shadowMapChannels() {
    return Table().depth("depth", 0, "light",
                         "of the nearest caster along the light's axis; the largest float where "
                         "there is none");
}

std::vector<ChannelInfo> rayChannels() {
    return Table()
        .vector("origin", offsetof(PathRay, origin), kPixelOrder, kGrid, kLength, "where it starts")
        .word("skip", offsetof(PathRay, skip), "primitive it starts on and does not hit" + kNone)
        .vector("direction", offsetof(PathRay, direction), kPixelOrder, kGrid, "",
                "where it goes; zero: the pixel's path has ended")
        .number("pdf", offsetof(PathRay, pdf), "", "1/steradian",
                "density with which the direction was chosen; 1 from the eye")
        .vector("throughput", offsetof(PathRay, throughput), kColorOrder, kColor, "",
                "weight of what the ray finds");
}

std::vector<ChannelInfo> shadowRayChannels() {
    return Table()
        .vector("origin", offsetof(ShadowRecord, origin), kPixelOrder, kGrid, kLength,
                "where it starts")
        .word("skip", offsetof(ShadowRecord, skip),
              "primitive it starts on and does not hit" + kNone)
        .vector("direction", offsetof(ShadowRecord, direction), kPixelOrder, kGrid, "",
                "where it goes; zero: none was cast")
        .number("tMax", offsetof(ShadowRecord, tMax), "", "ray.direction",
                "what is hit before it blocks the ray")
        .word("occluded", offsetof(ShadowRecord, occluded),
              "1: Visibility found something in between")
        .word("blocker", offsetof(ShadowRecord, blocker),
              "primitive that a search for the nearest hit finds in between" + kNone)
        .number("t", offsetof(ShadowRecord, t), "", "ray.direction", "where the blocker is hit")
        .word("view", offsetof(ShadowRecord, view),
              "view of the tile in which it is hit; the number of views: the eye itself")
        .word("column", offsetof(ShadowRecord, column), "of the tile")
        .word("row", offsetof(ShadowRecord, row), "of the tile");
}

std::vector<ChannelInfo> hitChannels() {
    return Table()
        .word("primitive", offsetof(Hit, primitive), "primitive id of the nearest hit" + kNone)
        .number("t", offsetof(Hit, t), "", "ray.direction", "where on the ray")
        .number("u", offsetof(Hit, u), "", "", "barycentric weight of the second vertex")
        .number("v", offsetof(Hit, v), "", "", "barycentric weight of the third vertex")
        .word("view", offsetof(Hit, view),
              "view whose tile lists the record; the number of views: the eye itself")
        .word("tile", offsetof(Hit, tile), "tile that lists the record, row-major in the view")
        .word("fetches", offsetof(Hit, fetches), "how often Fetch found the record: 1 for a hit");
}

std::vector<ChannelInfo> surfacePointChannels() {
    return Table()
        .vector("position", offsetof(SurfacePoint, position), kPixelOrder, kGrid, kLength,
                "where the surface point is")
        .word("primitive", offsetof(SurfacePoint, primitive), "primitive id" + kNone)
        .vector("geometricNormal", offsetof(SurfacePoint, geometricNormal), kPixelOrder, kGrid, "",
                "unit normal of the triangle, on the side the ray came from")
        .number("u", offsetof(SurfacePoint, u), "", "", "barycentric weight of the second vertex")
        .vector("shadingNormal", offsetof(SurfacePoint, shadingNormal), kPixelOrder, kGrid, "",
                "unit interpolated normal, on the same side")
        .number("v", offsetof(SurfacePoint, v), "", "", "barycentric weight of the third vertex")
        .vector("diffuse", offsetof(SurfacePoint, diffuse), kColorOrder, kColor, "",
                "diffuse reflectance")
        .number("roughness", offsetof(SurfacePoint, roughness), "", "",
                "width of the microfacets' distribution")
        .vector("emission", offsetof(SurfacePoint, emission), kColorOrder, kColor, kRadiance,
                "emitted radiance")
        .word("gloss", offsetof(SurfacePoint, gloss),
              "reflectance in the low, metallic in the high 16 bits, in units of 1/65535");
}

std::vector<ChannelInfo> flagChannels(const std::string& name, const std::string& meaning) {
    return Table().word(name, 0, meaning);
}

std::vector<ChannelInfo> radianceChannels() {
    return Table().vector("", 0, kColorOrder, kColor, kRadiance, "what the sample has gathered");
}

std::vector<ChannelInfo> entryChannels() {
    return Table()
        .ofDeep("id", Type::uint32, 0, "primitive id of the list entry")
        .ofDeep("bin", Type::uint32, 4, "depth bin that lists it")
        .ofDeep("view", Type::uint32, 8, "view of the tile")
        .ofDeep("Z", Type::float32, 12, "least depth w of the primitive's part in the tile")
        .ofDeep("ZBack", Type::float32, 16, "greatest depth w of the primitive's part in the tile");
}

std::vector<ChannelInfo> withPrefix(const std::string& prefix, std::vector<ChannelInfo> channels) {
    for (ChannelInfo& info : channels)
        for (std::string* name : {&info.channel.name, &info.inFile}) *name = prefix + "." + *name;
    return channels;
}

} // namespace dirt
