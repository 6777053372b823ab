#include "app/viewer/panel.h"

#include "app/viewer/keys.h"

#include <algorithm>
#include <functional>
#include <string>

#include <imgui.h>

namespace dirt {

namespace {

/// A state that widgets change; the model hears of it once.
class Form {
public:
    explicit Form(ViewModel& model) : model_(model), state(model.state()) {}
    /// Passes on what has changed.
    ~Form() {
        if (!edits_.empty())
            model_.change([&](ViewState& s) {
                for (const auto& edit : edits_) edit(s);
            });
    }
    Form(const Form&) = delete;
    Form& operator=(const Form&) = delete;

    template <typename Value>
    using Place = std::function<Value&(ViewState&)>;

    void number(const char* label, int low, int high, const Place<int>& place,
                const char* format = "%d") {
        int value = place(state);
        if (ImGui::SliderInt(label, &value, low, high, format, ImGuiSliderFlags_AlwaysClamp))
            edit<int>(place, value);
    }

    void real(const char* label, float low, float high, const Place<float>& place) {
        float value = place(state);
        if (ImGui::SliderFloat(label, &value, low, high, "%.3g",
                               ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic))
            edit<float>(place, value);
    }

    void flag(const char* label, const Place<bool>& place) {
        bool value = place(state);
        if (ImGui::Checkbox(label, &value)) edit<bool>(place, value);
    }

    /// \p words: one after the other, with a zero behind each and one more at the end.
    template <typename Enum>
    void choice(const char* label, const char* words, const Place<Enum>& place) {
        int value = (int) place(state);
        if (ImGui::Combo(label, &value, words)) edit<Enum>(place, (Enum) value);
    }

    void shown(const char* label) {
        if (!ImGui::BeginCombo(label, state.shown->name)) return;
        for (const PreviewKind& kind : previewKinds())
            if (ImGui::Selectable((std::string(kind.name) + ": " + kind.meaning).c_str(),
                                  state.shown == &kind))
                edits_.push_back([&kind](ViewState& s) { s.shown = &kind; });
        ImGui::EndCombo();
    }

private:
    template <typename Value>
    void edit(const Place<Value>& place, Value value) {
        edits_.push_back([place, value](ViewState& s) { place(s) = value; });
    }

    ViewModel& model_;
    std::vector<std::function<void(ViewState&)>> edits_;

public:
    ViewState state; ///< as it was when the form was made
};

/// What finds hits, and what of them.
void drawStructure(Form& form) {
    using S = ViewState;
    form.choice<BackendKind>(
        "backend", "cpu\0gl\0embree\0", [](S & s) -> auto& { return s.backend; });
    form.choice<ViewMode>(
        "views", "full\0single\0", [](S & s) -> auto& { return s.settings.grid.mode; });
    form.number("tile", 1, kLargestTile, [](S& s) -> int& { return s.settings.grid.tile; });
    form.number("bins", 1, kMostBins, [](S& s) -> int& { return s.settings.grid.bins; });
    form.number(
        "top level", -1, kHighestLevel, [](S& s) -> int& { return s.settings.grid.maxMip; },
        form.state.settings.grid.maxMip < 0 ? "all" : "%d");
    form.choice<Traversal>(
        "traversal", "hierarchical\0linear\0",
        [](S & s) -> auto& { return s.settings.grid.traversal; });
    form.choice<Precision>(
        "precision", "exact\0fast\0", [](S & s) -> auto& { return s.settings.grid.precision; });
    form.choice<Primary>(
        "primary", "raster\0traced\0", [](S & s) -> auto& { return s.settings.primary; });
    form.choice<Fetch>(
        "fetch", "raster\0direct\0", [](S & s) -> auto& { return s.settings.fetch; });
    form.choice<Shading>(
        "shading", "full\0packed\0", [](S & s) -> auto& { return s.settings.shading; });
    const Form::Place<unsigned> threads = [](S& s) -> unsigned& { return s.threads; };
    form.choice<unsigned>("threads", "all\0001\0002\0003\0004\0005\0006\0007\0008\0", threads);
}

void drawLight(Form& form) {
    using S = ViewState;
    form.number("bounces", 1, std::max(16, form.state.settings.bounces),
                [](S& s) -> int& { return s.settings.bounces; });
    form.choice<RayType>(
        "rays", "as materials say\0diffuse\0glossy\0specular\0visibility\0",
        [](S & s) -> auto& { return s.settings.rayType; });
    form.choice<LightVisibility>(
        "light by", "rays\0shadow map\0", [](S & s) -> auto& { return s.settings.visibility; });
    form.flag("progressive", [](S& s) -> bool& { return s.progressive; });
    form.real("key", -4.0f, 4.0f, [](S& s) -> float& { return s.toneMapping.key; });
    form.real("white", 0.01f, 100.0f, [](S& s) -> float& { return s.toneMapping.white; });
}

void drawBuffers(Form& form) {
    using S = ViewState;
    form.shown("shown");
    const std::string_view name = form.state.shown->name;
    if (name == "near" || name == "far")
        form.number("level", 0, kHighestLevel, [](S& s) -> int& { return s.level; });
    if (name == "entries")
        form.number(
            "bin", -1, form.state.settings.grid.bins - 1, [](S& s) -> int& { return s.bin; },
            form.state.bin < 0 ? "all" : "%d");
    if (form.state.shown->of == PreviewKind::Of::event ||
        form.state.shown->of == PreviewKind::Of::point)
        form.number("event", 0, form.state.settings.bounces - 1,
                    [](S& s) -> int& { return s.event; });
}

/// What keys do that is no value, a button each, in their own words.
void drawKeyButtons(Viewer& viewer) {
    constexpr int kButtons[] = {'-', ',', '.', 'F', 'C', 'V', 'Z',
                                'X', 'T', kF8, kF5, kF6, 'R', kF1};
    for (const int key : kButtons) {
        const KeyBinding& binding = *keyBinding(key);
        if (ImGui::SmallButton((std::string(binding.label) + ": " + binding.meaning).c_str())) {
            viewer.said.clear();
            binding.press(viewer);
        }
    }
}

} // namespace

void drawPanel(Viewer& viewer) {
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({room.x - 8, room.y - 8}, ImGuiCond_FirstUseEver, {1.0f, 1.0f});
    if (!ImGui::Begin("settings", &viewer.panel,
                      ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav)) {
        ImGui::End();
        return;
    }
    ImGui::PushItemWidth(160.0f);
    if (viewer.model.loaded()) {
        Form form(viewer.model);
        const ViewModel::Facts facts = viewer.model.facts();
        if (ImGui::CollapsingHeader("structure", ImGuiTreeNodeFlags_DefaultOpen))
            drawStructure(form);
        if (ImGui::CollapsingHeader("light", ImGuiTreeNodeFlags_DefaultOpen)) drawLight(form);
        if (ImGui::CollapsingHeader("buffers", ImGuiTreeNodeFlags_DefaultOpen)) drawBuffers(form);
        if (facts.lastFrame > 0) {
            form.flag("playing", [](ViewState& s) -> bool& { return s.playing; });
            form.number("frame", 0, facts.lastFrame, [](ViewState& s) -> int& { return s.frame; });
        }
    }
    if (ImGui::CollapsingHeader("keys")) drawKeyButtons(viewer);
    ImGui::PopItemWidth();
    ImGui::End();
}

} // namespace dirt
