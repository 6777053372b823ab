#include "core/io/gltf.h"

#include "core/io/gltf_material.h"
#include "core/io/gltf_members.h"
#include "core/io/gltf_mesh.h"
#include "core/io/gltf_nodes.h"

namespace dirt {

GltfFile readGltf(const std::filesystem::path& file, LoadReport& report) {
    MemoryClaim unlimited;
    return readGltf(file, report, unlimited);
}

GltfFile readGltf(const std::filesystem::path& file, LoadReport& report, MemoryClaim& memory) {
    const GltfData data(file, memory.budget());
    GltfIgnored ignored;
    countUnknownMembers(data.document(), ignored);
    GltfFile gltf;
    gltf.file = file;
    gltf.images = gltfImages(data, memory);
    FaultCounter faults;
    gltf.surfaces = gltfSurfaces(data, gltf.images.size(), ignored, faults);
    for (const JsonValue& mesh : data.root().objects("meshes"))
        gltf.meshes.push_back(gltfPrimitives(data, mesh, gltf.surfaces, ignored, faults, memory));
    placeGltfNodes(data, gltf, ignored, memory);
    report.warn(file, faults.faults());
    ignored.reportTo(report);
    return gltf;
}

} // namespace dirt
