#pragma once

#include "core/io/gltf.h"
#include "core/io/load.h"
#include "tests/io/gltf_writer.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>

namespace dirt {

using test::GltfWriter;
using test::Json;

class Gltf : public testing::Test {
protected:
    LoadedScene load(const GltfWriter& writer) {
        return loadScene(folder_.write("a.gltf", writer.embedded()));
    }
    /// The error's text after the file's name.
    std::string error(const std::string& name, const std::string& content) {
        const std::string file = folder_.write(name, content);
        const std::string what = inputError([&] { loadScene(file); });
        EXPECT_EQ(what.find_first_of("\r\n"), what.npos) << what;
        return what.rfind(file, 0) == 0 ? what.substr(file.size()) : what;
    }
    /// Of a file with one triangle that \p damage spoils.
    std::string errorOf(const std::function<void(GltfWriter&)>& damage) {
        GltfWriter writer;
        writer.triangle();
        damage(writer);
        return error("a.gltf", writer.embedded());
    }
    /// The bytes of a PNG or JPEG file of one colour.
    std::string image(const std::string& name, unsigned char r, unsigned char g, unsigned char b) {
        std::vector<uint8_t> texels;
        for (int i = 0; i < 64; ++i) texels.insert(texels.end(), {r, g, b});
        return test::readFile(test::writeImage(folder_ / name, 8, 8, 3, texels));
    }
    /// A PNG file of 8x8 texels, the left half of the one colour, the right of the other.
    void twoColours(const std::string& name, std::array<unsigned char, 4> left,
                    std::array<unsigned char, 4> right) {
        std::vector<uint8_t> texels;
        for (int i = 0; i < 64; ++i) {
            const auto& colour = i % 8 < 4 ? left : right;
            texels.insert(texels.end(), colour.begin(), colour.end());
        }
        test::writeImage(folder_ / name, 8, 8, 4, texels);
    }
    /// A triangle whose material has \p image as its base colour.
    static GltfWriter textured(const Json& image) {
        GltfWriter writer;
        writer.triangle();
        writer.json["images"] = Json::array({image});
        writer.json["textures"] = Json::array({{{"source", 0}}});
        writer.json["materials"] =
            Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}});
        writer.json["meshes"][0]["primitives"][0]["material"] = 0;
        return writer;
    }

    test::TemporaryFolder folder_;
};

} // namespace dirt
