#include "app/cli/tradeoff_errors.h"

#include "app/cli/image_metadata.h"
#include "app/cli/log.h"
#include "core/base/error.h"
#include "core/io/output_file.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <filesystem>

namespace dirt {

namespace {

std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

/// Throws InputError with the first of \p expected that \p found has otherwise.
void expectSame(const std::string& file, const ImageMetadata& expected,
                const ImageMetadata& found) {
    for (const auto& [key, value] : expected) {
        const auto same = [&name = key](const auto& attribute) { return attribute.first == name; };
        const auto there = std::find_if(found.begin(), found.end(), same);
        const std::string is = there == found.end() ? "unknown" : there->second;
        if (is != value)
            throw InputError(file + ": is no reference here: its " + key.substr(5) + " is " + is +
                             ", not " + value);
    }
}

} // namespace

KeptReferences::KeptReferences(std::string folder, const Input& input)
    : folder_(std::move(folder)), input_(input) {
    std::filesystem::create_directories(folder_);
}

Image KeptReferences::operator()(const RenderSettings& settings,
                                 const std::function<Image()>& trace) const {
    const std::string name = input_.scene.name + "-" + std::to_string(settings.bounces) + ".exr";
    const std::string file = (std::filesystem::path(folder_) / name).string();
    ImageMetadata metadata = metadataOf(input_, settings, settings.samples);
    if (!std::filesystem::exists(file)) {
        checkWritable(file);
        Image image = trace();
        writeExr(file, image, metadata);
        logWritten(file);
        return image;
    }
    Image image = readImage(file);
    ImageMetadata found = readMetadata(file);
    metadata.emplace_back("dirt:size", sizeText(settings.grid.width, settings.grid.height));
    found.emplace_back("dirt:size", sizeText(image.width, image.height));
    expectSame(file, metadata, found);
    return image;
}

KnownErrors::KnownErrors(const std::string& file, const Json& head, const Sweeps& sweeps)
    : file_(file), errors_(sweeps.settings.size()) {
    using nlohmann::json; // whatever the order of the keys
    try {
        const json report = json::parse(readTextFile(file));
        for (const auto& [key, value] : head.items())
            if (report.at(key) != json(value))
                throw InputError(file + ": its errors are of another run: its " + key + " is " +
                                 report.at(key).dump() + ", not " + value.dump());
        json points = json::array(), expected = json::array();
        for (const json& point : report.at("points"))
            points.push_back({point.at("sweep"), point.at("value"), point.at("settings")});
        for (const Sweep& sweep : sweeps.sweeps)
            for (const auto& [value, settings] : sweep.points)
                expected.push_back({sweep.name, value, settings});
        if (points != expected) throw InputError(file + ": its errors are of other sweeps");
        for (const json& row : report.at("errors"))
            errors_.at(row.at("settings").get<size_t>())
                .push_back({row.at("samples").get<int>(), row.at("relative_mse").get<double>(),
                            row.at("flip").get<double>()});
        referenceSamples_ = report.at("reference_spp").get<int>();
    } catch (const json::exception&) {
        throw InputError(file + ": is not the JSON of a `bench tradeoff`");
    }
}

std::vector<ErrorAt> KnownErrors::of(size_t settings) const {
    if (errors_[settings].empty())
        throw InputError(file_ + ": has no errors of settings " + std::to_string(settings) +
                         ", whose image differs here");
    return errors_[settings];
}

} // namespace dirt
