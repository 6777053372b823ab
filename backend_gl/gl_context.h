#pragma once

#include <string>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace dirt {

/// What OpenGL can be asked of without a display.
struct GlDevice {
    std::string name;    ///< renderer and version; empty where there is a problem
    std::string problem; ///< why it cannot be used; empty where it can
};

/// All devices in the order of their numbers (`--device N`): those of EGL, or Mesa's surfaceless
/// platform where EGL names none. Throws CapabilityError where there is no EGL at all.
std::vector<GlDevice> listGlDevices();

/// An OpenGL 4.5 core context without a display. What the driver reports as an error is kept, and
/// thrown by check().
class GlContext {
public:
    /// \p device: a number of listGlDevices(); -1: the first that works, GPUs before software.
    /// Throws CapabilityError where there is none.
    explicit GlContext(int device = -1);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Whoever calls OpenGL for this context calls this first.
    void makeCurrent() const;

    /// Throws what the driver has reported since the last call: InputError where it is out of
    /// memory, CapabilityError where the context is lost, std::runtime_error for other errors.
    void check() const;

    /// Renderer and version.
    const std::string& name() const { return name_; }

private:
    void open(EGLDisplay display);

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    std::string name_;
    mutable std::string error_;
    mutable bool outOfMemory_ = false;

    static void APIENTRY onMessage(GLenum source, GLenum type, GLuint id, GLenum severity,
                                   GLsizei length, const GLchar* message, const void* context);
};

} // namespace dirt
