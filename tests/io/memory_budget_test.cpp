// What small files claim is refused before memory is taken, in one line that says what asks for
// how much of how much.

#include "core/io/image.h"
#include "core/io/load.h"
#include "core/io/memory_budget.h"
#include "tests/io/gltf_writer.h"
#include "tests/io/input_error.h"
#include "tests/support/counted_memory.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

constexpr uint64_t kMega = 1'000'000;

TEST(MemoryBudget, CountsWhatIsTakenAndGivenBack) {
    const MemoryBudget budget(100 * kMega), copy = budget;
    {
        MemoryClaim claim(budget);
        claim.take(60 * kMega, "a.obj", "the file");
        EXPECT_EQ(copy.left(), 40 * kMega);
        EXPECT_EQ(inputError([&] { claim.take(41 * kMega, "a.obj", "the model"); }),
                  "a.obj: the model needs 41 MB of memory; 40 MB of 100 MB are left");
        claim.take(40 * kMega, "a.obj", "the model");
        MemoryClaim moved = std::move(claim);
        EXPECT_EQ(copy.taken(), 100 * kMega);
    }
    EXPECT_EQ(copy.taken(), 0u);
    copy.spend(30 * kMega, "a.png", "an image");
    EXPECT_EQ(budget.taken(), 30 * kMega);
    EXPECT_EQ(inputError([&] { copy.spend(~uint64_t(0), "a.png", "an image"); }).substr(0, 40),
              "a.png: an image needs 18446744073.7 GB o");
}

TEST(MemoryBudget, WithoutALimitNothingIsCounted) {
    MemoryClaim claim;
    claim.take(~uint64_t(0), "a.obj", "the file");
    claim.take(~uint64_t(0), "a.obj", "the file");
    EXPECT_EQ(claim.budget().taken(), 0u);
}

class Amplified : public testing::Test {
protected:
    /// One line, and next to nothing was allocated.
    void expectRefusal(const std::string& file, const std::string& says,
                       uint64_t limit = 1000 * kMega, int64_t most = 40 * (int64_t) kMega) {
        LoadOptions options;
        options.memory = MemoryBudget(limit);
        std::string error;
        const int64_t peak =
            peakOf([&] { error = inputError([&] { loadScene(folder_ / file, options); }); });
        EXPECT_NE(error.find(says), error.npos) << error;
        EXPECT_EQ(error.rfind(folder_ / file, 0), 0u) << error;
        EXPECT_EQ(error.find('\n'), error.npos);
        EXPECT_LT(peak, most);
        EXPECT_LE(options.memory.taken(), limit);
    }

    static Json zeros(uint64_t count) {
        return {{"componentType", 5126}, {"count", count}, {"type", "VEC3"}};
    }
    std::string writeGltf(GltfWriter& writer, const std::string& name = "a.gltf") {
        folder_.write("a.bin", writer.bytes);
        writer.json["buffers"].push_back({{"uri", "a.bin"}, {"byteLength", writer.bytes.size()}});
        folder_.write(name, writer.json.dump());
        return name;
    }

    TemporaryFolder folder_;
};

TEST_F(Amplified, AccessorsWithoutData) {
    // A mesh that 300 nodes place, and one of 2000 primitives.
    GltfWriter nodes;
    nodes.json["accessors"].push_back(zeros(262143));
    nodes.mesh({{"attributes", {{"POSITION", 0}}}});
    for (int i = 0; i < 300; ++i) nodes.node({{"mesh", 0}});
    expectRefusal(writeGltf(nodes), "accessors[0] has no data and 262143 elements");

    GltfWriter primitives;
    primitives.json["accessors"].push_back(zeros(3999));
    primitives.mesh({{"attributes", {{"POSITION", 0}}}});
    for (int i = 0; i < 2000; ++i)
        primitives.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}});
    expectRefusal(writeGltf(primitives), "accessors[0] has no data and 3999 elements");

    // Where few are replaced.
    GltfWriter sparse;
    const size_t places = sparse.view(std::string(4, '\0')),
                 values = sparse.view(std::string(12, '\0'));
    sparse.json["accessors"].push_back(zeros(4'000'000'000));
    sparse.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", places}, {"componentType", 5125}}},
        {"values", {{"bufferView", values}}}};
    sparse.mesh({{"attributes", {{"POSITION", 0}}}});
    sparse.node({{"mesh", 0}});
    expectRefusal(writeGltf(sparse), "accessors[0] has no data and 4000000000 elements");

    // What places a mesh.
    GltfWriter instances;
    const size_t triangle = instances.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    instances.json["accessors"].push_back(zeros(262143));
    instances.mesh({{"attributes", {{"POSITION", triangle}}}});
    instances.node(
        {{"mesh", 0},
         {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", 1}}}}}}}});
    expectRefusal(writeGltf(instances), "accessors[1] has no data and 262143 elements");
}

TEST_F(Amplified, MeshesPlacedOftenAreCountedBeforeTheyArePlaced) {
    std::vector<float> positions;
    for (int i = 0; i < 29'997; ++i) positions.push_back((float) (i % 1000));
    GltfWriter writer;
    writer.mesh({{"attributes", {{"POSITION", writer.vec3(positions)}}}});
    for (int i = 0; i < 10'000; ++i) writer.node({{"mesh", 0}});
    expectRefusal(writeGltf(writer),
                  "each of 33330000 triangles, as often as it is placed, needs ");

    std::string obj;
    for (int i = 0; i < 3000; ++i) obj += "v " + std::to_string(i) + " 0 0\n";
    for (int i = 0; i < 3000; ++i) obj += "f 1 2 " + std::to_string(1 + i) + "\n";
    folder_.write("a.obj", obj);
    std::string scene = "<world>";
    for (int i = 0; i < 10'000; ++i) scene += "<object file=\"a.obj\"/>";
    folder_.write("a.scene", scene + "</world>");
    LoadOptions options;
    options.memory = MemoryBudget(1000 * kMega);
    const std::string error = inputError([&] { loadScene(folder_ / "a.scene", options); });
    EXPECT_NE(error.find("each of 3000 triangles, as often as it is placed, needs "), error.npos)
        << error;
    EXPECT_NE(error.find("of 1.0 GB are left"), error.npos) << error;
}

TEST_F(Amplified, OneMeshOfManyPrimitivesThatShareTheirData) {
    std::vector<float> positions(29'997, 1.0f);
    GltfWriter writer;
    const size_t accessor = writer.vec3(positions);
    writer.mesh({{"attributes", {{"POSITION", accessor}}}});
    for (int i = 0; i < 20'000; ++i)
        writer.json["meshes"][0]["primitives"].push_back(
            {{"attributes", {{"POSITION", accessor}}}});
    writer.node({{"mesh", 0}});
    expectRefusal(writeGltf(writer), "needs ", 60 * kMega, 80 * (int64_t) kMega);
}

TEST_F(Amplified, BuffersThatNameOneFileAndImagesThatShareAView) {
    folder_.write("big.bin", std::string(4 * kMega, 'x'));
    GltfWriter writer;
    writer.mesh({{"attributes", {{"POSITION", writer.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
    writer.node({{"mesh", 0}});
    writeGltf(writer);
    for (int i = 0; i < 1000; ++i)
        writer.json["buffers"].push_back({{"uri", "big.bin"}, {"byteLength", 4 * kMega}});
    folder_.write("a.gltf", writer.json.dump());
    LoadOptions options;
    options.memory = MemoryBudget(30 * kMega);
    EXPECT_NE(inputError([&] {
                  loadScene(folder_ / "a.gltf", options);
              }).find("big.bin: the file needs 4 MB of memory"),
              std::string::npos);

    // A hundred images of one view, and as many materials: decoded once.
    const std::vector<uint8_t> white(1000 * 1000 * 3, 255);
    writePng(folder_ / "white.png", 1000, 1000, white, {});
    GltfWriter images;
    const size_t view = images.view(readFile(folder_ / "white.png"));
    const size_t triangle = images.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    for (int i = 0; i < 100; ++i) {
        images.json["images"].push_back({{"bufferView", view}, {"mimeType", "image/png"}});
        images.json["textures"].push_back({{"source", i}});
        images.json["materials"].push_back(
            {{"pbrMetallicRoughness",
              {{"baseColorTexture", {{"index", i}}},
               {"baseColorFactor", {0.5 + i * 0.001, 1.0, 1.0, 1.0}}}}});
        const size_t mesh =
            images.mesh({{"attributes", {{"POSITION", triangle}}}, {"material", i}});
        images.node({{"mesh", mesh}});
    }
    writeGltf(images);
    options.memory = MemoryBudget(40 * kMega);
    const LoadedScene loaded = loadScene(folder_ / "a.gltf", options);
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(loaded.scene.materials.size(), 100u);
    EXPECT_EQ(loaded.scene.textures.size(), 1u);
}

TEST_F(Amplified, AnImageIsChargedBeforeItIsDecoded) {
    writePng(folder_ / "a.png", 4000, 4000, std::vector<uint8_t>(4000 * 4000 * 3, 7), {});
    folder_.write("a.mtl", "newmtl a\nmap_Kd a.png\n");
    folder_.write("a.obj", "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                           "f 1/1 2/1 3/1\n");
    LoadOptions options;
    options.memory = MemoryBudget(80 * kMega);
    std::string error;
    EXPECT_LT(peakOf([&] { error = inputError([&] { loadScene(folder_ / "a.obj", options); }); }),
              40 * (int64_t) kMega);
    EXPECT_EQ(error, (folder_ / "a.png") + ": an image of 4000x4000 texels needs 96 MB of memory; "
                                           "80 MB of 80 MB are left");
    options.memory = MemoryBudget(200 * kMega);
    EXPECT_EQ(loadScene(folder_ / "a.obj", options).scene.textures.size(), 1u);
    // Only what is kept is still taken: the texture, and three vertices.
    EXPECT_LT(options.memory.taken(), 49 * kMega);
    EXPECT_GE(options.memory.taken(), 48 * kMega);
}

TEST_F(Amplified, TextIsChargedByWhatBecomesOfIt) {
    std::string materials, elements, faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 100'000; ++i) {
        materials += "newmtl\n";
        elements += "<a/>";
        faces += "f 1 2 3\n";
    }
    folder_.write("a.mtl", materials);
    folder_.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder_.write("b.obj", faces);
    folder_.write("a.scene", "<world>" + elements + "</world>");
    folder_.write("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"extras\":[" +
                                std::string(1'000'000, '[') + std::string(1'000'000, ']') + "]}");
    LoadOptions options;
    for (const auto& [file, says] :
         {std::pair{"a.obj", "a.mtl: the list of materials needs "},
          std::pair{"b.obj", "b.obj: the model needs "}, std::pair{"a.scene", "its XML needs "},
          std::pair{"a.gltf", "its JSON needs "}}) {
        options.memory = MemoryBudget(10 * kMega);
        const std::string error = inputError([&] { loadScene(folder_ / file, options); });
        EXPECT_NE(error.find(says), error.npos) << error;
    }
}

TEST_F(Amplified, HeadersThatClaimMoreThanTheFileHoldsAreDamaged) {
    folder_.write("a.hdr",
                  std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n\0", 54));
    std::string header("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x40\0\0\0\x40\0\x10\2\0\0\0", 29);
    folder_.write("a.png", header + std::string(300, '\0'));
    folder_.write("a.pfm", "PF\n16384 16384\n-1.0\n");
    folder_.write("a.ppm", "P6\n16384 16384\n255\n");
    for (const char* name : {"a.hdr", "a.png", "a.pfm", "a.ppm"}) {
        folder_.write("a.mtl", "newmtl a\nmap_Kd " + std::string(name) + "\n");
        folder_.write("a.obj", "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        LoadedScene loaded;
        EXPECT_LT(peakOf([&] { loaded = loadScene(folder_ / "a.obj"); }), 10 * (int64_t) kMega);
        EXPECT_EQ(loaded.warnings.size(), 1u) << name;
    }
}

} // namespace
} // namespace dirt::test
