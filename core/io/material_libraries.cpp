#include "core/io/material_libraries.h"

#include "core/io/find_file.h"
#include "core/io/mtl_material.h"
#include "core/io/text_file.h"

namespace dirt {

namespace fs = std::filesystem;

MaterialLibraries::Library MaterialLibraries::of(const ObjFile& obj, const MaterialChoice& choice) {
    Library library;
    const fs::path folder = obj.file.parent_path();
    for (const ObjFile::Name& name : obj.libraries) {
        // A name may hold blanks; but blanks may also separate several names.
        if (const auto whole = findFile(folder, name.text)) {
            read(*whole, choice, library);
            continue;
        }
        std::vector<std::string> missing;
        bool found = false;
        std::string_view rest = name.text;
        for (auto word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
            const bool isWhole = word.size() == name.text.size(); // which is not there
            if (const auto part = isWhole ? std::nullopt : findFile(folder, word)) {
                read(*part, choice, library);
                found = true;
            } else {
                missing.emplace_back(word);
            }
        }
        if (!found) missing = {name.text};
        std::string standIn;
        if (!found)
            if (const auto beside = findFile(folder, obj.file.stem().string() + ".mtl")) {
                read(*beside, choice, library);
                standIn = "; " + inQuotes(beside->filename().string()) + " stands in";
            }
        for (const std::string& text : missing)
            report_.warn(WarningKind::missingMaterialLibrary, obj.file, name.line,
                         "material file " + inQuotes(text) + " not found" + standIn);
    }
    return library;
}

void MaterialLibraries::read(const fs::path& file, const MaterialChoice& choice, Library& library) {
    auto known = read_.find(file);
    if (known == read_.end()) {
        known = read_.emplace(file, readMtl(file, memory_)).first;
        report_.warn(file, known->second.faults);
        for (const std::string& name : known->second.others) report_.ignore("MTL " + name);
    }
    const MtlFile& mtl = known->second;
    const MaterialFile taken = decideConvention(file, choice, mtl.saysMetallic());
    if (taken_.insert({taken.file, taken.convention, taken.reason}).second) {
        for (const MtlMaterial& material : mtl.materials)
            reportIgnored(material, taken.convention, report_);
        files_.push_back(taken);
    }
    for (const MtlMaterial& material : mtl.materials)
        library.try_emplace(material.name, Entry{&mtl, &material, taken.convention});
}

} // namespace dirt
