#pragma once

#include "core/io/load_report.h"
#include "core/io/material_convention.h"
#include "core/io/mtl.h"
#include "core/io/obj.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace dirt {

/// The MTL files of a scene, each read once, and what each is taken for.
class MaterialLibraries {
public:
    explicit MaterialLibraries(LoadReport& report, const MemoryBudget& budget = {})
        : report_(report), memory_(budget) {}

    /// A material of a file, and the convention that it is taken by.
    struct Entry {
        const MtlFile* file;
        const MtlMaterial* material;
        MaterialConvention convention;
    };
    using Library = std::map<std::string, Entry>;

    /// Every material of the files that mtllib names, by its name; of equal names the first counts.
    /// A missing file is a warning; as in Blender, one beside the OBJ file that has its name stands
    /// in. Throws InputError where a file cannot be read.
    Library of(const ObjFile& obj, const MaterialChoice& choice);

    /// What was read, each file once for every way it was taken.
    const std::vector<MaterialFile>& files() const { return files_; }

private:
    void read(const std::filesystem::path& file, const MaterialChoice& choice, Library& library);

    LoadReport& report_;
    MemoryClaim memory_; ///< for read_
    std::map<std::filesystem::path, MtlFile> read_;
    std::vector<MaterialFile> files_;
    std::set<std::tuple<std::filesystem::path, MaterialConvention, std::string>> taken_; ///< files_
};

} // namespace dirt
