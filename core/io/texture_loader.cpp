#include "core/io/texture_loader.h"

#include "core/base/error.h"
#include "core/io/content_hash.h"

#include <cstdio>
#include <utility>

namespace dirt {

namespace {

/// What tells numbers apart to the bit.
std::string exactText(float value) {
    char text[32];
    std::snprintf(text, sizeof text, " %a", value);
    return text;
}

std::string exactText(const TextureSampling& sampling) {
    std::string text =
        std::to_string((int) sampling.wrapU) + " " + std::to_string((int) sampling.wrapV);
    if (sampling.transformed)
        for (const glm::vec3& row : {sampling.rowU, sampling.rowV})
            for (int i = 0; i < 3; ++i) text += exactText(row[i]);
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
                                                       std::span<const Read> reads) const {
    std::vector<Result> results(reads.size());
    try {
        const DecodedImage image(file, budget_);
        for (size_t i = 0; i < reads.size(); ++i) {
            try {
                results[i].value = reads[i](image);
                results[i].fault = image.takeFault();
            } catch (const MemoryError&) {
                throw;
            } catch (const InputError& error) {
                results[i].value = std::string(error.what());
            }
        }
    } catch (const MemoryError&) {
        throw;
    } catch (const InputError& error) {
        results.assign(reads.size(), {std::string(error.what()), {}});
    }
    return results;
}

TextureLoader::Key TextureLoader::keyOf(const Source& source, const std::string& what) {
    if (!source.image) return {(source.namedBy.parent_path() / source.label).string(), what};
    if (!source.image->bytes) return {source.image->name.string(), what};
    const std::string& bytes = *source.image->bytes;
    return {"/" + std::to_string(bytes.size()) + "/" +
                std::to_string(contentHash(std::as_bytes(std::span(bytes)))),
            what};
}

void TextureLoader::warn(WarningKind kind, const Source& source, const std::string& what) {
    report_.warn(kind, source.namedBy, source.line, "texture " + inQuotes(source.label) + what);
}

/// What is read of the image; nothing where that is not possible, which is warned of once.
const TextureLoader::Result& TextureLoader::load(const Key& key, const Source& source,
                                                 const Read& read, Numbers numbers) {
    const auto [entry, isNew] = loaded_.try_emplace(key);
    Result& result = entry->second;
    if (announcing_) {
        if (isNew && source.image) announced_.push_back({key, *source.image, read});
        return result;
    }
    if (isNew && !source.image) warn(WarningKind::unusableTexture, source, " not found");
    if (isNew && source.image) {
        const auto ahead = ahead_.extract(key);
        result =
            ahead ? std::move(ahead.mapped()) : std::move(this->read(*source.image, {&read, 1})[0]);
        if (const auto* error = std::get_if<std::string>(&result.value))
            warn(WarningKind::unusableTexture, source, ": " + *error);
    }
    noteNumbers(source, result, numbers);
    return result;
}

/// Warns of what the first use shows that is taken for other numbers, all in one line.
void TextureLoader::noteNumbers(const Source& source, Result& result, Numbers numbers) {
    std::string text = std::exchange(result.fault, {});
    if (numbers == Numbers::unit && !std::exchange(result.isUnit, true)) {
        TexelRange range;
        if (const auto* colours = std::get_if<Texture>(&result.value)) range = colours->range();
        if (const auto* data = std::get_if<ScalarTexture>(&result.value)) range = data->range();
        if (range.least < 0.0f || range.largest > 1.0f) {
            char beyond[128];
            std::snprintf(beyond, sizeof beyond,
                          "%shas numbers from %g to %g: those below 0 are taken for 0, those "
                          "above 1 for 1",
                          text.empty() ? "" : "; ", (double) range.least, (double) range.largest);
            text += beyond;
        }
    }
    if (!text.empty()) warn(WarningKind::unusableValue, source, ": " + text);
}

template <typename T>
uint32_t TextureLoader::place(const Source& source, const std::string& what,
                              const TextureSampling& sampling, std::vector<T>& textures,
                              const Read& read, Numbers numbers) {
    const Key key = keyOf(source, what);
    const auto* const texture = std::get_if<T>(&load(key, source, read, numbers).value);
    if (!texture) return kNoTexture;
    const auto [entry, isNew] =
        places_.try_emplace({key, exactText(sampling)}, (uint32_t) textures.size());
    if (isNew) textures.push_back(texture->with(sampling));
    return entry->second;
}

uint32_t TextureLoader::colour(const Source& source, const TextureSampling& sampling,
                               TexelEncoding encoding, Numbers numbers) {
    const bool isLinear = encoding == TexelEncoding::linear;
    const Read read = [isLinear](const DecodedImage& image) {
        return isLinear ? readDataTexture(image) : readTexture(image);
    };
    return place(source, isLinear ? "linear colour" : "colour", sampling, scene_.textures, read,
                 numbers);
}

uint32_t TextureLoader::data(const Source& source, const TextureSampling& sampling,
                             ImageChannel channel, Numbers numbers) {
    const Read read = [channel](const DecodedImage& image) {
        return readScalarTexture(image, channel);
    };
    return place(source, "data " + std::to_string((int) channel), sampling, scene_.scalarTextures,
                 read, numbers);
}

uint32_t TextureLoader::reflectance(const Source& source, const TextureSampling& sampling,
                                    TexelEncoding encoding) {
    return colour(source, sampling, encoding, Numbers::unit);
}

uint32_t TextureLoader::part(const Source& source, const TextureSampling& sampling,
                             ImageChannel channel) {
    return data(source, sampling, channel, Numbers::unit);
}

TextureLoader::Relief TextureLoader::relief(const Source& source, const TextureSampling& sampling,
                                            ImageChannel channel) {
    const std::string what = "relief " + std::to_string((int) channel);
    const Read read = [channel](const DecodedImage& image) -> Value {
        if (isNormalMap(image)) return readDataTexture(image);
        return readScalarTexture(image, channel);
    };
    return {place(source, what, sampling, scene_.scalarTextures, read, Numbers::any),
            place(source, what, sampling, scene_.textures, read, Numbers::any)};
}

uint32_t TextureLoader::alpha(const Source& source, float limit, const TextureSampling& sampling) {
    const Read read = [](const DecodedImage& image) -> Value {
        auto alpha = readAlpha(image);
        if (!alpha) return {};
        return std::move(*alpha);
    };
    const Result& loaded = load(keyOf(source, "alpha"), source, read, Numbers::any);
    const auto* const alpha = std::get_if<ScalarTexture>(&loaded.value);
    if (!alpha || !cutsOut(*alpha, limit)) return kNoTexture;
    return place(source, "alpha", sampling, scene_.scalarTextures, read, Numbers::any);
}

} // namespace dirt
