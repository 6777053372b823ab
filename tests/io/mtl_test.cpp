#include "core/io/mtl.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dirt {
namespace {

class Mtl : public testing::Test {
protected:
    std::vector<MtlMaterial> read(const std::string& text) {
        return readMtl(folder_.write("test.mtl", text), report_);
    }
    std::string mapOf(const std::string& arguments) {
        return read("newmtl a\nmap_Kd " + arguments + "\n").at(0).diffuse.file;
    }
    std::string error(const std::string& text) {
        const std::string file = folder_.write("test.mtl", text);
        const std::string what = inputError([&] { readMtl(file, report_); });
        return what.empty() ? what : what.substr(file.size());
    }

    test::TemporaryFolder folder_;
    LoadReport report_;
};

TEST_F(Mtl, ReadsColoursAndTexture) {
    const auto materials = read("# comment\nnewmtl first one \n\tKd 0.1 0.2 0.3\r\n\tKe 1 2 30\n"
                                "newmtl\nKd 0.5 # grey\n map_Kd maps\\wood 1.png \n");
    ASSERT_EQ(materials.size(), 2u);
    EXPECT_EQ(materials[0].name, "first one");
    EXPECT_EQ(materials[0].material.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(materials[0].material.emission, glm::vec3(1, 2, 30));
    EXPECT_EQ(materials[0].diffuse.file, "");
    EXPECT_EQ(materials[1].name, "");
    EXPECT_EQ(materials[1].material.diffuse, glm::vec3(0.5f));
    EXPECT_EQ(materials[1].diffuse.file, "maps\\wood 1.png");
    EXPECT_EQ(materials[1].diffuse.line, 7u);
    EXPECT_TRUE(report_.ignored().empty());
}

TEST_F(Mtl, ReadsGlossAndItsTextures) {
    const auto materials = read("newmtl a\nKs 0.25 0.5 1\n Ns 63.5\nmetallic 1.0\nd 0.25\n"
                                "map_Ks maps\\s.jpg\nmap_Ke e.png\nmap_d d.png\n"
                                "bump other.png\nmap_bump -bm -0.5 b.png\nnewmtl b\nKs 2\n"
                                "Ns 900\nmetallic 7\nd -halo 1.5\nnewmtl c\n");
    ASSERT_EQ(materials.size(), 3u);
    const MtlMaterial& a = materials[0];
    EXPECT_EQ(a.material.reflectance, 0.25f);
    EXPECT_EQ(a.material.roughness, 0.5f);
    EXPECT_EQ(a.material.metallic, 1.0f);
    EXPECT_EQ(a.material.opacity, 0.25f);
    EXPECT_EQ(a.material.bumpScale, -0.5f);
    EXPECT_EQ(a.reflectance.file, "maps\\s.jpg");
    EXPECT_EQ(a.emission.file, "e.png");
    EXPECT_EQ(a.opacity.file, "d.png");
    EXPECT_EQ(a.bump.file, "b.png");
    EXPECT_EQ(a.bump.line, 10u);
    EXPECT_EQ(materials[1].material.reflectance, 1.0f);
    EXPECT_EQ(materials[1].material.roughness, 0.0f);
    EXPECT_EQ(materials[1].material.metallic, 1.0f);
    EXPECT_EQ(materials[1].material.opacity, 1.0f);
    EXPECT_EQ(materials[2].material.reflectance, 0.0f);
    EXPECT_EQ(materials[2].material.roughness, 1.0f);
    EXPECT_EQ(materials[2].bump.file, "");
    EXPECT_TRUE(report_.ignored().empty());
}

TEST_F(Mtl, NamesAreLookedUpAsTheyAreAndShownAsUtf8) {
    const auto materials = read("newmtl d\xfcster\n");
    EXPECT_EQ(materials.at(0).name, "d\xfcster");
    EXPECT_EQ(materials.at(0).material.name, "d?ster");
}

TEST_F(Mtl, SkipsTheOptionsOfTextures) {
    EXPECT_EQ(mapOf("-s 2 3 4 a.png"), "a.png");
    EXPECT_EQ(mapOf("-s 2 a.png"), "a.png");
    EXPECT_EQ(mapOf("-o 0.5 1 my file.png"), "my file.png");
    EXPECT_EQ(mapOf("-bm 0.2 -clamp on -imfchan r a b.png"), "a b.png");
    EXPECT_EQ(mapOf("-mm 0 1 -blendu off -texres 512 -t 1 1 1 a.png"), "a.png");
    EXPECT_EQ(mapOf("-my-own.png"), "-my-own.png");
    EXPECT_EQ(mapOf("7.png"), "7.png");
    EXPECT_EQ(report_.ignored().front(), "MTL map_Kd -s");
}

TEST_F(Mtl, ListsKeysWithoutEffectOnce) {
    read("newmtl a\nNi 1.5\nunheard of\nnewmtl b\nNi 1\n");
    EXPECT_EQ(report_.ignored(), (std::vector<std::string>{"MTL Ni", "MTL unheard"}));
}

TEST_F(Mtl, RefusesMalformedColours) {
    EXPECT_EQ(error("newmtl a\nKd 1 x 1\n"), ":2: malformed number 'x' in Kd");
    EXPECT_EQ(error("newmtl a\nKd 1 1\n"), ":2: Kd needs three numbers");
    EXPECT_EQ(error("newmtl a\n\nKe\n"), ":3: Ke needs three numbers");
    EXPECT_EQ(error("newmtl a\nNs x\n"), ":2: malformed number 'x' in Ns");
    EXPECT_EQ(error("newmtl a\nmetallic -1\n"), ":2: metallic must be finite and not negative");
    EXPECT_EQ(error("newmtl a\nbump -bm x a.png\n"), ":2: malformed number 'x' in bump -bm");
    for (const char* number : {"nan", "inf", "-0.1", "1e39"})
        EXPECT_EQ(error(std::string("newmtl a\nKe 1 1 ") + number + "\n"),
                  ":2: Ke must be finite and not negative")
            << number;
}

} // namespace
} // namespace dirt
