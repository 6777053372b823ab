#include "app/viewer/window.h"

#include "app/viewer/draw_marks.h"
#include "app/viewer/inspect.h"
#include "app/viewer/keys.h"
#include "app/viewer/overlay.h"
#include "app/viewer/panel.h"
#include "app/viewer/placement.h"
#include "app/viewer/status_file.h"
#include "core/base/error.h"
#include "core/io/output_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

#include <glm/common.hpp>

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
                                      {GLFW_KEY_F8, kF8},
                                      {GLFW_KEY_TAB, kTab}};

int keyOf(int glfwKey) {
    const auto special = kSpecialKeys.find(glfwKey);
    return special != kSpecialKeys.end() ? special->second : glfwKey;
}

/// The window is drawn so often at least.
constexpr std::chrono::milliseconds kLongestPause{200};

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
    Window(Viewer& viewer, int width, int height, const std::string& title)
        : viewer_(viewer), title_(title) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
        if (!window_) throw CapabilityError("no window: " + Display::reason());
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_, this);
        // From here on by events: what the mouse has done since is in events that are yet to come.
        glfwGetCursorPos(window_, &cursor_.x, &cursor_.y);
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
            of(window).wake();
            if (action == GLFW_PRESS) of(window).press(keyOf(key));
        });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { of(window).wake(); });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
            of(window).button(button, action == GLFW_PRESS);
        });
        glfwSetScrollCallback(window_,
                              [](GLFWwindow* window, double, double up) { of(window).scroll(up); });
        glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** files) {
            if (count > 0) of(window).viewer_.model.open(files[0]);
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

    /// Of which the window manager is told where it is another one.
    void name(const std::string& title) {
        if (title == title_) return;
        title_ = title;
        glfwSetWindowTitle(window_, title.c_str());
    }

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

    /// Whether there is something new to show: what is drawn in vain takes time from the picture.
    bool isDue(const ViewPicture* shown) {
        const bool isNew = shown != shown_ || awake_ > 0 || Clock::now() - drawn_ > kLongestPause;
        awake_ = std::max(awake_ - 1, 0);
        return isNew;
    }

    /// \p shown stays alive until the next is shown.
    void show(const ViewPicture* shown) {
        drawn_ = Clock::now();
        if (shown && shown != shown_) viewer_.count(*shown);
        shown_ = shown;
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        if (shown) drawPicture(*shown);
        viewer_.under = shown ? lookUnder().text : "";
        drawOverlay(viewer_, shown, ImGui::GetIO().Framerate);
        if (viewer_.panel) drawPanel(viewer_);
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

    /// Widgets take some frames to follow what happens.
    void wake() { awake_ = 4; }

    void press(int key) {
        if (ImGui::GetIO().WantTextInput) return; // a number is being typed
        const KeyBinding* binding = keyBinding(key);
        if (!binding || !binding->press) return;
        viewer_.said.clear();
        binding->press(viewer_);
    }

    /// Whether the mouse is over something that the window shows above its picture.
    static bool isOverWidgets() { return ImGui::GetIO().WantCaptureMouse; }

    void button(int which, bool down) {
        wake();
        if (down && isOverWidgets()) return;
        if (which == GLFW_MOUSE_BUTTON_RIGHT) moving_ = down;
        if (which != GLFW_MOUSE_BUTTON_LEFT) return;
        if (down) dragged_ = false;
        if (!down && dragging_ && !dragged_) click();
        dragging_ = down;
    }

    void cursor(double x, double y) {
        wake();
        const glm::dvec2 by = glm::dvec2(x, y) - cursor_;
        cursor_ = {x, y};
        if (moving_ && shown_) moveZoom(viewer_.zoom, by, sizeOf(*shown_), room());
        if (!dragging_) return;
        dragView(viewer_, by.x, by.y);
        dragged_ = true;
    }

    void scroll(double up) {
        wake();
        if (isOverWidgets() || !shown_) return;
        zoomAt(viewer_.zoom, std::pow(1.25, up), cursor_, sizeOf(*shown_), room());
    }

    void click() {
        viewer_.said.clear();
        const glm::ivec2 pixel = pixelUnder();
        if (shown_) clickPicture(viewer_, *shown_, pixel.x, pixel.y);
    }

    Inspection lookUnder() const {
        if (isOverWidgets() || !glfwGetWindowAttrib(window_, GLFW_HOVERED)) return {};
        const glm::ivec2 pixel = pixelUnder();
        return inspect(*shown_, pixel.x, pixel.y);
    }

    /// Of the picture, below the cursor; maybe none that it has.
    glm::ivec2 pixelUnder() const {
        if (!shown_) return glm::ivec2(-1);
        return glm::ivec2(
            glm::floor(place(sizeOf(*shown_), room(), viewer_.zoom).toPicture(cursor_)));
    }

    static glm::dvec2 sizeOf(const ViewPicture& shown) {
        return {shown.picture.width, shown.picture.height};
    }

    glm::dvec2 room() const {
        glm::ivec2 size(1);
        glfwGetWindowSize(window_, &size.x, &size.y);
        return glm::max(size, glm::ivec2(1)); // an icon has none
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
        const Placement placed = place(sizeOf(shown), room(), viewer_.zoom);
        const glm::dvec2 end = placed.corner + sizeOf(shown) * placed.scale;
        ImGui::GetBackgroundDrawList()->AddImage(textureId(texture_),
                                                 {(float) placed.corner.x, (float) placed.corner.y},
                                                 {(float) end.x, (float) end.y});
        drawMarksOver(shown.marks, placed);
        if (const PathStep* step = viewer_.stepOf(shown)) drawMarksOver(step->marks, placed);
    }

    Viewer& viewer_;
    std::string title_;
    GLFWwindow* window_ = nullptr;
    GLuint texture_ = 0;
    const ViewPicture* uploaded_ = nullptr;
    const ViewPicture* shown_ = nullptr;
    bool dragging_ = false, dragged_ = false; ///< with the left button
    bool moving_ = false;                     ///< with the right one
    glm::dvec2 cursor_{0.0};                  ///< pixels
    Clock::time_point last_ = Clock::now(), drawn_{};
    int awake_ = 4; ///< frames to draw, whatever there is
};

} // namespace

void runViewer(const ViewerOptions& options) {
    if (!options.status.empty()) checkWritable(options.status);
    const Display display;
    ViewModel model(options.common);
    Viewer viewer{model};
    const ImageSize size = options.common.size.value_or(ImageSize{1024, 512});
    const auto title = [&] {
        return options.title.empty() ? "dirt: " + model.file() : options.title;
    };
    Window window(viewer, size.width, size.height, title());
    std::shared_ptr<const ViewPicture> shown; // kept for as long as the window's texture is of it
    while (window.open()) {
        window.takeEvents();
        std::shared_ptr<const ViewPicture> newest = model.picture();
        if (!window.isDue(newest.get())) continue;
        shown = std::move(newest);
        window.name(title());
        window.show(shown.get());
        if (!options.status.empty()) writeStatus(options.status, viewer, shown.get());
    }
}

} // namespace dirt
