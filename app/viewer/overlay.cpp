#include "app/viewer/overlay.h"

#include "app/viewer/keys.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

#include <imgui.h>

namespace dirt {

namespace {

constexpr ImGuiWindowFlags kPlain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                    ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
constexpr const char* kRayTypes[] = {"as materials say", "diffuse", "glossy", "specular",
                                     "visibility"};

const char* named(bool first, const char* yes, const char* no) {
    return first ? yes : no;
}

/// What is being looked at, and how far it has come.
void drawState(const ViewState& s, const ViewPicture& shown) {
    const GridSettings& grid = s.settings.grid;
    ImGui::Text("%s: %dx%d, %d sample%s%s", shown.done ? "done" : "drawing", shown.width,
                shown.height, shown.samples, shown.samples == 1 ? "" : "s",
                s.progressive ? "" : " (M: progressive)");
    if (shown.error > 0.0) ImGui::Text("error about %.2g %%", 100.0 * shown.error);
    if (!shown.scale.empty()) ImGui::Text("%s: %s", s.shown->name, shown.scale.c_str());
    ImGui::Text("%s view, tile %d, bins %d, levels %s",
                named(grid.mode == ViewMode::full, "full", "single"), grid.tile, grid.bins,
                grid.maxMip < 0 ? "all" : std::to_string(grid.maxMip).c_str());
    ImGui::Text("%d bounces, rays %s, light by %s", s.settings.bounces,
                kRayTypes[(int) s.settings.rayType],
                named(s.settings.visibility == LightVisibility::traced, "rays", "a shadow map"));
    if (s.camera.apertureRadius > 0.0f)
        ImGui::Text("lens %.3g, focus %.3g", s.camera.apertureRadius, s.camera.focalDistance);
}

void drawFacts(const ViewModel::Facts& facts) {
    ImGui::Text("%s: %zu triangles, %zu materials, %zu textures, %zu light%s, %.1f MB",
                facts.name.c_str(), facts.triangles, facts.materials, facts.textures, facts.lights,
                facts.lights == 1 ? "" : "s", (double) facts.bytes / 1e6);
}

/// The times of the last pictures, the newest on the right.
void drawTimes(const std::vector<float>& frames) {
    if (frames.empty()) return;
    const float most = *std::max_element(frames.begin(), frames.end());
    char text[48];
    std::snprintf(text, sizeof text, "0 to %.0f ms", (double) most);
    ImGui::PlotLines("##times", frames.data(), (int) frames.size(), 0, text, 0.0f, most,
                     {320.0f, 48.0f});
}

/// Of the passes, and of the backend's buffers.
void drawTables(const ViewPicture& shown) {
    for (const PassTime& pass : shown.passes)
        ImGui::Text("  %-22s %d %8.2f ms", pass.name.c_str(), pass.event, pass.ms);
    for (const BufferSize& buffer : shown.memory)
        if (buffer.bytes > 0)
            ImGui::Text("  %-24s %8.2f of %8.2f MB", buffer.name.c_str(),
                        (double) buffer.used / 1e6, (double) buffer.bytes / 1e6);
}

uint64_t usedBytes(const std::vector<BufferSize>& buffers) {
    uint64_t sum = 0;
    for (const BufferSize& buffer : buffers) sum += buffer.used;
    return sum;
}

void drawFigures(const Viewer& viewer, const ViewPicture& shown, double framesPerSecond) {
    const ViewModel::Facts facts = viewer.model.facts();
    const ViewState state = viewer.model.state();
    drawFacts(facts);
    ImGui::Text("%s, on %s", nameOf(state.backend), shown.device.c_str());
    if (facts.lastFrame > 0)
        ImGui::Text("frame %d of %d%s", shown.frame, facts.lastFrame,
                    state.playing ? "" : ", paused (Space)");
    drawState(state, shown);
    const double build = totalMs(shown.build);
    ImGui::Text("%.1f ms a sample, with the build; %.0f windows a second", shown.sampleMs,
                framesPerSecond);
    if (!shown.build.empty())
        ImGui::Text("last whole frame: build %.1f ms, the rest %.1f ms", build,
                    totalMs(shown.passes) - build);
    ImGui::Text("%llu list entries, %.1f MB of buffers (%.1f MB used)",
                (unsigned long long) shown.listEntries, (double) totalBytes(shown.memory) / 1e6,
                (double) usedBytes(shown.memory) / 1e6);
    drawTimes(viewer.frames);
    if (viewer.timers) drawTables(shown);
}

/// What the mouse does, beside the keys.
constexpr const char* kMouse[] = {"drag: turn the view", "wheel: zoom",
                                  "right drag: move what is zoomed",
                                  "click: a tile's lists, a pixel's values or (-) its rays"};

/// In as many columns as the window's height asks for.
void drawKeys() {
    const auto keys = keyBindings();
    const float room = ImGui::GetIO().DisplaySize.y - ImGui::GetCursorPosY() - 32;
    const auto lines = (size_t) std::max(1.0f, room / ImGui::GetTextLineHeightWithSpacing());
    const size_t count = keys.size() + std::size(kMouse), columns = (count + lines - 1) / lines;
    const size_t each = (count + columns - 1) / columns;
    if (!ImGui::BeginTable("keys", (int) columns, ImGuiTableFlags_SizingFixedFit)) return;
    for (size_t row = 0; row < each; ++row) {
        ImGui::TableNextRow();
        for (size_t i = row; i < count; i += each) {
            ImGui::TableNextColumn();
            const bool isKey = i < keys.size();
            ImGui::Text("%-5s %s", isKey ? keys[i].label : "mouse",
                        isKey ? keys[i].meaning : kMouse[i - keys.size()]);
        }
    }
    ImGui::EndTable();
}

/// On the right, as long as the window is high.
void drawDetails(const std::string& text) {
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float width = std::min(0.5f * room.x, 80.0f * ImGui::CalcTextSize("0").x);
    ImGui::SetNextWindowPos({room.x - width - 8, 8});
    ImGui::SetNextWindowSize({width, room.y - 64});
    ImGui::SetNextWindowBgAlpha(0.75f);
    ImGui::Begin("details", nullptr,
                 (ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar) |
                     ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::End();
}

/// What is told of the rays and the tile that are asked about.
void drawTold(const Viewer& viewer, const ViewPicture& shown) {
    std::string text;
    if (const PathStep* step = viewer.stepOf(shown)) {
        text = viewer.step == 0 ? "all rays"
                                : "ray " + std::to_string(viewer.step) + " of " +
                                      std::to_string(shown.path.size() - 1);
        text += " (, and . step)\n" + step->text;
    }
    if (!shown.told.empty()) text += (text.empty() ? "" : "\n") + shown.told;
    if (viewer.text && !text.empty()) drawDetails(text);
}

/// At the lower rim, so that it covers nothing that is pointed at above.
void drawUnder(const std::string& text) {
    ImGui::SetNextWindowPos({8, ImGui::GetIO().DisplaySize.y - 8}, ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.6f);
    ImGui::Begin("under", nullptr, kPlain);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
}

} // namespace

void drawOverlay(const Viewer& viewer, const ViewPicture* shown, double framesPerSecond) {
    const std::string problem = viewer.model.problem();
    if (shown) drawTold(viewer, *shown);
    if (viewer.text && !viewer.under.empty()) drawUnder(viewer.under);
    const auto loading = viewer.model.loading();
    const bool isThere = shown && !shown->loading, figures = viewer.text && isThere;
    if (!figures && !viewer.help && problem.empty() && viewer.said.empty() && isThere && !loading)
        return;
    ImGui::SetNextWindowPos({8, 8});
    ImGui::SetNextWindowBgAlpha(0.6f);
    ImGui::Begin("figures", nullptr, kPlain);
    if (loading || (!isThere && problem.empty()))
        ImGui::TextUnformatted(
            loadingText(viewer.model.file(), loading.value_or(LoadingProgress{})).c_str());
    if (!problem.empty()) ImGui::TextColored({1.0f, 0.5f, 0.4f, 1.0f}, "%s", problem.c_str());
    // The list takes the room of the figures: both do not fit into most windows.
    if (figures && !viewer.help) drawFigures(viewer, *shown, framesPerSecond);
    if (!viewer.said.empty()) ImGui::TextUnformatted(viewer.said.c_str());
    if (viewer.help) drawKeys();
    ImGui::End();
}

} // namespace dirt
