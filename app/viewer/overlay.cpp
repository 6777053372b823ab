#include "app/viewer/overlay.h"

#include "app/viewer/keys.h"

#include <algorithm>
#include <string>

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

void drawFigures(const Viewer& viewer, const ViewPicture& shown, double framesPerSecond) {
    ImGui::Text("%s on %s", viewer.model.sceneName().c_str(), shown.device.c_str());
    drawState(viewer.model.state(), shown);
    const double build = totalMs(shown.build);
    ImGui::Text("%.1f ms a sample, with the build; %.0f windows a second", shown.sampleMs,
                framesPerSecond);
    if (!shown.build.empty())
        ImGui::Text("last whole frame: build %.1f ms, the rest %.1f ms", build,
                    totalMs(shown.passes) - build);
    ImGui::Text("%llu list entries, %.1f MB", (unsigned long long) shown.listEntries,
                shown.bytes / 1e6);
    if (!viewer.timers) return;
    for (const PassTime& pass : shown.passes)
        ImGui::Text("  %-18s %d %8.2f ms", pass.name.c_str(), pass.event, pass.ms);
}

/// In as many columns as the window's height asks for.
void drawKeys() {
    const auto keys = keyBindings();
    const float room = ImGui::GetIO().DisplaySize.y - ImGui::GetCursorPosY() - 32;
    const auto lines = (size_t) std::max(1.0f, room / ImGui::GetTextLineHeightWithSpacing());
    const size_t count = keys.size() + 1, columns = (count + lines - 1) / lines;
    const size_t each = (count + columns - 1) / columns;
    if (!ImGui::BeginTable("keys", (int) columns, ImGuiTableFlags_SizingFixedFit)) return;
    for (size_t row = 0; row < each; ++row) {
        ImGui::TableNextRow();
        for (size_t i = row; i < count; i += each) {
            ImGui::TableNextColumn();
            const bool isKey = i < keys.size();
            ImGui::Text("%-5s %s", isKey ? keys[i].label : "drag",
                        isKey ? keys[i].meaning : "turn the view");
        }
    }
    ImGui::EndTable();
}

} // namespace

void drawOverlay(const Viewer& viewer, const ViewPicture* shown, double framesPerSecond) {
    const std::string problem = viewer.model.problem();
    const auto loading = viewer.model.loading();
    const bool isThere = shown && !shown->loading, figures = viewer.text && isThere;
    if (!figures && !viewer.help && problem.empty() && viewer.said.empty() && isThere && !loading)
        return;
    ImGui::SetNextWindowPos({8, 8});
    ImGui::SetNextWindowBgAlpha(0.6f);
    ImGui::Begin("figures", nullptr, kPlain);
    if (loading || (!isThere && problem.empty()))
        ImGui::TextUnformatted(
            loadingText(viewer.model.options().scene, loading.value_or(LoadingProgress{})).c_str());
    if (!problem.empty()) ImGui::TextColored({1.0f, 0.5f, 0.4f, 1.0f}, "%s", problem.c_str());
    if (figures) drawFigures(viewer, *shown, framesPerSecond);
    if (!viewer.said.empty()) ImGui::TextUnformatted(viewer.said.c_str());
    if (viewer.help) drawKeys();
    ImGui::End();
}

} // namespace dirt
