#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace dirt {

/// One line of a plot: points in the order of their x.
struct PlotSeries {
    std::string name;
    std::vector<glm::dvec2> points;
};

/// A plot of lines over logarithmic axes. x and y are positive.
struct Plot {
    std::string title, xLabel, yLabel;
    std::vector<PlotSeries> series;
};

/// The plot as an SVG image of 480x320. Equal plots give equal text.
std::string svgOf(const Plot& plot);

} // namespace dirt
