// Caches of OBJ files: what they hold, and that damaged, stale and foreign ones are replaced.

#include "core/io/obj_cache.h"

#include "core/io/content_hash.h"
#include "core/io/load.h"
#include "core/io/text_file.h"
#include "tests/io/input_error.h"
#include "tests/io/same_bits.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace dirt {
namespace {

namespace fs = std::filesystem;

/// All but the textures' texels, which no cache has.
void expectSame(const LoadedScene& a, const LoadedScene& b) {
    const Mesh &m = a.scene.mesh, &n = b.scene.mesh;
    EXPECT_TRUE(test::sameBits(m.positions, n.positions) && test::sameBits(m.normals, n.normals) &&
                test::sameBits(m.texcoords, n.texcoords) && test::sameBits(m.colors, n.colors) &&
                test::sameBits(m.triangles, n.triangles) &&
                test::sameBits(m.normalIndices, n.normalIndices) &&
                test::sameBits(m.texcoordIndices, n.texcoordIndices) &&
                test::sameBits(m.materials, n.materials));
    ASSERT_EQ(a.scene.materials.size(), b.scene.materials.size());
    for (size_t i = 0; i < a.scene.materials.size(); ++i) {
        EXPECT_EQ(a.scene.materials[i].name, b.scene.materials[i].name);
        EXPECT_EQ(a.scene.materials[i].diffuse, b.scene.materials[i].diffuse);
        EXPECT_EQ(a.scene.materials[i].emission, b.scene.materials[i].emission);
    }
    ASSERT_EQ(a.warnings.size(), b.warnings.size());
    for (size_t i = 0; i < a.warnings.size(); ++i) {
        EXPECT_EQ(a.warnings[i].kind, b.warnings[i].kind);
        EXPECT_EQ(a.warnings[i].text, b.warnings[i].text);
    }
    EXPECT_EQ(a.ignored, b.ignored);
}

/// Polygons, odd numbers, names, warnings and ignored statements; large enough for a cache.
std::string makeObj(test::Random& random, int vertices = 1500) {
    std::string text = "mtllib a.mtl\nmtllib none.mtl\ncurv 1 2\nunknown statement\n";
    char line[128];
    for (int i = 0; i < vertices; ++i) {
        std::snprintf(line, sizeof line, "v %.17g %.9g %.9g %.3g 0 1\nvn %.9g 0 1\nvt %.9g nan\n",
                      random.wide(-3, 3), random.uniform(-5, 5), random.uniform(-5, 5),
                      random.uniform(), random.uniform(-1, 1), random.uniform());
        text += line;
    }
    for (int i = 1; i + 4 <= vertices; i += 2) {
        std::snprintf(line, sizeof line, "usemtl m%d\nf %d %d//%d %d/%d/%d %d\n", i % 7, i, i + 1,
                      i + 1, i + 2, i, i, i + 3);
        text += line;
    }
    return text;
}

const char* const kMtl = "newmtl m0\nKd 1 0 0\nnewmtl m3\nKd .1 .2 .3\nTf 1 1 1\nmap_Kd none.png\n"
                         "newmtl m5\nKe 3 3 3\n";

class ObjCache : public testing::Test {
protected:
    ObjCache() {
        setenv("XDG_CACHE_HOME", (folder_ / "user").c_str(), 1);
        test::Random random(1);
        folder_.write("a.mtl", kMtl);
        obj_ = folder_.write("a.obj", makeObj(random));
        plain_ = loadScene(obj_);
    }

    LoadedScene cached() const { return loadScene(obj_, {.cache = true}); }
    /// The file's cache, made by hand.
    std::string encoded() const {
        LoadReport report;
        ReadObj read{readObj(obj_, report), report.ignored()};
        const std::string source = readBytes(obj_);
        return encodeCache(read, std::as_bytes(std::span(source)));
    }
    bool decodes(const std::string& cache) const {
        const std::string source = readBytes(obj_);
        return decodeCache(std::as_bytes(std::span(cache)), std::as_bytes(std::span(source)), obj_)
            .has_value();
    }

    test::TemporaryFolder folder_;
    std::string obj_;
    LoadedScene plain_;
    const std::string beside_ = folder_ / "a.obj.sbin";
};

TEST_F(ObjCache, IsOffUnlessAskedFor) {
    EXPECT_FALSE(fs::exists(beside_));
    EXPECT_EQ(plain_.warnings.size(), 7u)
        << "texture coordinates, a library, a texture, four materials";
    EXPECT_GE(plain_.ignored.size(), 3u);
}

TEST_F(ObjCache, GivesTheSameScene) {
    expectSame(cached(), plain_); // makes it
    const std::string cache = readBytes(beside_);
    EXPECT_EQ(cache, encoded());
    const auto time = fs::last_write_time(beside_);
    expectSame(cached(), plain_); // reads it
    EXPECT_EQ(fs::last_write_time(beside_), time);
    EXPECT_FALSE(fs::exists(folder_ / "user"));
    EXPECT_EQ(folder_.names(), (std::set<std::string>{"a.mtl", "a.obj", "a.obj.sbin"}));
}

TEST_F(ObjCache, IsNamedByTheLoadThatLeavesIt) {
    EXPECT_EQ(plain_.caches, (std::vector<std::string>{}));
    EXPECT_EQ(cached().caches, (std::vector<std::string>{beside_}));
    EXPECT_EQ(cached().caches, (std::vector<std::string>{}));
}

/// A cache that says something else than its file shows that it is what is read.
TEST_F(ObjCache, IsWhatIsRead) {
    LoadReport report;
    ReadObj read{readObj(obj_, report), {"something"}};
    read.obj.positions[0].x = 77.0;
    const std::string source = readBytes(obj_);
    folder_.write("a.obj.sbin", encodeCache(read, std::as_bytes(std::span(source))));
    const LoadedScene loaded = cached();
    EXPECT_EQ(loaded.scene.mesh.positions[0].x, 77.0f);
    EXPECT_EQ(loaded.ignored.front(), "something");
}

TEST_F(ObjCache, SmallFilesHaveNone) {
    test::Random random(2);
    const std::string small = folder_.write("b.obj", makeObj(random, 100));
    loadScene(small, {.cache = true});
    EXPECT_FALSE(fs::exists(small + ".sbin"));
}

TEST_F(ObjCache, AnyDamageIsNoticedAndReplaced) {
    const std::string sound = encoded();
    ASSERT_TRUE(decodes(sound));
    // The header byte by byte; then bytes all over all arrays.
    test::Random random(3);
    std::vector<size_t> places;
    for (size_t i = 0; i < 128; ++i) places.push_back(i);
    for (int i = 0; i < 300; ++i) places.push_back((size_t) random.below((int) sound.size()));
    for (const size_t place : places) {
        std::string damaged = sound;
        damaged[place] = (char) (damaged[place] ^ 1 << random.below(8));
        EXPECT_FALSE(decodes(damaged)) << place;
    }
    for (int i = 0; i < 300; ++i)
        EXPECT_FALSE(decodes(sound.substr(0, (size_t) random.below((int) sound.size()))));
    EXPECT_FALSE(decodes(sound + "x"));
    for (const std::string& damaged :
         {sound.substr(0, sound.size() / 2), std::string(), std::string("dirtsbin"),
          sound.substr(0, 100) + "xyz" + sound.substr(103)}) {
        folder_.write("a.obj.sbin", damaged);
        expectSame(cached(), plain_);
        EXPECT_TRUE(readBytes(beside_) == sound);
    }
}

/// Sound sums over contents that make no sense, as another program might write them.
TEST_F(ObjCache, NonsenseIsNoticed) {
    LoadReport report;
    const ReadObj sound{readObj(obj_, report), report.ignored()};
    const std::string source = readBytes(obj_);
    const auto accepted = [&](const ReadObj& read) {
        return decodes(encodeCache(read, std::as_bytes(std::span(source))));
    };
    EXPECT_TRUE(accepted(sound));
    ReadObj read = sound;
    read.obj.corners[5].position = (uint32_t) read.obj.positions.size();
    EXPECT_FALSE(accepted(read));
    read = sound;
    read.obj.corners[5].position = ObjFile::kNone;
    EXPECT_FALSE(accepted(read));
    read = sound;
    read.obj.corners[5].normal = (uint32_t) read.obj.normals.size();
    EXPECT_FALSE(accepted(read));
    read = sound;
    read.obj.colors.pop_back();
    EXPECT_FALSE(accepted(read));
    read = sound;
    read.obj.faces.back().corners++;
    EXPECT_FALSE(accepted(read));
    read = sound;
    read.obj.faces[0].firstCorner = ~size_t(0);
    EXPECT_FALSE(accepted(read));
    read = sound;
    read.obj.faces[0].material = 7;
    EXPECT_FALSE(accepted(read));
}

/// Kinds of warnings that there are not, whose sums are right: a number of 64 bits that the enum
/// would cut to one there is, and one just beyond the last.
TEST(ObjCacheContents, HoldKnownKindsAlone) {
    ReadObj read;
    read.obj.faults.push_back({WarningKind::precision, 7, "none", 2});
    const std::string source = "v 0 0 0\n";
    const auto sourceBytes = std::as_bytes(std::span(source));
    const std::string cache = encodeCache(read, sourceBytes);
    // Nine arrays without elements but for the faults, whose count and kind come last but three.
    std::string content = cache.substr(cache.size() - (8 * 8 + 8 + 4 * 8 + 4 + 8));
    ASSERT_EQ(sealCache(content, sourceBytes), cache);
    const auto decode = [&](uint64_t kind) {
        std::memcpy(content.data() + 9 * 8, &kind, sizeof kind);
        const std::string sealed = sealCache(content, sourceBytes);
        return decodeCache(std::as_bytes(std::span(sealed)), sourceBytes, "a.obj").has_value();
    };
    EXPECT_TRUE(decode((uint64_t) kLastWarningKind));
    EXPECT_FALSE(decode((uint64_t) kLastWarningKind + 1));
    EXPECT_FALSE(decode((uint64_t(2) << 32) + 3));
}

TEST_F(ObjCache, OfAnotherVersionOrMachineIsReplaced) {
    const std::string sound = encoded();
    // Version, byte order and layout, with the header's own sum made right again.
    for (const size_t place : {8, 12, 16}) {
        std::string foreign = sound;
        foreign[place]++;
        const uint64_t sum = contentHash(std::as_bytes(std::span(foreign).first(56)));
        std::memcpy(foreign.data() + 56, &sum, 8);
        EXPECT_FALSE(decodes(foreign)) << place;
        folder_.write("a.obj.sbin", foreign);
        expectSame(cached(), plain_);
        EXPECT_TRUE(readBytes(beside_) == sound);
    }
}

TEST_F(ObjCache, FollowsItsFiles) {
    cached();
    // As long as before, and made at the same time.
    std::string text = readBytes(obj_);
    const auto time = fs::last_write_time(obj_);
    const size_t digit = text.find_first_of("123456789", text.find("\nv "));
    text[digit] = text[digit] == '5' ? '6' : '5';
    folder_.write("a.obj", text);
    fs::last_write_time(obj_, time);
    const LoadedScene changed = loadScene(obj_);
    EXPECT_FALSE(test::sameBits(changed.scene.mesh.positions, plain_.scene.mesh.positions));
    expectSame(cached(), changed);
    // Material files are read each time.
    folder_.write("a.mtl", "newmtl m0\nKd 0 1 0\n");
    expectSame(cached(), loadScene(obj_));
    EXPECT_EQ(cached().scene.materials.size(), 7u);
}

TEST_F(ObjCache, ErrorsAreThoseWithout) {
    const std::string bad = folder_.write("b.obj", readBytes(obj_) + "f 1 2 99999\n");
    const std::string what = inputError([&] { loadScene(bad); });
    EXPECT_NE(what, "");
    EXPECT_EQ(inputError([&] { loadScene(bad, {.cache = true}); }), what);
    EXPECT_FALSE(fs::exists(bad + ".sbin"));
    cached();
    EXPECT_EQ(inputError([&] { loadScene(obj_, {.strict = true, .cache = true}); }),
              inputError([&] { loadScene(obj_, {.strict = true}); }));
}

TEST_F(ObjCache, GoesToTheUsersFolderWhereTheOtherIsTaken) {
    fs::create_directory(beside_); // nothing can be written there
    expectSame(cached(), plain_);
    const auto places = cachePlaces(obj_);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[1].parent_path(), folder_ / "user/dirt");
    EXPECT_TRUE(readBytes(places[1]) == encoded());
    expectSame(cached(), plain_);
    // Nor there: then there is none.
    fs::remove_all(folder_ / "user");
    folder_.write("user", "no folder");
    expectSame(cached(), plain_);
    // A relative XDG_CACHE_HOME is to be ignored.
    setenv("XDG_CACHE_HOME", "relative", 1);
    setenv("HOME", (folder_ / "home").c_str(), 1);
    EXPECT_EQ(cachePlaces(obj_)[1].parent_path(), folder_ / "home/.cache/dirt");
}

TEST_F(ObjCache, ReadOnlyFoldersAreNoTrouble) {
    // Without a right to write anywhere, and as a user whom that binds.
    fs::create_directory(folder_ / "user");
    for (const std::string& path : {folder_.path().string(), folder_ / "user"})
        fs::permissions(path, fs::perms(0555));
    const pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(3);
        const LoadedScene loaded = cached();
        const bool same = test::sameBits(loaded.scene.mesh.positions, plain_.scene.mesh.positions);
        _exit(same && !fs::exists(beside_) ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
    // Root is not bound, but keeps out as well.
    expectSame(cached(), plain_);
    EXPECT_FALSE(fs::exists(beside_));
    for (const std::string& path : {folder_.path().string(), folder_ / "user"})
        fs::permissions(path, fs::perms(0755));
    EXPECT_TRUE(fs::is_empty(folder_ / "user"));
}

TEST_F(ObjCache, TwoProcessesAtOnceDoNoHarm) {
    for (int round = 0; round < test::cases(5, 50); ++round) {
        fs::remove(beside_);
        std::vector<pid_t> children;
        for (int i = 0; i < 4; ++i) {
            children.push_back(fork());
            if (children.back() != 0) continue;
            bool same = true;
            for (int k = 0; k < 3; ++k) {
                const LoadedScene loaded = cached();
                same = same &&
                       test::sameBits(loaded.scene.mesh.positions, plain_.scene.mesh.positions) &&
                       loaded.ignored == plain_.ignored;
                if (k == 1 && i == 0) fs::resize_file(beside_, 999); // and damage for the others
            }
            _exit(same ? 0 : 1);
        }
        for (const pid_t child : children) {
            int status = -1;
            ASSERT_EQ(waitpid(child, &status, 0), child);
            EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        }
        cached();
        EXPECT_TRUE(readBytes(beside_) == encoded());
        EXPECT_EQ(folder_.names(), (std::set<std::string>{"a.mtl", "a.obj", "a.obj.sbin"}));
    }
}

TEST(ContentHash, ChangesWithEveryBitAndLength) {
    test::Random random(5);
    std::string bytes(100, '\0');
    for (char& byte : bytes) byte = (char) random.bits();
    std::set<uint64_t> hashes;
    const auto hash = [&](size_t length) {
        return contentHash(std::as_bytes(std::span(bytes).first(length)));
    };
    hashes.insert(hash(100));
    for (size_t bit = 0; bit < 800; ++bit) {
        bytes[bit / 8] = (char) (bytes[bit / 8] ^ 1 << bit % 8);
        hashes.insert(hash(100));
        bytes[bit / 8] = (char) (bytes[bit / 8] ^ 1 << bit % 8);
    }
    for (size_t length = 0; length < 100; ++length) hashes.insert(hash(length));
    EXPECT_EQ(hashes.size(), 901u);
    // Zeros are told apart by their count.
    bytes.assign(100, '\0');
    hashes.clear();
    for (size_t length = 0; length <= 100; ++length) hashes.insert(hash(length));
    EXPECT_EQ(hashes.size(), 101u);
}

} // namespace
} // namespace dirt
