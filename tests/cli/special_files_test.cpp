// FIFOs, sockets, devices and files of the kernel's are no input of any kind: refused at once, in
// one line, status 2. What a file holds that is not what it should be is not shown, but for its
// first bad line.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace dirt::test {
namespace {

namespace fs = std::filesystem;

class SpecialFiles : public testing::Test {
protected:
    SpecialFiles() {
        mkfifo((folder_ / "fifo").c_str(), 0600);
        const int descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::snprintf(address.sun_path, sizeof address.sun_path, "%s",
                      (folder_ / "socket").c_str());
        if (bind(descriptor, (const sockaddr*) &address, sizeof address) != 0) std::abort();
        close(descriptor);
    }

    /// Whether the command ends soon, in one line that says what \p says.
    void expectRefusal(const std::vector<std::string>& arguments, const std::string& says) {
        const Outcome run = startDirt(arguments, [] { alarm(60); });
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_NE(run.err.find(says), std::string::npos) << run.err;
    }

    void link(const std::string& target, const std::string& name) {
        fs::remove(folder_ / name);
        fs::create_symlink(target, folder_ / name);
    }

    /// All kinds, and what is said of them.
    const std::vector<std::pair<std::string, std::string>> kinds_{
        {"fifo", "is a FIFO, not a file"},
        {"socket", "is a socket, not a file"},
        {"/dev/zero", "is a device, not a file"},
        {"/proc/cpuinfo", "is made up by the kernel, not a file"}};
    TemporaryFolder folder_;
};

TEST_F(SpecialFiles, AreNoScene) {
    for (const auto& [target, says] : kinds_)
        for (const char* name : {"a.obj", "a.scene", "a.gltf", "a.glb"}) {
            link(target, name);
            expectRefusal({"info", folder_ / name}, (folder_ / name) + ": " + says);
        }
    fs::remove(folder_ / "a.obj");
    fs::create_directory(folder_ / "a.obj");
    expectRefusal({"render", folder_ / "a.obj"}, (folder_ / "a.obj") + ": is a folder, not a file");
}

TEST_F(SpecialFiles, AreNoPartOfAScene) {
    folder_.write("a.scene", "<world><object file=\"part.obj\"/></world>");
    folder_.write("a.obj", std::string("mtllib part.mtl\nusemtl a\n") + kTriangleObj);
    folder_.write("b.obj", std::string("mtllib b.mtl\nusemtl a\n") + kTriangleObj);
    folder_.write("b.mtl", "newmtl a\nmap_Kd part.png\n");
    folder_.write("a.gltf", "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"part.bin\","
                            "\"byteLength\":36}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}]"
                            ",\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
                            "\"type\":\"VEC3\"}],\"meshes\":[{\"primitives\":[{\"attributes\":"
                            "{\"POSITION\":0}}]}],\"nodes\":[{\"mesh\":0}]}");
    for (const auto& [target, says] : kinds_)
        for (const auto& [scene, part] :
             {std::pair{"a.scene", "part.obj"}, std::pair{"a.obj", "part.mtl"},
              std::pair{"b.obj", "part.png"}, std::pair{"a.gltf", "part.bin"}}) {
            link(target, part);
            expectRefusal({"info", folder_ / scene, "--quiet"}, (folder_ / part) + ": " + says);
        }
}

TEST_F(SpecialFiles, AreNoImageAndNoCache) {
    writePng(folder_ / "a.png", 1, 1, std::vector<uint8_t>{1, 2, 3}, {});
    for (const auto& [target, says] : kinds_) {
        link(target, "b.png");
        expectRefusal({"compare", folder_ / "a.png", folder_ / "b.png"},
                      (folder_ / "b.png") + ": " + says);
    }
    // A cache is no input that is asked for: what is no cache is left alone.
    std::string obj = kTriangleObj;
    while (obj.size() < (1 << 16)) obj += "# worth a cache\n";
    folder_.write("a.obj", obj);
    link("fifo", "a.obj.sbin");
    const Outcome run = startDirt({"info", folder_ / "a.obj"}, [&] {
        setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
        alarm(60);
    });
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(fs::is_fifo(folder_ / "fifo"));
}

TEST_F(SpecialFiles, WhatIsNoSceneIsNotShown) {
    const std::string secret = "first:x:0\nsecond:x:1\nthird\x1b[31m:x:2\n";
    folder_.write("secret.obj", secret);
    folder_.write("secret.scene", secret);
    folder_.write("secret.gltf", secret);
    folder_.write("secret.mtl", secret);
    folder_.write("a.obj", std::string("mtllib secret.mtl\nusemtl a\n") + kTriangleObj);
    for (const char* name : {"secret.obj", "secret.scene", "secret.gltf", "a.obj"})
        for (const char* command : {"info", "render"}) {
            std::vector<std::string> arguments{command, folder_ / name, "--size", "8x8"};
            if (std::string(command) == "render")
                arguments.insert(arguments.end(), {"--spp", "1", "-o", folder_ / "x.png"});
            const Outcome run = dirt(arguments);
            const std::string all = run.out + run.err;
            EXPECT_EQ(run.status, name[0] == 'a' ? 0 : 2) << all;
            EXPECT_EQ(all.find("second"), all.npos) << all;
            EXPECT_EQ(all.find("third"), all.npos) << all;
            EXPECT_EQ(all.find('\x1b'), all.npos) << all;
        }
    EXPECT_NE(dirt({"info", folder_ / "secret.obj"})
                  .err.find("secret.obj:1: 'first:x:0' is no statement of an OBJ file"),
              std::string::npos);
}

} // namespace
} // namespace dirt::test
