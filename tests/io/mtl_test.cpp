// MTL files as they are written. What their materials mean is in mtl_material_test.cpp.

#include "core/io/mtl.h"
#include "shaders/shared/radiance.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dirt {
namespace {

using Strings = std::vector<std::string>;

class Mtl : public testing::Test {
protected:
    MtlFile readFile(const std::string& text) { return readMtl(folder_.write("test.mtl", text)); }
    std::vector<MtlMaterial> read(const std::string& text) { return readFile(text).materials; }
    /// The texture statement of one material with that line.
    MtlMap map(const std::string& line, MtlUse use) {
        return read("newmtl a\n" + line + "\n").at(0).map(use);
    }
    std::string mapOf(const std::string& arguments) {
        return map("map_Kd " + arguments, MtlUse::diffuse).file;
    }
    /// "line: message" of each fault.
    Strings faults(const std::string& text) {
        Strings texts;
        for (const Fault& fault : readFile(text).faults)
            texts.push_back(std::to_string(fault.line) + ": " + fault.message);
        return texts;
    }

    test::TemporaryFolder folder_;
};

TEST_F(Mtl, ReadsColoursAndTexture) {
    const MtlFile file = readFile("# comment\nnewmtl first one \n\tKd 0.1 0.2 0.3\r\n\tKe 1 2 30\n"
                                  "newmtl\nKd 0.5 # grey\n map_Kd maps\\wood 1.png \n");
    const auto& materials = file.materials;
    ASSERT_EQ(materials.size(), 2u);
    EXPECT_EQ(materials[0].name, "first one");
    EXPECT_EQ(materials[0].line, 2u);
    EXPECT_EQ(materials[0].diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(materials[0].emission, glm::vec3(1, 2, 30));
    EXPECT_EQ(materials[0].specular, std::nullopt);
    EXPECT_EQ(materials[0].map(MtlUse::diffuse).file, "");
    EXPECT_EQ(materials[1].name, "");
    EXPECT_EQ(materials[1].diffuse, glm::vec3(0.5f));
    EXPECT_EQ(materials[1].map(MtlUse::diffuse).file, "maps\\wood 1.png");
    EXPECT_EQ(materials[1].map(MtlUse::diffuse).line, 7u);
    EXPECT_TRUE(file.others.empty());
    EXPECT_TRUE(file.faults.empty());
}

TEST_F(Mtl, ReadsEveryKey) {
    const MtlFile file =
        readFile("newmtl a\nKa .1 .2 .3\nKs 0.25 0.5 1\nNs 63.5\nd -halo 0.25\nTr 0.75\n"
                 "metallic 1\nPr .5\nPm 1\nillum 3\nmap_Ks s.png\nmap_Ke e.png\nmap_Ns n.png\n"
                 "map_d d.png\nbump other.png\nmap_bump -bm -0.5 b.png\nnorm k.png\n"
                 "map_Pr r.png\nmap_Pm m.png\n");
    const MtlMaterial& a = file.materials.at(0);
    EXPECT_EQ(a.ambient, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(a.specular, glm::vec3(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(a.exponent, 63.5f);
    EXPECT_EQ(a.opacity, 0.25f);
    EXPECT_EQ(a.opacityLine, 5u);
    EXPECT_EQ(a.transparency, 0.75f);
    EXPECT_EQ(a.metallic, 1.0f);
    EXPECT_TRUE(file.saysMetallic());
    EXPECT_EQ(a.roughness, 0.5f);
    EXPECT_EQ(a.metalness, 1.0f);
    EXPECT_EQ(a.illumination, 3);
    EXPECT_EQ(a.bumpScale, -0.5f);
    const char* files[] = {"",      "e.png", "s.png", "n.png", "d.png",
                           "b.png", "k.png", "r.png", "m.png"};
    for (size_t use = 0; use < a.maps.size(); ++use) EXPECT_EQ(a.maps[use].file, files[use]);
    EXPECT_EQ(a.map(MtlUse::bump).line, 16u);
    EXPECT_EQ(a.map(MtlUse::bump).key, "map_bump");
    EXPECT_TRUE(file.others.empty());
    EXPECT_FALSE(readFile("newmtl metallic\nKs 1\n").saysMetallic());
    EXPECT_EQ(map("map_Kn n.png", MtlUse::normal).file, "n.png");
}

TEST_F(Mtl, TakesKeysInAnyLetterCase) {
    const MtlMaterial a = read("NewMTL a\nkd 1 0 0\nNS 5\nTR 0\nMAP_KD a.png\nmap_Bump b.png\n"
                               "ILLUM 2.0\nNorm -BM 2 n.png\n")
                              .at(0);
    EXPECT_EQ(a.diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(a.exponent, 5.0f);
    EXPECT_EQ(a.transparency, 0.0f);
    EXPECT_EQ(a.illumination, 2);
    EXPECT_EQ(a.map(MtlUse::diffuse).file, "a.png");
    EXPECT_EQ(a.map(MtlUse::bump).file, "b.png");
    EXPECT_EQ(a.map(MtlUse::normal).strength, 2.0f);
}

TEST_F(Mtl, KeepsNamesAsTheyAre) {
    EXPECT_EQ(read("newmtl d\xfcster\n").at(0).name, "d\xfcster");
}

TEST_F(Mtl, TellsOptionsFromFileNames) {
    EXPECT_EQ(mapOf("-s 2 3 4 a.png"), "a.png");
    EXPECT_EQ(mapOf("-s 2 a.png"), "a.png");
    EXPECT_EQ(mapOf("-o 0.5 1 my file.png"), "my file.png");
    EXPECT_EQ(mapOf("-bm 0.2 -clamp on -imfchan r a b.png"), "a b.png");
    EXPECT_EQ(mapOf("-mm 0 1 -blendu off -texres 512 -t 1 1 1 a.png"), "a.png");
    EXPECT_EQ(mapOf("-my-own.png"), "-my-own.png");
    EXPECT_EQ(mapOf("7.png"), "7.png");
    EXPECT_EQ(mapOf("-clamp on \"my file.png\""), "my file.png");
    EXPECT_EQ(mapOf("-clamp on"), "");
    EXPECT_EQ(mapOf("-s"), "");
}

TEST_F(Mtl, ReadsTheOptionsOfTextures) {
    const MtlMap all = map("map_Pr -s 2 3 4 -o 0.5 -0.25 -clamp on -imfchan G -colorspace linear "
                           "r.png",
                           MtlUse::roughness);
    EXPECT_EQ(all.file, "r.png");
    EXPECT_EQ(all.scale, glm::vec2(2, 3));
    EXPECT_EQ(all.offset, glm::vec2(0.5f, -0.25f));
    EXPECT_TRUE(all.clamps);
    EXPECT_EQ(all.channel, 'g');
    EXPECT_TRUE(all.isLinear);
    const MtlMap one = map("map_Kd -s 2 -o 1 -clamp off -colorspace sRGB a.png", MtlUse::diffuse);
    EXPECT_EQ(one.scale, glm::vec2(2, 1));
    EXPECT_EQ(one.offset, glm::vec2(1, 0));
    EXPECT_FALSE(one.clamps);
    EXPECT_FALSE(one.isLinear);
    EXPECT_TRUE(map("map_Ke -colorspace LINEAR a.png", MtlUse::emission).isLinear);
    const MtlMap none = map("map_d a.png", MtlUse::opacity);
    EXPECT_EQ(none.scale, glm::vec2(1, 1));
    EXPECT_EQ(none.offset, glm::vec2(0, 0));
    EXPECT_EQ(none.channel, 0);
    EXPECT_FALSE(none.isLinear);
    EXPECT_EQ(none.strength, std::nullopt);
}

TEST_F(Mtl, ListsWhatHasNoEffectOnce) {
    const MtlFile file = readFile(
        "Kd 1 1 1\nnewmtl a\nNi 1.5\nunheard of\nnewmtl b\nNi 1\nmap_Kd -blendu off -mm 0 1 "
        "-imfchan r -bm 2 a.png\nmap_Pr -imfchan z -colorspace acescg -type sphere b.png\n"
        "norm -colorspace sRGB -imfchan r n.png\n");
    EXPECT_EQ(file.others,
              (Strings{"Kd", "Ni", "unheard", "map_Kd -blendu", "map_Kd -mm", "map_Kd -imfchan",
                       "map_Kd -bm", "map_Pr -imfchan z", "map_Pr -colorspace acescg",
                       "map_Pr -type", "norm -colorspace sRGB", "norm -imfchan"}));
    EXPECT_EQ(file.materials[0].diffuse, std::nullopt);
}

/// A model is not refused for a number of its materials.
TEST_F(Mtl, CountsValuesThatCannotBe) {
    const std::string gone = " counts as not there";
    EXPECT_EQ(faults("newmtl a\nKd 1 x 1\n"), Strings{"2: malformed number 'x' in Kd; Kd" + gone});
    EXPECT_EQ(faults("newmtl a\nKd 1 1\n"), Strings{"2: Kd needs three numbers; Kd" + gone});
    EXPECT_EQ(faults("newmtl a\n\nKe\n"), Strings{"3: Ke needs three numbers; Ke" + gone});
    EXPECT_EQ(faults("newmtl a\nNs x\n"), Strings{"2: malformed number 'x' in Ns; Ns" + gone});
    EXPECT_EQ(faults("newmtl a\nillum\n"),
              Strings{"2: malformed number '' in illum; illum" + gone});
    for (const char* number : {"nan", "inf", "-0.1", "1e39"})
        EXPECT_EQ(
            faults(std::string("newmtl a\nKe 1 1 ") + number + "\n"),
            Strings{std::string("2: Ke ") + number + " is negative or not finite; Ke" + gone});
    const MtlFile file = readFile("newmtl a\nKd 1 0 0\nKd 1.#QNAN 0 0\nNs 5\nnewmtl b\nKd -1 0 0\n"
                                  "Kd 1.#QNAN 0 0\n");
    EXPECT_EQ(file.materials[0].diffuse, glm::vec3(1, 0, 0));
    EXPECT_EQ(file.materials[0].exponent, 5.0f);
    EXPECT_EQ(file.materials[1].diffuse, std::nullopt);
    ASSERT_EQ(file.faults.size(), 1u);
    EXPECT_EQ(file.faults[0].line, 3u);
    EXPECT_EQ(file.faults[0].count, 3u);
}

TEST_F(Mtl, TakesMoreThanAllLightForAllOfIt) {
    const MtlFile file = readFile("newmtl a\nKd 2 0.5 1\nnewmtl b\nKd 1.5\nKe 5 1e30 0\nKs 2\n");
    EXPECT_EQ(file.materials[0].diffuse, glm::vec3(1, 0.5f, 1));
    EXPECT_EQ(file.materials[1].diffuse, glm::vec3(1));
    EXPECT_EQ(file.materials[1].emission, glm::vec3(5, kMostRadiance, 0));
    ASSERT_EQ(file.faults.size(), 3u);
    EXPECT_EQ(file.faults[0].message, "Kd 2 is above 1, and taken for it");
    EXPECT_EQ(file.faults[0].count, 2u);
    EXPECT_EQ(file.faults[1].message, "Ke 1e+30 is above 7.92282e+28, and taken for it");
    EXPECT_EQ(file.faults[2].message, "Ks 2 is above 1, and taken for it");
}

/// Each once a file, with its first place.
TEST_F(Mtl, TakesMoreThanAWholeForOne) {
    for (const char* key : {"Ka", "Ks", "d", "Tr", "metallic", "Pr", "Pm"}) {
        const std::string name = key, line = name + " 1.5\n", second = name + " 7\n";
        EXPECT_EQ(faults("newmtl a\n" + line + "newmtl b\n" + second),
                  Strings{"2: " + name + " 1.5 is above 1, and taken for it"});
        EXPECT_EQ(faults("newmtl a\n" + name + " 1\n"), Strings{});
    }
    const MtlMaterial a =
        read("newmtl a\nKa 3 .5 0\nKs .25 9 1\nd 2\nTr 2\nmetallic 2\nPr 2\nPm 2\n").at(0);
    EXPECT_EQ(a.ambient, glm::vec3(1, 0.5f, 0));
    EXPECT_EQ(a.specular, glm::vec3(0.25f, 1, 1));
    for (const auto& number : {a.opacity, a.transparency, a.metallic, a.roughness, a.metalness})
        EXPECT_EQ(number, 1.0f);
    EXPECT_EQ(read("newmtl a\nNs 2000\n").at(0).exponent, 2000.0f);
}

TEST_F(Mtl, TellsWhereAMaterialOrAFileNameIsMissing) {
    EXPECT_EQ(faults("newmtl a\nmap_Kd\n"), Strings{"2: map_Kd names no file"});
    EXPECT_EQ(faults("newmtl a\nmap_Kd -s 1 1\n"), Strings{"2: map_Kd names no file"});
    EXPECT_EQ(faults("newmtl a\nKd 1 0 0\nnewmtl b\nnewmtl a\nKd 0 0 1\n"),
              Strings{"4: material 'a' is defined again; the first definition counts"});
    // One argument where the format has two.
    EXPECT_EQ(readFile("newmtl a\nmap_Kd -mm 0.2 a.png\n").materials[0].map(MtlUse::diffuse).file,
              "a.png");
}

TEST_F(Mtl, LeavesOutOptionsThatCannotBeRead) {
    EXPECT_EQ(faults("newmtl a\nbump -bm x a.png\n"),
              Strings{"2: malformed number 'x' of -bm in bump, which is left out"});
    const MtlFile file = readFile("newmtl a\nmap_Kd -o inf 1 -clamp maybe -s 2 1 a.png\n");
    ASSERT_EQ(file.faults.size(), 2u);
    EXPECT_EQ(file.faults[0].message, "malformed number 'inf' of -o in map_Kd, which is left out");
    EXPECT_EQ(file.faults[1].message, "malformed 'maybe' of -clamp in map_Kd, which is left out");
    const MtlMap& map = file.materials[0].map(MtlUse::diffuse);
    EXPECT_EQ(map.offset, glm::vec2(0, 0));
    EXPECT_EQ(map.scale, glm::vec2(2, 1));
    EXPECT_EQ(map.file, "a.png");
}

TEST_F(Mtl, RefusesWhatIsNoText) {
    const std::string file = folder_.write("test.mtl", std::string("newmtl a\nKd\0 1\n", 16));
    EXPECT_EQ(inputError([&] { readMtl(file); }), file + ":2: holds a NUL byte: not a text file");
}

} // namespace
} // namespace dirt
