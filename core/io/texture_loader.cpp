#include "core/io/texture_loader.h"

#include "core/io/error.h"

#include <cstdio>

namespace dirt {

namespace {

/// What tells numbers apart to the bit.
std::string exactText(float value) {
    char text[32];
    std::snprintf(text, sizeof text, " %a", value);
    return text;
}

} // namespace

void TextureLoader::readAhead(const TextureLoader& announced, Executor& executor,
                              const LoadProgress& progress) {
    const std::vector<Announced>& list = announced.announced_;
    std::vector<Result> results(list.size());
    readAll(list.size(), executor, progress,
            [&](size_t i) { results[i] = read(list[i].image, list[i].read); });
    for (size_t i = 0; i < list.size(); ++i) ahead_[list[i].key] = std::move(results[i]);
}

TextureLoader::Result TextureLoader::read(const ImageFile& image, const Read& read) {
    try {
        return read(image);
    } catch (const InputError& error) {
        return std::string(error.what());
    }
}

template <typename T>
uint32_t TextureLoader::load(const Source& source, const std::string& what,
                             std::vector<T>& textures, const Read& read) {
    const std::string path = source.image ? source.image->name.string()
                                          : (source.namedBy.parent_path() / source.label).string();
    const Key key(path, what);
    const auto [entry, isNew] = places_.try_emplace(key, kNoTexture);
    if (!isNew) return entry->second;
    if (announcing_) {
        if (source.image) announced_.push_back({key, *source.image, read});
        return kNoTexture;
    }
    const std::string name = "texture " + inQuotes(source.label);
    if (!source.image) {
        report_.warn(WarningKind::unusableTexture, source.namedBy, source.line,
                     name + " not found");
        return kNoTexture;
    }
    const auto ahead = ahead_.extract(key);
    Result result = ahead ? std::move(ahead.mapped()) : this->read(*source.image, read);
    if (const auto* error = std::get_if<std::string>(&result))
        report_.warn(WarningKind::unusableTexture, source.namedBy, source.line,
                     name + ": " + *error);
    if (auto* texture = std::get_if<T>(&result)) {
        textures.push_back(std::move(*texture));
        entry->second = (uint32_t) textures.size() - 1;
    }
    return entry->second;
}

uint32_t TextureLoader::colour(const Source& source, glm::vec3 factor) {
    if (factor == glm::vec3(1.0f))
        return load(source, "colour", scene_.textures,
                    [](const ImageFile& image) { return readTexture(image); });
    return load(source, "colour" + exactText(factor.x) + exactText(factor.y) + exactText(factor.z),
                scene_.textures,
                [factor](const ImageFile& image) { return readTexture(image).times(factor); });
}

uint32_t TextureLoader::data(const Source& source) {
    return load(source, "data", scene_.scalarTextures,
                [](const ImageFile& image) { return readScalarTexture(image); });
}

uint32_t TextureLoader::alpha(const Source& source, float limit) {
    return load(source, "alpha" + exactText(limit), scene_.scalarTextures,
                [limit](const ImageFile& image) -> Result {
                    auto alpha = readAlpha(image, limit);
                    if (!alpha) return {};
                    return std::move(*alpha);
                });
}

std::optional<glm::vec3> TextureLoader::means(const Source& source) {
    const uint32_t place =
        load(source, "means", means_, [](const ImageFile& image) { return readMeans(image); });
    if (place == kNoTexture) return std::nullopt;
    return means_[place];
}

} // namespace dirt
