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
    struct Image {
        ImageFile file;
        std::vector<Key> keys;
        std::vector<Read> reads;
        std::vector<Result> results;
    };
    std::vector<Image> images;
    std::map<std::string, size_t> places;
    for (const Announced& part : announced.announced_) {
        const auto [place, isNew] = places.try_emplace(part.key.first, images.size());
        if (isNew) images.push_back({part.image, {}, {}, {}});
        images[place->second].keys.push_back(part.key);
        images[place->second].reads.push_back(part.read);
    }
    readAll(images.size(), executor, progress,
            [&](size_t i) { images[i].results = read(images[i].file, images[i].reads); });
    for (Image& image : images)
        for (size_t i = 0; i < image.keys.size(); ++i)
            ahead_[image.keys[i]] = std::move(image.results[i]);
}

/// What each of \p reads gets of the image, which is decoded once.
std::vector<TextureLoader::Result> TextureLoader::read(const ImageFile& file,
                                                       std::span<const Read> reads) {
    std::vector<Result> results(reads.size());
    try {
        const DecodedImage image(file);
        for (size_t i = 0; i < reads.size(); ++i) {
            try {
                results[i] = reads[i](image);
            } catch (const InputError& error) {
                results[i] = std::string(error.what());
            }
        }
    } catch (const InputError& error) {
        results.assign(reads.size(), std::string(error.what()));
    }
    return results;
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
    Result result =
        ahead ? std::move(ahead.mapped()) : std::move(this->read(*source.image, {&read, 1})[0]);
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
                    [](const DecodedImage& image) { return readTexture(image); });
    return load(source, "colour" + exactText(factor.x) + exactText(factor.y) + exactText(factor.z),
                scene_.textures,
                [factor](const DecodedImage& image) { return readTexture(image).times(factor); });
}

uint32_t TextureLoader::data(const Source& source) {
    return load(source, "data", scene_.scalarTextures,
                [](const DecodedImage& image) { return readScalarTexture(image); });
}

uint32_t TextureLoader::alpha(const Source& source, float limit) {
    return load(source, "alpha" + exactText(limit), scene_.scalarTextures,
                [limit](const DecodedImage& image) -> Result {
                    auto alpha = readAlpha(image, limit);
                    if (!alpha) return {};
                    return std::move(*alpha);
                });
}

std::optional<glm::vec3> TextureLoader::means(const Source& source) {
    const uint32_t place =
        load(source, "means", means_, [](const DecodedImage& image) { return readMeans(image); });
    if (place == kNoTexture) return std::nullopt;
    return means_[place];
}

} // namespace dirt
