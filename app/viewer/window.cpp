#include "app/viewer/window.h"

#include "app/viewer/keys.h"
#include "app/viewer/overlay.h"
#include "app/viewer/status_file.h"
#include "core/base/error.h"
#include "core/io/output_file.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

#include <epoxy/gl.h>
// After it, so that it brings no OpenGL of its own.
#include <GLFW/glfw3.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace dirt {

namespace {

/// Keys of GLFW that are no letters, digits or signs, which have the same numbers.
const std::map<int, int> kSpecialKeys{{GLFW_KEY_ESCAPE, kEscape},
                                      {GLFW_KEY_LEFT, kLeft},
                                      {GLFW_KEY_RIGHT, kRight},
                                      {GLFW_KEY_UP, kUp},
                                      {GLFW_KEY_DOWN, kDown},
                                      {GLFW_KEY_PAGE_UP, kPageUp},
                                      {GLFW_KEY_PAGE_DOWN, kPageDown},
                                      {GLFW_KEY_F1, kF1},
                                      {GLFW_KEY_F5, kF5},
                                      {GLFW_KEY_F6, kF6},
                                      {GLFW_KEY_F8, kF8}};

int keyOf(int glfwKey) {
    const auto special = kSpecialKeys.find(glfwKey);
    return special != kSpecialKeys.end() ? special->second : glfwKey;
}

/// The display, and what is opened on it, for as long as it lives.
class Display {
public:
    Display() {
        glfwSetErrorCallback([](int, const char* text) { problem() = text; });
        if (!glfwInit()) throw CapabilityError("no window: " + reason());
    }
    ~Display() { glfwTerminate(); }
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    static std::string reason() {
        const std::string& text = problem();
        return text.empty() ? "there is no display" : text.substr(0, text.find('\n'));
    }

private:
    static std::string& problem() {
        static std::string text;
        return text;
    }
};

/// A texture as ImGui passes it on, which calls it a pointer.
ImTextureID textureId(GLuint texture) {
    return (ImTextureID) (intptr_t) texture; // NOLINT(performance-no-int-to-ptr)
}

/// The window, its events, and a picture over all of it.
class Window {
public:
    Window(Viewer& viewer, int width, int height, const std::string& title) : viewer_(viewer) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        if (!window_) throw CapabilityError("no window: " + Display::reason());
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_, this);
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
            if (action == GLFW_PRESS) of(window).press(keyOf(key));
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
            if (button == GLFW_MOUSE_BUTTON_LEFT) of(window).button(action == GLFW_PRESS);
        });
        glfwSetCursorPosCallback(
            window_, [](GLFWwindow* window, double x, double y) { of(window).cursor(x, y); });
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr; // leaves nothing in the folder
        ImGui_ImplGlfw_InitForOpenGL(window_, true);
        ImGui_ImplOpenGL3_Init("#version 330");
        glGenTextures(1, &texture_);
    }
    ~Window() {
        glDeleteTextures(1, &texture_);
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        glfwDestroyWindow(window_);
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool open() const { return !glfwWindowShouldClose(window_) && !viewer_.quit; }

    /// Waits for events, not longer than a picture may take to be seen, and acts on them.
    void takeEvents() {
        glfwWaitEventsTimeout(0.01);
        const auto now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        for (const KeyBinding& binding : keyBindings())
            if (binding.hold && isHeld(binding.key))
                binding.hold(viewer_, std::min(seconds, 0.1)); // no leap after a pause
        followSize();
    }

    void show(const ViewPicture* shown) {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        if (shown) drawPicture(*shown);
        drawOverlay(viewer_, shown, ImGui::GetIO().Framerate);
        ImGui::Render();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        glViewport(0, 0, width, height);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        glfwSwapBuffers(window_);
    }

private:
    using Clock = std::chrono::steady_clock;

    static Window& of(GLFWwindow* window) { return *(Window*) glfwGetWindowUserPointer(window); }

    bool isHeld(int key) const {
        for (const auto& [glfw, ours] : kSpecialKeys)
            if (ours == key) return glfwGetKey(window_, glfw) == GLFW_PRESS;
        return false;
    }

    void press(int key) {
        const KeyBinding* binding = keyBinding(key);
        if (!binding || !binding->press) return;
        viewer_.said.clear();
        binding->press(viewer_);
    }

    void button(bool down) {
        glfwGetCursorPos(window_, &x_, &y_);
        if (down) dragged_ = false;
        if (!down && dragging_ && !dragged_) click();
        dragging_ = down;
    }

    void cursor(double x, double y) {
        if (dragging_) {
            dragView(viewer_, x - x_, y - y_);
            dragged_ = true;
        }
        x_ = x, y_ = y;
    }

    /// The rays that are shown become those of the pixel below the cursor.
    void click() {
        int width = 0, height = 0;
        glfwGetWindowSize(window_, &width, &height);
        if (width < 1 || height < 1) return;
        const double x = x_ / width, y = y_ / height;
        if (viewer_.model.state().ray)
            viewer_.model.change([&](ViewState& s) { showRay(s, x, y); });
    }

    /// The picture at rest has as many pixels as the window.
    void followSize() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        if (width < 1 || height < 1 || !viewer_.model.loaded()) return; // an icon
        const GridSettings grid = viewer_.model.state().settings.grid;
        if (grid.width == width && grid.height == height) return;
        viewer_.model.change(
            [&](ViewState& s) { s.settings.grid.width = width, s.settings.grid.height = height; },
            true);
    }

    /// As large as the window holds it without another shape.
    void drawPicture(const ViewPicture& shown) {
        const Picture& picture = shown.picture;
        if (&shown != uploaded_) {
            glBindTexture(GL_TEXTURE_2D, texture_);
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB,
                         GL_UNSIGNED_BYTE, picture.rgb.data());
            // Pixels of a coarse picture are seen as what they are.
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            uploaded_ = &shown;
        }
        const ImVec2 room = ImGui::GetIO().DisplaySize;
        const float scale =
            std::min(room.x / (float) picture.width, room.y / (float) picture.height);
        const ImVec2 size{(float) picture.width * scale, (float) picture.height * scale};
        const ImVec2 corner{(room.x - size.x) / 2, (room.y - size.y) / 2};
        ImGui::GetBackgroundDrawList()->AddImage(textureId(texture_), corner,
                                                 {corner.x + size.x, corner.y + size.y});
    }

    Viewer& viewer_;
    GLFWwindow* window_ = nullptr;
    GLuint texture_ = 0;
    const ViewPicture* uploaded_ = nullptr;
    bool dragging_ = false, dragged_ = false;
    double x_ = 0.0, y_ = 0.0; ///< of the cursor, pixels
    Clock::time_point last_ = Clock::now();
};

} // namespace

void runViewer(const ViewerOptions& options) {
    if (!options.status.empty()) checkWritable(options.status);
    const Display display;
    ViewModel model(options.common);
    Viewer viewer{model};
    const ImageSize size = options.common.size.value_or(ImageSize{1024, 512});
    Window window(viewer, size.width, size.height, "dirt: " + options.common.scene);
    std::shared_ptr<const ViewPicture> shown; // kept for as long as the window's texture is of it
    while (window.open()) {
        window.takeEvents();
        shown = model.picture();
        window.show(shown.get());
        if (!options.status.empty()) writeStatus(options.status, viewer, shown.get());
    }
}

} // namespace dirt
