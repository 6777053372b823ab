#include "backend_gl/grid_views.h"

#include "core/base/denormals.h"
#include "shaders/shared/grid_parameters.h"

namespace dirt {
namespace {

GridParameters parametersOf(const Grid& grid) {
    GridParameters parameters{};
    for (size_t v = 0; v < grid.views.size(); ++v) {
        const View& view = grid.views[v];
        parameters.viewAxes[v] = {view.axisX, view.axisY, view.axisW, (int) view.signW};
    }
    parameters.columns = grid.views[0].columns;
    parameters.rows = grid.views[0].rows;
    parameters.bins = grid.settings.bins;
    parameters.views = (int) grid.views.size();
    const View& view = grid.views[0];
    const glm::vec2 size = glm::vec2(view.width, view.height) * (0.5f / (float) grid.settings.tile);
    parameters.tilesOfSlope = {size / glm::vec2(view.s.back(), view.t.back()), size};
    return parameters;
}

/// (lo, hi) of each column, then of each row. All views of a frame have the same borders.
std::vector<float> bordersOf(const View& view) {
    std::vector<float> borders;
    const auto add = [&borders](const std::vector<float>& lo, const std::vector<float>& hi) {
        for (size_t i = 0; i < lo.size(); ++i) {
            borders.push_back(flushed(lo[i]));
            borders.push_back(flushed(hi[i]));
        }
    };
    add(view.sLo, view.sHi);
    add(view.tLo, view.tHi);
    return borders;
}

} // namespace

void GridViews::set(const Grid& grid) {
    const GridParameters parameters = parametersOf(grid);
    const View& view = grid.views[0];
    const std::vector<float> borders = bordersOf(view);
    std::vector<float> slopes = view.s;
    slopes.insert(slopes.end(), view.t.begin(), view.t.end());
    parameters_ = GlBuffer(sizeof parameters, &parameters);
    borders_ = TexelBuffer(GL_RG32F, 2 * sizeof(float), borders.size() * sizeof(float),
                           borders.data(), "borders of tiles");
    slopes_ = TexelBuffer(GL_R32F, sizeof(float), slopes.size() * sizeof(float), slopes.data(),
                          "borders of tiles");
    setAtEye({});
    bind();
}

void GridViews::setAtEye(std::vector<uint32_t> ids) {
    atEye_ = std::move(ids);
    atEyeIds_ = TexelBuffer(GL_R32UI, sizeof(uint32_t), atEye_.size() * sizeof(uint32_t),
                            atEye_.data(), "triangles at the eye");
}

void GridViews::bind() const {
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, parameters_.id());
    glBindTextureUnit(0, borders_.texture());
    glBindTextureUnit(1, slopes_.texture());
}

} // namespace dirt
