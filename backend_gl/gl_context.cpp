#include "backend_gl/gl_context.h"

#include "core/base/error.h"

#include <algorithm>
#include <cstring>

#include <dlfcn.h>

namespace dirt {
namespace {

constexpr EGLint kMostDevices = 64;

bool hasExtension(const char* extensions, const char* name) {
    const size_t length = std::strlen(name);
    for (const char* at = extensions; at && (at = std::strstr(at, name)); at += length)
        if ((at == extensions || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

/// libepoxy ends the program where it cannot find a library, so we look first.
const char* clientExtensions() {
    if (!dlopen("libEGL.so.1", RTLD_LAZY | RTLD_GLOBAL))
        throw CapabilityError("no OpenGL: libEGL.so.1 is missing (Debian: libegl1)");
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!hasExtension(extensions, "EGL_EXT_platform_base"))
        throw CapabilityError("no OpenGL: EGL finds no driver that works without a display "
                              "(Debian: libegl-mesa0)");
    return extensions;
}

struct Place {
    EGLDisplay display;
    bool software;
};

/// The displays behind the devices' numbers.
std::vector<Place> places() {
    const char* extensions = clientExtensions();
    std::vector<Place> places;
    if (hasExtension(extensions, "EGL_EXT_device_enumeration") &&
        hasExtension(extensions, "EGL_EXT_platform_device")) {
        EGLDeviceEXT devices[kMostDevices];
        EGLint count = 0;
        if (!eglQueryDevicesEXT(kMostDevices, devices, &count)) count = 0;
        for (EGLint i = 0; i < count; ++i)
            places.push_back(
                {eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
                 hasExtension(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS),
                              "EGL_MESA_device_software")});
    }
    if (places.empty() && hasExtension(extensions, "EGL_MESA_platform_surfaceless"))
        places.push_back(
            {eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
             true});
    return places;
}

/// A context that says when it is lost, if the driver can; none below OpenGL 4.5.
EGLContext createContext(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    std::vector<EGLint> attributes = {
        EGL_CONTEXT_MAJOR_VERSION,       4,
        EGL_CONTEXT_MINOR_VERSION,       5,
        EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
        EGL_CONTEXT_OPENGL_DEBUG,        EGL_TRUE};
    const auto create = [&](std::vector<EGLint> list) {
        list.push_back(EGL_NONE);
        return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, list.data());
    };
    std::vector<EGLint> notified = attributes;
    notified.insert(notified.end(),
                    {EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY, EGL_LOSE_CONTEXT_ON_RESET});
    const EGLContext context = create(notified);
    return context ? context : create(attributes);
}

} // namespace

std::vector<GlDevice> listGlDevices() {
    std::vector<GlDevice> devices(places().size());
    for (size_t i = 0; i < devices.size(); ++i) {
        try {
            devices[i].name = GlContext((int) i).name();
        } catch (const CapabilityError& error) {
            devices[i].problem = error.what();
        }
    }
    return devices;
}

GlContext::GlContext(int device) {
    std::vector<Place> candidates = places();
    if (candidates.empty())
        throw CapabilityError("no OpenGL: EGL finds no driver (Debian: libgl1-mesa-dri)");
    if (device >= (int) candidates.size())
        throw CapabilityError("--device " + std::to_string(device) + ": there are " +
                              std::to_string(candidates.size()) +
                              " (dirt info --devices lists them)");
    if (device >= 0)
        candidates = {candidates[(size_t) device]};
    else
        std::stable_partition(candidates.begin(), candidates.end(),
                              [](const Place& place) { return !place.software; });
    std::string problem;
    for (const Place& place : candidates) {
        try {
            open(place.display);
            return;
        } catch (const CapabilityError& error) {
            if (problem.empty()) problem = error.what();
        }
    }
    throw CapabilityError(problem);
}

void GlContext::open(EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        throw CapabilityError("no OpenGL: the device's driver does not start");
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    for (const char* needed :
         {"EGL_KHR_create_context", "EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"})
        if (!hasExtension(extensions, needed))
            throw CapabilityError(std::string("no OpenGL: the device's driver lacks ") + needed);
    context_ = createContext(display);
    if (!context_) throw CapabilityError("no OpenGL: the device's driver is below OpenGL 4.5");
    display_ = display;
    makeCurrent();
    const auto text = [](GLenum name) { return std::string((const char*) glGetString(name)); };
    name_ = text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS); // the message comes before the call that is wrong ends
    glDebugMessageCallback(onMessage, this);
}

GlContext::~GlContext() {
    // The display is shared with other contexts; it goes with the program.
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

void GlContext::makeCurrent() const {
    if (eglGetCurrentContext() == context_) return;
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        throw CapabilityError("OpenGL: the context cannot be used by this thread");
}

void GlContext::check() const {
    // First, as a lost context answers every question with an error, without end.
    if (glGetGraphicsResetStatus() != GL_NO_ERROR)
        throw CapabilityError("OpenGL: the context is lost, as after a crash or a time limit of "
                              "the graphics driver");
    while (const GLenum error = glGetError()) {
        if (error == GL_OUT_OF_MEMORY) outOfMemory_ = true;
        if (error_.empty()) error_ = "error " + std::to_string(error);
    }
    if (error_.empty()) return;
    const std::string message = "OpenGL: " + error_;
    const bool outOfMemory = outOfMemory_;
    error_.clear();
    outOfMemory_ = false;
    if (outOfMemory)
        throw InputError("out of graphics memory: a smaller --size, fewer --bins or a larger "
                         "--tile needs less (" +
                         message + ")");
    throw std::runtime_error(message);
}

void APIENTRY GlContext::onMessage(GLenum source, GLenum type, GLuint, GLenum, GLsizei,
                                   const GLchar* message, const void* context) {
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
    // Program says it, with file and line; and those that it replaces may go on.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    const auto& self = *static_cast<const GlContext*>(context);
    if (self.error_.empty()) self.error_ = message;
}

} // namespace dirt
