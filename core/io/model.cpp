#include "core/io/model.h"

#include "core/io/obj_cache.h"

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

} // namespace

bool isModelFile(const std::filesystem::path& file) {
    return isGltf(file) || lowerCaseExtension(file) == ".obj";
}

Model readModel(const std::filesystem::path& file, bool cache) {
    Model model;
    if (isGltf(file))
        model.file = readGltf(file, model.report);
    else
        model.file = cache ? readObjCached(file, model.report) : readObj(file, model.report);
    return model;
}

} // namespace dirt
