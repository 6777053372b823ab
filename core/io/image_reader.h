#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include <OpenImageIO/imageio.h>

namespace dirt {

/// An image file's bytes, opened by the one reader that the first of them call for.
class ImageReader {
public:
    /// \p name is for messages. Throws InputError ("file: what is wrong") where the bytes are of no
    /// format that is read, the header is damaged or absurd, or it claims more than so few bytes
    /// can hold.
    ImageReader(std::string bytes, std::filesystem::path name)
        : ImageReader(std::make_shared<std::string>(std::move(bytes)), std::move(name)) {}
    ImageReader(std::shared_ptr<const std::string> bytes, std::filesystem::path name);
    ~ImageReader();
    ImageReader(const ImageReader&) = delete;
    ImageReader& operator=(const ImageReader&) = delete;

    const OIIO::ImageSpec& spec() const;
    const std::filesystem::path& name() const { return name_; }

    /// The channels [\p first, \p end) of every texel, the first row on top, alpha not multiplied
    /// onto the others. Throws InputError where the file is damaged.
    void read(int first, int end, OIIO::TypeDesc type, void* texels);

private:
    class Source;
    class PngSource;
    class OtherSource;

    void checkHeader(uint64_t samplesPerByte) const;

    std::filesystem::path name_;
    std::shared_ptr<const std::string> bytes_;
    std::unique_ptr<Source> source_;
};

} // namespace dirt
