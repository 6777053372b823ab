#include "backend_gl/scene_buffers.h"

#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace dirt {
namespace {

constexpr int kMostTexelPieces = 2; // of include/textures.glsl

template <typename T>
TexelBuffer texelBuffer(GLenum format, size_t texelBytes, const std::vector<T>& values,
                        const char* what) {
    return TexelBuffer(format, texelBytes, values.size() * sizeof(T), values.data(), what);
}

using Words = std::array<uint32_t, 4>; // a texel of GL_RGBA32UI

Words wordsOf(glm::vec3 v, uint32_t last) {
    return {std::bit_cast<uint32_t>(v.x), std::bit_cast<uint32_t>(v.y),
            std::bit_cast<uint32_t>(v.z), last};
}

/// A texture's texels as include/textures.glsl reads them.
std::vector<uint32_t> wordsOf(const Texture& texture) {
    std::vector<uint32_t> words;
    const std::span<const uint8_t> bytes = texture.encodedTexels();
    words.reserve(bytes.size() / 3 + texture.linearTexels().size());
    for (size_t i = 0; i < bytes.size(); i += 3)
        words.push_back((uint32_t) bytes[i] | (uint32_t) bytes[i + 1] << 8 |
                        (uint32_t) bytes[i + 2] << 16);
    for (float value : texture.linearTexels()) words.push_back(std::bit_cast<uint32_t>(value));
    return words;
}

uint64_t wordCount(const Texture& texture) {
    return texture.encodedTexels().size() / 3 + texture.linearTexels().size();
}

std::vector<uint32_t> wordsOf(const ScalarTexture& texture) {
    std::vector<uint32_t> words;
    words.reserve((size_t) texture.width() * (size_t) texture.height());
    for (int y = 0; y < texture.height(); ++y)
        for (int x = 0; x < texture.width(); ++x)
            words.push_back(std::bit_cast<uint32_t>(texture.texel(x, y)));
    return words;
}

bool needsTextures(const Scene& scene, const Requirements& need) {
    if (scene.mesh.texcoords.empty()) return false;
    const auto hasOpacityMap = [](const Material& m) { return m.opacityMap != kNoTexture; };
    return need.diffuseTextures || need.emissionTextures || need.reflectanceTextures ||
           need.roughnessTextures || need.metallicTextures || need.bumps || need.normalMaps ||
           (need.cutOuts &&
            std::any_of(scene.materials.begin(), scene.materials.end(), hasOpacityMap));
}

SurfaceVariant variantOf(const Scene& scene, const Requirements& need) {
    SurfaceVariant variant;
    variant.normals = need.shadingNormals;
    variant.textures = needsTextures(scene, need);
    variant.bumps = need.bumps;
    variant.cutOuts = need.cutOuts;
    variant.normalMaps = need.normalMaps;
    variant.roughnessMaps = need.roughnessTextures;
    variant.metallicMaps = need.metallicTextures;
    variant.factors = need.textureFactors;
    variant.wraps = need.textureWraps;
    variant.transforms = need.textureTransforms;
    variant.linearBytes =
        variant.textures &&
        std::any_of(scene.textures.begin(), scene.textures.end(), [](const Texture& texture) {
            return texture.encoding() == TexelEncoding::linear && texture.linearTexels().empty();
        });
    variant.colors = need.vertexColors;
    return variant;
}

/// What the last word of a texture's entry says of its sampling.
uint32_t samplingBits(const TextureSampling& sampling) {
    return (uint32_t) sampling.wrapU << 4 | (uint32_t) sampling.wrapV << 6 |
           (sampling.transformed ? 0x100u : 0u);
}

uint32_t kindBits(const Texture& texture) {
    const bool linear = texture.encoding() == TexelEncoding::linear;
    return !texture.linearTexels().empty() ? 1 : linear ? 2 : 0;
}

} // namespace

void SceneBuffers::upload(const Scene& scene, const Requirements& need) {
    *this = {}; // before the next ones are allocated
    variant_ = variantOf(scene, need);
    uploadMaterials(scene);
    const Mesh& mesh = scene.mesh;
    if (need.shadingNormals) {
        normalIndices_ = texelBuffer(GL_RGB32UI, sizeof(Corners), mesh.normalIndices, "triangles");
        normals_ = texelBuffer(GL_RGB32F, sizeof(glm::vec3), mesh.normals, "normals");
    }
    if (variant_.colors) {
        colorIndices_ = texelBuffer(GL_RGB32UI, sizeof(Corners), mesh.triangles, "triangles");
        colors_ = texelBuffer(GL_RGB32F, sizeof(glm::vec3), mesh.colors, "vertex colours");
    }
    if (variant_.textures) {
        texcoordIndices_ =
            texelBuffer(GL_RGB32UI, sizeof(Corners), mesh.texcoordIndices, "triangles");
        texcoords_ =
            texelBuffer(GL_RG32F, sizeof(glm::vec2), mesh.texcoords, "texture coordinates");
        uploadTextures(scene);
    }
}

void SceneBuffers::uploadMaterials(const Scene& scene) {
    std::vector<Words> words;
    // Data follow the colours in the table of textures.
    const auto ofData = [&](uint32_t map) {
        return map == kNoTexture ? map : map + (uint32_t) scene.textures.size();
    };
    for (const Material& m : scene.materials) {
        words.push_back(wordsOf(m.diffuse, m.diffuseMap));
        words.push_back(wordsOf(m.emission, m.emissionMap));
        words.push_back(
            wordsOf(glm::vec3(m.reflectance, m.metallic, m.roughness), ofData(m.reflectanceMap)));
        // Its sign says whether the surface has one side.
        const float opacity = m.doubleSided ? m.opacity : -m.opacity;
        const uint32_t heights = m.normalMap == kNoTexture ? m.bumpMap : kNoTexture;
        words.push_back({std::bit_cast<uint32_t>(opacity), std::bit_cast<uint32_t>(m.bumpScale),
                         ofData(heights), ofData(m.opacityMap)});
        if (variant_.materialTexels() == 4) continue;
        words.push_back(wordsOf(m.diffuseMapFactor, m.normalMap));
        words.push_back({std::bit_cast<uint32_t>(m.normalScale), ofData(m.roughnessMap),
                         ofData(m.metallicMap), 0});
    }
    materials_ = texelBuffer(GL_RGBA32UI, sizeof(Words), words, "materials");
    materialOf_ = texelBuffer(GL_R32UI, sizeof(uint32_t), scene.mesh.materials, "triangles");
}

void SceneBuffers::uploadTextures(const Scene& scene) {
    std::vector<Words> table;
    uint64_t total = 0;
    std::map<const void*, uint64_t> places; // of texels, which several may share
    std::vector<std::pair<uint64_t, std::function<std::vector<uint32_t>()>>> texels;
    const auto enter = [&](const auto& texture, uint32_t kind, uint64_t words) {
        const auto [place, isNew] = places.try_emplace(texture.identity(), total);
        if (isNew) {
            texels.emplace_back(total, [&texture] { return wordsOf(texture); });
            total += words;
        }
        const TextureSampling& sampling = texture.sampling();
        table.push_back({(uint32_t) place->second, (uint32_t) texture.width(),
                         (uint32_t) texture.height(), kind | samplingBits(sampling)});
        if (!variant_.transforms) return;
        for (const glm::vec3& row : {sampling.rowU, sampling.rowV})
            table.push_back(wordsOf(row, 0));
    };
    for (const Texture& texture : scene.textures)
        enter(texture, kindBits(texture), wordCount(texture));
    for (const ScalarTexture& texture : scene.scalarTextures)
        enter(texture, 0, (uint64_t) texture.width() * (uint64_t) texture.height());
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    variant_.texelPieceBits = std::min((int) std::bit_width((uint32_t) most) - 1, 31);
    const uint64_t piece = 1ull << variant_.texelPieceBits;
    if (total > kMostTexelPieces * piece)
        throw InputError("--backend gl: the textures take " + std::to_string(total) +
                         " words, and this OpenGL driver's buffer textures hold " +
                         std::to_string(kMostTexelPieces * piece) + "; smaller ones would fit");

    // One sequence of words, cut where a piece ends.
    std::vector<GlBuffer> pieces;
    for (uint64_t first = 0; first < std::max<uint64_t>(total, 1); first += piece)
        pieces.emplace_back(std::min(piece, total - first) * sizeof(uint32_t));
    const auto write = [&](uint64_t place, const std::vector<uint32_t>& words) {
        for (uint64_t done = 0; done < words.size();) {
            const uint64_t at = place + done, inPiece = at % piece;
            const uint64_t count = std::min(words.size() - done, piece - inPiece);
            pieces[at / piece].write(inPiece * sizeof(uint32_t), count * sizeof(uint32_t),
                                     words.data() + done);
            done += count;
        }
    };
    for (const auto& [place, words] : texels) write(place, words());
    variant_.texelPieces = (int) pieces.size();
    for (GlBuffer& words : pieces) texels_.emplace_back(GL_R32UI, std::move(words));
    textureTable_ = texelBuffer(GL_RGBA32UI, sizeof(Words), table, "textures");
    std::vector<float> decoded;
    const auto append = [&](TexelEncoding encoding) {
        const auto& values = Texture::decodedBytes(encoding);
        decoded.insert(decoded.end(), values.begin(), values.end());
    };
    append(TexelEncoding::srgb);
    if (variant_.linearBytes) append(TexelEncoding::linear);
    decodedBytes_ = texelBuffer(GL_R32F, sizeof(float), decoded, "decoded bytes");
}

void SceneBuffers::bind() const {
    const GLuint textures[] = {materialOf_.texture(),
                               materials_.texture(),
                               normalIndices_.texture(),
                               normals_.texture(),
                               texcoordIndices_.texture(),
                               texcoords_.texture(),
                               textureTable_.texture(),
                               decodedBytes_.texture(),
                               texels_.size() > 0 ? texels_[0].texture() : 0,
                               texels_.size() > 1 ? texels_[1].texture() : 0,
                               colorIndices_.texture(),
                               colors_.texture()};
    glBindTextures(6, 12, textures);
}

std::vector<BufferSize> SceneBuffers::sizes() const {
    std::vector<BufferSize> sizes = {{"materials", materialOf_.bytes() + materials_.bytes()}};
    const auto add = [&sizes](const char* name, uint64_t bytes) {
        if (bytes > 0) sizes.emplace_back(name, bytes);
    };
    add("normals", normalIndices_.bytes() + normals_.bytes());
    add("vertex colours", colorIndices_.bytes() + colors_.bytes());
    add("texture coordinates", texcoordIndices_.bytes() + texcoords_.bytes());
    uint64_t texels = textureTable_.bytes() + decodedBytes_.bytes();
    for (const TexelBuffer& piece : texels_) texels += piece.bytes();
    add("textures", texels);
    return sizes;
}

} // namespace dirt
