// A driver that is out of memory, or has lost the context: an error that says so, wherever in a
// frame it comes, and no crash on the way out.

#include "backend_gl/gl_backend.h"
#include "core/frame/renderer.h"
#include "core/io/error.h"
#include "tests/frame/shapes.h"
#include "tests/gl/replaced.h"
#include "tests/support/random.h"

#include <limits>

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

TEST(GlFailures, AnyAllocationMayFail) {
    ASSERT_EQ(messageOfFrame<InputError>(), ""); // and epoxy knows all functions
    driver = {epoxy_glNamedBufferStorage, epoxy_glTextureStorage2D, epoxy_glTextureStorage3D,
              epoxy_glGetError};
    const Replaced buffers(epoxy_glNamedBufferStorage, &bufferStorage);
    const Replaced textures2D(epoxy_glTextureStorage2D, &textureStorage2D);
    const Replaced textures3D(epoxy_glTextureStorage3D, &textureStorage3D);
    const Replaced errors(epoxy_glGetError, &getError);
    driver.failing = std::numeric_limits<int>::max();
    ASSERT_EQ(messageOfFrame<InputError>(), "");
    const int all = driver.allocations;
    ASSERT_GT(all, 20);
    for (int i = 0; i < all; i += cases(7, 1)) {
        driver.allocations = 0;
        driver.failing = i;
        driver.full = false;
        const std::string message = messageOfFrame<InputError>();
        EXPECT_TRUE(message.starts_with("out of graphics memory")) << i << ": " << message;
        EXPECT_EQ(message.find('\n'), message.npos);
    }
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
}

} // namespace
} // namespace dirt::test
