// OpenEXR files that claim more than they are long: refused before the library takes memory for it.

#include "core/io/exr_header.h"
#include "core/io/image.h"
#include "core/io/read_exr_parts.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <cstdint>
#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace dirt {
namespace {

std::string number(uint64_t value, size_t bytes = 4) {
    std::string text(bytes, '\0');
    std::memcpy(text.data(), &value, bytes);
    return text;
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value,
                      uint32_t size) {
    return name + '\0' + type + '\0' + number(size) + value;
}
std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
    return attribute(name, type, value, (uint32_t) value.size());
}

std::string box(int32_t right, int32_t bottom) {
    return number(0) + number(0) + number((uint32_t) right) + number((uint32_t) bottom);
}

/// Mark and version, attributes, their end, and a table of \p offsets.
std::string file(const std::string& attributes, size_t offsets = 1, uint32_t version = 2) {
    return "\x76\x2f\x31\x01" + number(version) + attributes + '\0' + std::string(8 * offsets, 'o');
}

TEST(ExrHeader, OurOwnFilesAreSound) {
    const test::TemporaryFolder folder;
    const std::string flat = (folder.path() / "a.exr").string(),
                      parts = (folder.path() / "b.exr").string();
    writeExr(flat, Image{3, 500, std::vector<glm::vec3>(1500)}, {{"dirt:scene", "a"}});
    EXPECT_EQ(exrHeaderFault(test::readFile(flat)), std::nullopt);
    const DeepExrPart part{"one", 1, 2, {{"id", ExrChannel::Type::uint32}}, {1, 0}, {7}};
    const DeepExrPart both[] = {part, {"two", 1, 2, part.channels, {0, 0}, {}}};
    writeExr(parts, std::span(both), {});
    EXPECT_EQ(exrHeaderFault(test::readFile(parts)), std::nullopt);
}

TEST(ExrHeader, WhatEndsTooEarlyIsSaid) {
    const std::string whole =
        file(attribute("owner", "string", "me") + attribute("dataWindow", "box2i", box(0, 255)));
    EXPECT_EQ(exrHeaderFault(whole), std::nullopt);
    for (size_t length = 4; length < whole.size(); ++length)
        EXPECT_TRUE(exrHeaderFault(whole.substr(0, length))) << length;
}

TEST(ExrHeader, ClaimsAreHeldAgainstTheFile) {
    const auto fails = [](const std::string& bytes, const char* why) {
        const auto fault = exrHeaderFault(bytes);
        ASSERT_TRUE(fault) << why;
        EXPECT_NE(fault->find(why), std::string::npos) << *fault;
    };
    fails(file(attribute("owner", "string", "me", 0x40000000)), "ends within an attribute");
    fails(file(attribute("owner", "string", "me", 0xffffffff)), "ends within an attribute");
    fails(file(std::string(300, 'n') + '\0'), "name without end");
    fails(file(attribute("a", "stringvector", number(2) + "me" + number(0x7fffffff))), "texts");
    fails(file(attribute("preview", "preview", number(30000) + number(30000) + "rgba")), "texels");
    fails(file(attribute("idManifest", "idmanifest", number(1) + number(1ull << 40, 8) + "z")),
          "names");
    fails(file(attribute("dataWindow", "box2i", box(0, 256))), "chunks");
    fails(file(attribute("dataWindow", "box2i", box(1 << 20, 1 << 20)) +
               attribute("tiles", "tiledesc", number(1) + number(1) + '\0')),
          "chunks");
    // So are those of the second part.
    const uint32_t severalParts = 0x1002;
    const std::string first = attribute("dataWindow", "box2i", box(0, 255)) + '\0';
    EXPECT_EQ(exrHeaderFault(file(first + first, 1, severalParts)), std::nullopt);
    fails(file(first + attribute("owner", "string", "me", 0x40000000) + '\0', 1, severalParts),
          "ends within an attribute");
}

TEST(ExrHeader, EveryReaderAsks) {
    const test::TemporaryFolder folder;
    const std::string path =
        folder.write("a.exr", file(attribute("owner", "string", "me", 0x40000000)));
    const std::string wanted = path + ": damaged image: ends within an attribute of its header";
    EXPECT_EQ(inputError([&] { readImage(path); }), wanted);
    EXPECT_EQ(inputError([&] { readMetadata(path); }), wanted);
    EXPECT_EQ(inputError([&] { readExrParts(path); }), wanted);
}

} // namespace
} // namespace dirt
