#pragma once

#include "core/io/gltf.h"
#include "core/io/load_report.h"
#include "core/io/obj.h"

#include <filesystem>
#include <string>
#include <variant>

namespace dirt {

/// A model file that has been read; its materials and textures have not.
struct Model {
    std::variant<ObjFile, GltfFile> file;
    LoadReport report; ///< what was noticed
    MemoryClaim memory;
};

/// What tells file types apart: ".obj".
std::string lowerCaseExtension(const std::filesystem::path& file);

/// Whether a file's name says that it is a model.
bool isModelFile(const std::filesystem::path& file);

/// Reads a glTF file, or an OBJ file, which is what any other name is taken for; \p cache: through
/// its cache; within \p budget. Throws InputError (see readGltf and readObj).
Model readModel(const std::filesystem::path& file, bool cache, const MemoryBudget& budget = {});

} // namespace dirt
