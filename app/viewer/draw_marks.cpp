#include "app/viewer/draw_marks.h"

#include <imgui.h>

namespace dirt {

void drawMarksOver(const std::vector<Mark>& marks, const Placement& placed) {
    constexpr float kArm = 5.0f, kRadius = 10.0f;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto at = [&](glm::dvec2 p) {
        const glm::dvec2 window = placed.corner + p * placed.scale;
        return ImVec2((float) window.x, (float) window.y);
    };
    // Dark lines below, as pictures may be bright.
    for (const bool shadows : {true, false})
        for (const Mark& mark : marks) {
            const Colour c = shadows ? Colour(0) : mark.colour;
            const ImU32 colour = IM_COL32(c.x, c.y, c.z, 255);
            const float width = shadows ? 4.0f : 2.0f;
            const ImVec2 from = at(mark.from), to = at(mark.to);
            switch (mark.shape) {
            case Mark::Shape::box:
                list.AddRect(from, to, colour, 0.0f, 0, width);
                break;
            case Mark::Shape::line:
                list.AddLine(from, to, colour, width);
                break;
            case Mark::Shape::cross:
                list.AddLine({from.x - kArm, from.y - kArm}, {from.x + kArm, from.y + kArm}, colour,
                             width);
                list.AddLine({from.x - kArm, from.y + kArm}, {from.x + kArm, from.y - kArm}, colour,
                             width);
                break;
            case Mark::Shape::pixel:
                list.AddRect(from, at(mark.from + 1.0), colour, 0.0f, 0, width);
                list.AddCircle(at(mark.from + 0.5), kRadius, colour, 0, width);
                break;
            }
        }
}

} // namespace dirt
