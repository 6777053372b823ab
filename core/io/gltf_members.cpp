#include "core/io/gltf_members.h"

#include <algorithm>
#include <vector>

#include <nlohmann/json.hpp>

namespace dirt {

namespace {

struct Kind;

/// A member of one kind of object, or an extension of it. A name that ends with '*' stands for all
/// that begin so.
struct Member {
    std::string_view name;
    const Kind* kind = nullptr; ///< of the objects that it is or lists; none: not looked into
};

/// A kind of object, and all that this program knows of it.
struct Kind {
    std::string label; ///< "node "; the root has none
    std::vector<Member> members;
    std::vector<Member> extensions = {};
};

// From the leaves to the root.

const Kind kTransform{"texture transform ", {{"offset"}, {"rotation"}, {"scale"}, {"texCoord"}}};
const Kind kTextureInfo{
    "texture ", {{"index"}, {"texCoord"}}, {{"KHR_texture_transform", &kTransform}}};
const Kind kNormalTexture{"normalTexture ",
                          {{"index"}, {"texCoord"}, {"scale"}},
                          {{"KHR_texture_transform", &kTransform}}};
const Kind kMetallicRoughness{"material ",
                              {{"baseColorFactor"},
                               {"baseColorTexture", &kTextureInfo},
                               {"metallicFactor"},
                               {"roughnessFactor"},
                               {"metallicRoughnessTexture", &kTextureInfo}}};
const Kind kSpecular{
    "material specular ",
    {{"specularFactor"}, {"specularColorFactor"}, {"specularTexture", &kTextureInfo}}};
const Kind kIor{"material ior ", {{"ior"}}};
const Kind kEmissiveStrength{"material emissive_strength ", {{"emissiveStrength"}}};
const Kind kUnlit{"material unlit ", {}};
const Kind kMaterial{"material ",
                     {{"pbrMetallicRoughness", &kMetallicRoughness},
                      {"normalTexture", &kNormalTexture},
                      {"emissiveTexture", &kTextureInfo},
                      {"emissiveFactor"},
                      {"alphaMode"},
                      {"alphaCutoff"},
                      {"doubleSided"}},
                     {{"KHR_materials_emissive_strength", &kEmissiveStrength},
                      {"KHR_materials_ior", &kIor},
                      {"KHR_materials_specular", &kSpecular},
                      {"KHR_materials_unlit", &kUnlit}}};
const Kind kTexture{"texture ", {{"sampler"}, {"source"}}};
const Kind kSampler{"sampler ", {{"magFilter"}, {"minFilter"}, {"wrapS"}, {"wrapT"}}};
const Kind kImage{"image ", {{"uri"}, {"mimeType"}, {"bufferView"}}};

const Kind kBuffer{
    "buffer ",
    {{"uri"}, {"byteLength"}},
#ifdef DIRT_HAVE_MESHOPT
    {{"EXT_meshopt_compression"}} // says that it is a fallback
#endif
};
const Kind kBufferView{"bufferView ",
                       {{"buffer"}, {"byteOffset"}, {"byteLength"}, {"byteStride"}, {"target"}},
#ifdef DIRT_HAVE_MESHOPT
                       {{"EXT_meshopt_compression"}}
#endif
};
const Kind kSparsePart{"accessor sparse ", {{"bufferView"}, {"byteOffset"}, {"componentType"}}};
const Kind kSparse{"accessor sparse ",
                   {{"count"}, {"indices", &kSparsePart}, {"values", &kSparsePart}}};
const Kind kAccessor{"accessor ",
                     {{"bufferView"},
                      {"byteOffset"},
                      {"componentType"},
                      {"normalized"},
                      {"count"},
                      {"type"},
                      {"min"},
                      {"max"},
                      {"sparse", &kSparse}}};

const Kind kAttributes{"attribute ", {{"POSITION"}, {"NORMAL"}, {"TEXCOORD_*"}, {"COLOR_0"}}};
const Kind kPrimitive{"primitive ",
                      {{"attributes", &kAttributes}, {"indices"}, {"material"}, {"mode"}},
#ifdef DIRT_HAVE_DRACO
                      {{"KHR_draco_mesh_compression"}}
#endif
};
const Kind kMesh{"mesh ", {{"primitives", &kPrimitive}}};

const Kind kPerspective{"camera perspective ", {{"aspectRatio"}, {"yfov"}, {"znear"}, {"zfar"}}};
const Kind kOrthographic{"camera orthographic ", {{"xmag"}, {"ymag"}, {"znear"}, {"zfar"}}};
const Kind kCamera{"camera ",
                   {{"type"}, {"perspective", &kPerspective}, {"orthographic", &kOrthographic}}};
const Kind kSpot{"light spot ", {{"innerConeAngle"}, {"outerConeAngle"}}};
const Kind kLight{"light ", {{"type"}, {"color"}, {"intensity"}, {"spot", &kSpot}}};
const Kind kLights{"lights ", {{"lights", &kLight}}};
const Kind kPlacedLight{"node light ", {{"light"}}};
const Kind kVisibility{"node visibility ", {{"visible"}}};
const Kind kInstanceAttributes{"instancing attribute ", {{"TRANSLATION"}, {"ROTATION"}, {"SCALE"}}};
const Kind kInstancing{"node instancing ", {{"attributes", &kInstanceAttributes}}};
const Kind kNode{
    "node ",
    {{"camera"}, {"children"}, {"matrix"}, {"mesh"}, {"rotation"}, {"scale"}, {"translation"}},
    {{"EXT_mesh_gpu_instancing", &kInstancing},
     {"KHR_lights_punctual", &kPlacedLight},
     {"KHR_node_visibility", &kVisibility}}};
const Kind kScene{"scene ", {{"nodes"}}};
const Kind kRoot{"",
                 {{"asset"},
                  {"extensionsUsed"},
                  {"extensionsRequired"},
                  {"scene"},
                  {"scenes", &kScene},
                  {"nodes", &kNode},
                  {"meshes", &kMesh},
                  {"cameras", &kCamera},
                  {"accessors", &kAccessor},
                  {"bufferViews", &kBufferView},
                  {"buffers", &kBuffer},
                  {"materials", &kMaterial},
                  {"textures", &kTexture},
                  {"samplers", &kSampler},
                  {"images", &kImage}},
                 {{"KHR_lights_punctual", &kLights}}};

/// Extensions that are honoured and are no member of anything.
constexpr std::string_view kWithoutMembers[] = {"KHR_mesh_quantization"};

const Member* find(const std::vector<Member>& members, std::string_view name) {
    const auto found = std::find_if(members.begin(), members.end(), [&](const Member& member) {
        return member.name.ends_with('*')
                   ? name.starts_with(member.name.substr(0, member.name.size() - 1))
                   : name == member.name;
    });
    return found == members.end() ? nullptr : &*found;
}

/// How often an unknown member counts: a list of objects is many things.
uint64_t timesOf(const nlohmann::json& value) {
    return value.is_array() && !value.empty() && value.front().is_object() ? value.size() : 1;
}

class Walk {
public:
    explicit Walk(GltfIgnored& ignored) : ignored_(ignored) {}

    /// Looks into an object, or all objects of a list. The kinds make a tree, so this ends however
    /// deep the document is.
    void look(const nlohmann::json& value, const Kind& kind) {
        if (value.is_array())
            for (const auto& element : value) lookIntoObject(element, kind);
        else
            lookIntoObject(value, kind);
    }

private:
    void lookIntoObject(const nlohmann::json& object, const Kind& kind) {
        if (!object.is_object()) return; // whoever reads it says so
        for (const auto& [name, value] : object.items()) {
            if (name == "name" || name == "extras") continue;
            if (name == "extensions")
                lookIntoExtensions(value, kind);
            else
                member(name, value, kind.members, kind.label);
        }
    }

    void lookIntoExtensions(const nlohmann::json& extensions, const Kind& kind) {
        if (!extensions.is_object()) return;
        for (const auto& [name, value] : extensions.items())
            member(name, value, kind.extensions, kind.label + "extension ");
    }

    void member(const std::string& name, const nlohmann::json& value,
                const std::vector<Member>& known, const std::string& label) {
        const Member* member = find(known, name);
        if (member == nullptr)
            ignored_.add(label + name, timesOf(value));
        else if (member->kind != nullptr)
            look(value, *member->kind);
    }

    GltfIgnored& ignored_;
};

bool knows(const Kind& kind, std::string_view extension) {
    if (find(kind.extensions, extension) != nullptr) return true;
    const auto below = [&](const Member& member) {
        return member.kind != nullptr && knows(*member.kind, extension);
    };
    return std::any_of(kind.members.begin(), kind.members.end(), below) ||
           std::any_of(kind.extensions.begin(), kind.extensions.end(), below);
}

} // namespace

void GltfIgnored::reportTo(LoadReport& report) const {
    for (const auto& [what, times] : counts_)
        report.ignore("glTF " + what + " (" + std::to_string(times) + ")");
}

void countUnknownMembers(const nlohmann::json& document, GltfIgnored& ignored) {
    Walk(ignored).look(document, kRoot);
}

bool knowsGltfExtension(std::string_view name) {
    return std::find(std::begin(kWithoutMembers), std::end(kWithoutMembers), name) !=
               std::end(kWithoutMembers) ||
           knows(kRoot, name);
}

std::string whyUnknown(std::string_view extension) {
    if (extension == "KHR_draco_mesh_compression") return "for which this program lacks Draco";
    if (extension == "EXT_meshopt_compression") return "for which this program lacks meshoptimizer";
    return "which is not known here";
}

std::optional<std::string> unknownExtension(const JsonValue& object) {
    if (const auto extensions = object.object("extensions"))
        for (const std::string& name : extensions->names())
            if (!knowsGltfExtension(name)) return name;
    return std::nullopt;
}

} // namespace dirt
