// Damaged input: whatever the bytes are, a file loads or ends in one line that names a file.

#include "core/io/load.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>

namespace dirt {
namespace {

const std::string kObj = "# comment\nmtllib a.mtl\no box\nv 0 0 0\nv 1 0 0.5\nv\t1 1e0 -0\n"
                         "v 0 1 .25 1.0\nvt 0 0\nvt 1 1\nvn 0 0 1\nusemtl red one\ns off\n"
                         "f 1/1/1 2/2/1 3//1 4\nf -4 -3 \\\n-2 -1\nl 1 2\nf 1 2 3\n";
const std::string kMtl = "newmtl red one\nKd 0.5 0.25 1\nKe 1 1 1\nNs 10\n"
                         "map_Kd -s 1 1 1 -clamp on maps\\a.png\n";
const std::string kScene =
    "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<world background=\"0 0.5, 1\">\n"
    "<tracing block_size=\"2\" buckets=\"16\" faces=\"single\" indirect_bounces=\"1\"/>\n"
    "<directory path=\".\"/><camera aperture=\"45.0\"/>\n"
    "<light active=\"true\" position=\"0 1 0\" target=\"0,0,0\" aperture=\"90\" penumbra=\"8\"/>\n"
    "<transformation rotation=\"30,0,1,0\" scale=\"1 1 1\">\n<object file=\"a.obj\"/>\n"
    "</transformation>\n<user position=\"1 1 1\" lookat=\"0 0 0\"/>\n"
    "<tonemapping key=\"1\" white=\"1 1 1\"/></world>\n";

/// A few random edits: bytes changed, removed, repeated, or replaced by awkward text.
std::string damaged(std::string text, std::mt19937& random) {
    static const std::string awkward[] = {"nan",  "1e99", "-",    "/",          "\\\n", "\r",
                                          "\xff", "<",    "&#0;", "9999999999", "0",    " ",
                                          "\"",   "#",    "f ",   "<![CDATA["};
    for (unsigned edits = 1 + random() % 4; edits > 0 && !text.empty(); --edits) {
        const size_t at = random() % text.size(), length = random() % 8;
        switch (random() % 4) {
        case 0:
            text[at] = (char) (random() % 256);
            break;
        case 1:
            text.erase(at, length);
            break;
        case 2:
            text.insert(at, text.substr(random() % text.size(), length));
            break;
        default:
            text.insert(at, awkward[random() % std::size(awkward)]);
        }
    }
    return text;
}

TEST(Fuzz, DamagedFilesLoadOrEndInOneLine) {
    const test::TemporaryFolder folder;
    std::mt19937 random(1);
    const int rounds = std::getenv("DIRT_TEST_FULL") ? 200000 : 3000;
    int loads = 0, errors = 0;
    for (int round = 0; round < rounds; ++round) {
        const unsigned which = random() % 3;
        folder.write("a.obj", which == 0 ? damaged(kObj, random) : kObj);
        folder.write("a.mtl", which == 1 ? damaged(kMtl, random) : kMtl);
        const auto scene = folder.write("a.scene", which == 2 ? damaged(kScene, random) : kScene);
        const std::string what = inputError([&] { loadScene(scene); });
        ++(what.empty() ? loads : errors);
        ASSERT_EQ(what.find_first_of("\r\n"), std::string::npos)
            << "round " << round << ' ' << what;
        ASSERT_TRUE(what.empty() || what.rfind(folder.path().string() + "/a.", 0) == 0) << what;
    }
    // Damage is neither always harmless nor always fatal.
    EXPECT_GT(loads, rounds / 10);
    EXPECT_GT(errors, rounds / 10);
}

TEST(Fuzz, RandomBytesEndInOneLine) {
    const test::TemporaryFolder folder;
    std::mt19937 random(2);
    const int rounds = std::getenv("DIRT_TEST_FULL") ? 20000 : 1000;
    for (int round = 0; round < rounds; ++round) {
        std::string bytes(random() % 2000, '\0');
        // Without NUL bytes, which are refused at once, in every second round.
        for (char& byte : bytes) byte = (char) (round % 2 ? 1 + random() % 255 : random() % 256);
        for (const char* name : {"a.obj", "a.scene"}) {
            const std::string file = folder.write(name, bytes);
            const std::string what = inputError([&] { loadScene(file); });
            ASSERT_EQ(what.rfind(file + ":", 0), 0u) << "round " << round << ' ' << what;
            ASSERT_EQ(what.find_first_of("\r\n"), std::string::npos) << "round " << round;
        }
        // As a material library: read over, or refused.
        folder.write("a.mtl", bytes);
        const std::string obj = folder.write("b.obj", kObj);
        const std::string what = inputError([&] { loadScene(obj); });
        ASSERT_TRUE(what.empty() || what.rfind(folder / "a.mtl:", 0) == 0) << what;
    }
}

} // namespace
} // namespace dirt
