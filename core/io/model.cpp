#include "core/io/model.h"

#include "core/io/find_file.h"
#include "core/io/obj_cache.h"

#include <utility>

namespace dirt {

std::string lowerCaseExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = (char) (c - 'A' + 'a');
    return extension;
}

namespace {

bool isGltf(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    return extension == ".gltf" || extension == ".glb";
}

/// Images that no material uses are the user's all the same.
GltfFile noteImages(GltfFile gltf) {
    for (const GltfFile::Image& image : gltf.images)
        if (!image.bytes) noteNamedFile(gltf.file.parent_path(), image.label);
    return gltf;
}

} // namespace

bool isModelFile(const std::filesystem::path& file) {
    return isGltf(file) || lowerCaseExtension(file) == ".obj";
}

Model readModel(const std::filesystem::path& file, bool cache, const MemoryBudget& budget) {
    Model model;
    model.memory = MemoryClaim(budget);
    if (isGltf(file))
        model.file = noteImages(readGltf(file, model.report, model.memory));
    else
        model.file = cache ? readObjCached(file, model.report, model.memory)
                           : readObj(file, model.report, model.memory);
    return model;
}

} // namespace dirt
