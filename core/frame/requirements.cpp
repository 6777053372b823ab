#include "core/frame/requirements.h"

#include <algorithm>
#include <set>
#include <utility>

namespace dirt {

namespace {

bool isBlack(glm::vec3 color) {
    return !(color.x > 0.0f || color.y > 0.0f || color.z > 0.0f);
}

/// Materials that some triangle has.
std::vector<const Material*> usedMaterials(const Scene& scene) {
    std::vector<uint8_t> used(scene.materials.size(), 0);
    for (uint32_t material : scene.mesh.materials) used[material] = 1;
    std::vector<const Material*> materials;
    for (size_t i = 0; i < used.size(); ++i)
        if (used[i]) materials.push_back(&scene.materials[i]);
    return materials;
}

template <typename Predicate>
size_t countMaterials(const Scene& scene, const Predicate& predicate) {
    const auto materials = usedMaterials(scene);
    return (size_t) std::count_if(materials.begin(), materials.end(), predicate);
}

bool shines(const Material* material) {
    return !isBlack(material->emission);
}
bool isTextured(const Material* material) {
    return material->diffuseMap != kNoTexture;
}
bool shinesByTexture(const Material* material) {
    return shines(material) && material->emissionMap != kNoTexture;
}
bool isTexturedByFactor(const Material* material) {
    return isTextured(material) && material->diffuseMapFactor != glm::vec3(1.0f);
}
bool isMetalByTexture(const Material* material) {
    return material->metallicMap != kNoTexture && material->metallic > 0.0f;
}
bool mayBeGlossy(const Material* material) {
    return material->reflectance > 0.0f || isMetalByTexture(material);
}
bool isGlossyByTexture(const Material* material) {
    return material->reflectance > 0.0f && material->reflectanceMap != kNoTexture;
}
bool isRoughByTexture(const Material* material) {
    return mayBeGlossy(material) && material->roughnessMap != kNoTexture;
}
bool isMapped(const Material* material) {
    return material->normalMap != kNoTexture;
}
bool isBumpy(const Material* material) {
    return material->bumpMap != kNoTexture && !isMapped(material);
}
bool isCutOut(const Material* material) {
    return material->hasCutOuts();
}

/// What materials that some triangle has look up, sampled as \p predicate wants.
template <typename Predicate>
std::pair<size_t, size_t> countTextures(const Scene& scene, const Predicate& predicate) {
    std::set<uint32_t> colours, data;
    for (const Material* m : usedMaterials(scene)) {
        colours.insert({m->diffuseMap, m->emissionMap, m->normalMap});
        data.insert({m->reflectanceMap, m->roughnessMap, m->metallicMap, m->opacityMap});
        if (isBumpy(m)) data.insert(m->bumpMap);
    }
    colours.erase(kNoTexture);
    data.erase(kNoTexture);
    size_t found = 0;
    for (uint32_t i : colours) found += predicate(scene.textures[i].sampling());
    for (uint32_t i : data) found += predicate(scene.scalarTextures[i].sampling());
    return {found, colours.size() + data.size()};
}

bool isTransformed(const TextureSampling& sampling) {
    return sampling.transformed;
}
bool isWrapped(const TextureSampling& sampling) {
    return sampling.wrapU != Wrap::repeat || sampling.wrapV != Wrap::repeat;
}

/// Triangles with a normal at every corner.
size_t countNormals(const Mesh& mesh) {
    if (mesh.normals.empty()) return 0;
    return (size_t) std::count_if(
        mesh.normalIndices.begin(), mesh.normalIndices.end(),
        [](const Corners& c) { return std::find(c.begin(), c.end(), kNoIndex) == c.end(); });
}

std::string share(size_t count, size_t all, const char* what) {
    return std::to_string(count) + " of " + std::to_string(all) + " " + what;
}

} // namespace

Requirements requirementsOf(const Scene& scene, const RenderSettings& settings, bool rasterizes) {
    Requirements need;
    need.light = !scene.lights.empty() && settings.rayType != RayType::visibility;
    const bool mapped = settings.visibility == LightVisibility::shadowMap;
    need.openLight = need.light && !scene.lights.front().shadows;
    const bool shadows = need.light && !need.openLight;
    need.shadowRays = shadows && !mapped;
    if (shadows && mapped) need.shadowMap = (uint32_t) scene.lights.front().resolution;
    need.emission = countMaterials(scene, shines) > 0;
    need.background = !isBlack(scene.background);
    const bool textured = !scene.mesh.texcoords.empty();
    need.diffuseTextures = textured && countMaterials(scene, isTextured) > 0;
    need.emissionTextures = textured && countMaterials(scene, shinesByTexture) > 0;
    need.gloss = countMaterials(scene, mayBeGlossy) > 0 || settings.rayType == RayType::glossy ||
                 settings.rayType == RayType::specular;
    need.reflectanceTextures = textured && countMaterials(scene, isGlossyByTexture) > 0;
    need.roughnessTextures = textured && countMaterials(scene, isRoughByTexture) > 0;
    need.metallicTextures = countMaterials(scene, isMetalByTexture) > 0;
    need.bumps = textured && countMaterials(scene, isBumpy) > 0;
    need.normalMaps = textured && countMaterials(scene, isMapped) > 0;
    need.textureFactors = textured && countMaterials(scene, isTexturedByFactor) > 0;
    need.textureTransforms = textured && countTextures(scene, isTransformed).first > 0;
    need.textureWraps = textured && countTextures(scene, isWrapped).first > 0;
    need.vertexColors = !scene.mesh.colors.empty();
    need.cutOuts = countMaterials(scene, isCutOut) > 0;
    need.shadingNormals = countNormals(scene.mesh) > 0;
    need.indirect = settings.bounces > 1;
    need.lens = scene.camera.apertureRadius > 0.0f;
    need.packedShading = settings.shading == Shading::packed;
    need.tracedPrimary = settings.primary == Primary::traced || need.lens || !rasterizes;
    return need;
}

std::vector<RequirementReason> explain(const Requirements& need, const Scene& scene,
                                       const RenderSettings& settings, bool rasterizes) {
    const size_t materials = usedMaterials(scene).size();
    const auto ofTextured = [&](const auto& predicate) -> std::string {
        if (scene.mesh.texcoords.empty()) return "no texture coordinates";
        return share(countMaterials(scene, predicate), materials, "materials");
    };
    const auto ofTextures = [&](const auto& predicate) -> std::string {
        if (scene.mesh.texcoords.empty()) return "no texture coordinates";
        const auto [found, all] = countTextures(scene, predicate);
        return share(found, all, "textures");
    };
    const std::string bounces = std::to_string(settings.bounces) + " bounces";
    return {
        {"light", need.light,
         scene.lights.empty() ? "no light in the scene"
         : need.light         ? "the scene has a spotlight"
                              : "the image shows visibility alone"},
        {"shadow rays", need.shadowRays,
         !need.light       ? "no light"
         : need.openLight  ? "the light casts no shadows"
         : need.shadowRays ? "whether a point sees the light is traced"
                           : "the light has a shadow map"},
        {"shadow map", need.shadowMap > 0,
         need.shadowMap > 0
             ? "asked for: " + std::to_string(need.shadowMap) + " texels along a side"
         : need.openLight ? "the light casts no shadows"
                          : "not asked for"},
        {"light without shadows", need.openLight,
         need.openLight ? "the scene asks for it" : "not asked for"},
        {"emission", need.emission, share(countMaterials(scene, shines), materials, "materials")},
        {"background", need.background,
         need.background ? "rays that miss see a radiance" : "rays that miss see isBlack"},
        {"diffuse textures", need.diffuseTextures, ofTextured(isTextured)},
        {"emission textures", need.emissionTextures, ofTextured(shinesByTexture)},
        {"gloss", need.gloss,
         settings.rayType == RayType::glossy || settings.rayType == RayType::specular
             ? "asked for"
             : share(countMaterials(scene, mayBeGlossy), materials, "materials")},
        {"reflectance textures", need.reflectanceTextures, ofTextured(isGlossyByTexture)},
        {"roughness textures", need.roughnessTextures, ofTextured(isRoughByTexture)},
        {"metallic textures", need.metallicTextures,
         share(countMaterials(scene, isMetalByTexture), materials, "materials")},
        {"bump maps", need.bumps, ofTextured(isBumpy)},
        {"normal maps", need.normalMaps, ofTextured(isMapped)},
        {"texture factors", need.textureFactors, ofTextured(isTexturedByFactor)},
        {"texture transforms", need.textureTransforms, ofTextures(isTransformed)},
        {"texture borders", need.textureWraps, ofTextures(isWrapped)},
        {"vertex colours", need.vertexColors,
         need.vertexColors ? "the scene has some" : "the scene has none"},
        {"cut-outs", need.cutOuts, share(countMaterials(scene, isCutOut), materials, "materials")},
        {"shading normals", need.shadingNormals,
         share(countNormals(scene.mesh), scene.mesh.triangles.size(), "triangles")},
        {"indirect light", need.indirect, need.indirect ? bounces : "direct light only"},
        {"lens", need.lens, need.lens ? "the camera has an aperture" : "the camera is a pinhole"},
        {"traced primary rays", need.tracedPrimary,
         !rasterizes                           ? "the backend does not rasterize"
         : settings.primary == Primary::traced ? "asked for"
         : need.lens                           ? "the lens has an aperture"
                                               : "direct visibility is rasterized"},
        {"packed shading", need.packedShading,
         need.packedShading ? "asked for" : "surface points are kept in full"},
        {"G[k-1]", need.previousPoint,
         need.previousPoint ? "asked for" : "the rays say from where their hits are seen"},
    };
}

} // namespace dirt
