// A driver that is out of memory, has lost the context, or is not there: an error that says so,
// wherever in a frame it comes, and no crash on the way out; of the program, one line and its exit
// status.

#include "backend_gl/gl_backend.h"
#include "core/base/error.h"
#include "core/frame/renderer.h"
#include "tests/cli/program.h"
#include "tests/frame/shapes.h"
#include "tests/gl/replaced.h"
#include "tests/support/random.h"
#include "tests/viewer/view_model_fixture.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

// The driver's own functions, and what stands in for them.
struct Driver {
    decltype(epoxy_glNamedBufferStorage) bufferStorage;
    decltype(epoxy_glTextureStorage2D) textureStorage2D;
    decltype(epoxy_glTextureStorage3D) textureStorage3D;
    decltype(epoxy_glGetError) getError;
    int allocations = 0;     ///< so far
    int failing = 0;         ///< this one fails
    bool full = false;       ///< and has not been reported
    bool isLost = false;     ///< the context
    int statusQuestions = 0; ///< left until it is lost
} driver;

bool fails() {
    return driver.full |= driver.allocations++ == driver.failing;
}

void APIENTRY bufferStorage(GLuint id, GLsizeiptr size, const void* data, GLbitfield flags) {
    if (!fails()) driver.bufferStorage(id, size, data, flags);
}
void APIENTRY textureStorage2D(GLuint id, GLsizei levels, GLenum format, GLsizei w, GLsizei h) {
    if (!fails()) driver.textureStorage2D(id, levels, format, w, h);
}
void APIENTRY textureStorage3D(GLuint id, GLsizei levels, GLenum format, GLsizei w, GLsizei h,
                               GLsizei d) {
    if (!fails()) driver.textureStorage3D(id, levels, format, w, h, d);
}
GLenum APIENTRY getError() {
    return std::exchange(driver.full, false) ? GL_OUT_OF_MEMORY : driver.getError();
}
GLenum APIENTRY resetStatus() {
    return driver.statusQuestions-- > 0 ? GL_NO_ERROR : GL_GUILTY_CONTEXT_RESET;
}

RenderSettings smallFrame() {
    RenderSettings settings;
    settings.grid.width = 24;
    settings.grid.height = 16;
    settings.grid.tile = 4;
    settings.grid.bins = 4;
    settings.samples = 1;
    settings.bounces = 2;
    return settings;
}

/// A frame from the first context on; its message, if it ends in an \p Error.
template <typename Error>
std::string messageOfFrame() {
    try {
        GlBackend backend(GlOptions{.poolNodes = 100}); // and has to grow
        const Scene scene = room();
        Renderer(scene, smallFrame(), backend).render();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

/// From now on, that one and no other.
void failAt(int allocation) {
    driver.allocations = 0;
    driver.failing = allocation;
    driver.full = false;
}

/// Calls \p action with a driver whose allocations fail as failAt says.
template <typename Action>
void withFullDriver(const Action& action) {
    ASSERT_EQ(messageOfFrame<InputError>(), ""); // and epoxy knows all functions
    driver = {epoxy_glNamedBufferStorage, epoxy_glTextureStorage2D, epoxy_glTextureStorage3D,
              epoxy_glGetError};
    const Replaced buffers(epoxy_glNamedBufferStorage, &bufferStorage);
    const Replaced textures2D(epoxy_glTextureStorage2D, &textureStorage2D);
    const Replaced textures3D(epoxy_glTextureStorage3D, &textureStorage3D);
    const Replaced errors(epoxy_glGetError, &getError);
    failAt(std::numeric_limits<int>::max());
    action();
}

/// The program renders \p scene, as frames of smallFrame are, to image.exr of \p folder.
std::vector<std::string> renderCommand(const TemporaryFolder& folder, const std::string& scene) {
    return {"render",    scene, "--backend", "gl", "--size", "24x16", "--spp", "1",
            "--bounces", "2",   "--tile",    "4",  "--bins", "4",     "-o",    folder / "image.exr",
            "--quiet"};
}

/// One line that begins with "dirt: " and \p start, the status, and no image.
void expectFailure(const Outcome& run, int status, const std::string& start,
                   const TemporaryFolder& folder) {
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_TRUE(run.err.starts_with("dirt: " + start)) << run.err;
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
    EXPECT_EQ(run.out, "");
    for (const std::string& name : folder.names()) EXPECT_FALSE(name.starts_with("image")) << name;
}

TEST(GlFailures, AnyAllocationMayFail) {
    withFullDriver([] {
        ASSERT_EQ(messageOfFrame<InputError>(), "");
        const int all = driver.allocations;
        ASSERT_GT(all, 20);
        for (int i = 0; i < all; i += cases(7, 1)) {
            failAt(i);
            const std::string message = messageOfFrame<InputError>();
            EXPECT_TRUE(message.starts_with("out of graphics memory")) << i << ": " << message;
            EXPECT_EQ(message.find('\n'), message.npos);
        }
    });
}

TEST(GlFailures, TheProgramSaysThatMemoryIsOut) {
    const TemporaryFolder folder;
    const std::vector<std::string> command = renderCommand(folder, litTriangle(folder));
    withFullDriver([&] {
        failAt(15);
        expectFailure(dirt(command), 2, "out of graphics memory", folder);
        EXPECT_GT(driver.allocations, 15);
    });
}

TEST(GlFailures, TheContextMayBeLost) {
    ASSERT_EQ(messageOfFrame<CapabilityError>(), "");
    const Replaced status(epoxy_glGetGraphicsResetStatus, &resetStatus);
    for (const int questions : {0, 1, 3, 6, 12, 16}) {
        driver.statusQuestions = questions;
        const std::string message = messageOfFrame<CapabilityError>();
        EXPECT_TRUE(message.starts_with("OpenGL: the context is lost")) << message;
    }
    driver.statusQuestions = 1'000'000;
    EXPECT_EQ(messageOfFrame<CapabilityError>(), "");

    const TemporaryFolder folder;
    const std::vector<std::string> command = renderCommand(folder, litTriangle(folder));
    driver.statusQuestions = 8;
    expectFailure(dirt(command), 3, "OpenGL: the context is lost", folder);
}

/// The viewer says it, and the next change finds a new context.
TEST(GlFailures, TheViewerGoesOnAfterALostContext) {
    ASSERT_EQ(messageOfFrame<CapabilityError>(), "");
    const TemporaryFolder folder;
    CommonOptions options;
    options.scene = litTriangle(folder);
    options.size = ImageSize{24, 16};
    options.samples = 1;
    options.backend = BackendKind::gl;
    options.quiet = options.noCache = true;
    const Replaced status(epoxy_glGetGraphicsResetStatus, &resetStatus);
    driver.statusQuestions = 1'000'000'000;
    ViewModel model(options);
    const auto before = ViewModelTest::rest(model);
    ASSERT_TRUE(before);
    driver.statusQuestions = 2;
    model.change([](ViewState& s) { s.settings.grid.bins += 1; });
    ASSERT_TRUE(ViewModelTest::comes([&] { return !model.problem().empty(); }));
    EXPECT_TRUE(model.problem().starts_with("OpenGL: the context is lost")) << model.problem();
    EXPECT_EQ(model.picture(), before);
    driver.statusQuestions = 1'000'000'000;
    model.change([](ViewState& s) { s.settings.grid.bins -= 1; });
    const auto after = ViewModelTest::rest(model);
    ASSERT_TRUE(after);
    EXPECT_EQ(after->image.pixels, before->image.pixels);
    EXPECT_EQ(model.problem(), "");
}

/// A machine without EGL, without a driver, with one that does not start, or with one of an older
/// OpenGL, as far as the environment can make them.
TEST(GlFailures, WithoutOpenGlTheProgramSaysSoAndTheRestWorks) {
    if (GlContext().name().find("Mesa") == std::string::npos)
        GTEST_SKIP() << "these are Mesa's variables";
    const TemporaryFolder folder;
    std::vector<std::string> command = renderCommand(folder, litTriangle(folder));
    folder.write("empty/libEGL.so.1", "");
    struct Machine {
        std::string variable, value, said;
    };
    const std::string empty = folder / "empty", none = empty + "/none";
    for (const Machine& machine :
         {Machine{"LD_LIBRARY_PATH", empty, "no OpenGL: libEGL.so.1 is missing"},
          Machine{"__EGL_VENDOR_LIBRARY_FILENAMES", none, "no OpenGL: EGL finds no driver"},
          Machine{"LIBGL_DRIVERS_PATH", none, "no OpenGL: the device's driver does not start"},
          Machine{"MESA_GL_VERSION_OVERRIDE", "4.4",
                  "no OpenGL: the device's driver is below OpenGL 4.5"}}) {
        SCOPED_TRACE(machine.variable);
        const auto prepare = [&] { setenv(machine.variable.c_str(), machine.value.c_str(), 1); };
        expectFailure(startDirt(command, prepare), 3, machine.said, folder);
    }
    std::replace(command.begin(), command.end(), std::string("gl"), std::string("cpu"));
    const Outcome other = startDirt(command, [&] { setenv("LD_LIBRARY_PATH", empty.c_str(), 1); });
    EXPECT_EQ(other.status, 0) << other.err;
    EXPECT_TRUE(folder.names().contains("image.exr"));
}

} // namespace
} // namespace dirt::test
