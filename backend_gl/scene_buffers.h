#pragma once

#include "backend_gl/programs.h"
#include "backend_gl/texel_buffer.h"
#include "core/frame/requirements.h"
#include "core/frame/tracer.h"
#include "core/scene/scene.h"

#include <vector>

namespace dirt {

/// What Fetch reads of a scene: materials, and the attributes and texels that its requirements ask
/// for. Textures 6 to 17 of include/attributes.glsl and include/textures.glsl.
class SceneBuffers {
public:
    /// Throws InputError where the driver's buffers are too short for the scene.
    void upload(const Scene& scene, const Requirements& requirements);

    void bind() const;
    const SurfaceVariant& variant() const { return variant_; }
    std::vector<BufferSize> sizes() const;

private:
    void uploadMaterials(const Scene& scene);
    void uploadTextures(const Scene& scene);

    SurfaceVariant variant_;
    TexelBuffer materialOf_, materials_;
    TexelBuffer normalIndices_, normals_, texcoordIndices_, texcoords_;
    TexelBuffer colorIndices_, colors_;
    TexelBuffer textureTable_, decodedBytes_;
    std::vector<TexelBuffer> texels_; ///< pieces of one sequence of words
};

} // namespace dirt
