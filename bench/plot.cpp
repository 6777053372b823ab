#include "bench/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace dirt {

namespace {

constexpr int kWidth = 480, kHeight = 320;
constexpr int kLeft = 62, kRight = 458, kTop = 34, kBottom = 260;

/// Told apart by people with any colour vision (Okabe and Ito, "Color Universal Design", 2008).
constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

/// printf to a string.
__attribute__((format(printf, 1, 2))) std::string format(const char* text, ...) {
    char buffer[512];
    va_list arguments;
    va_start(arguments, text);
    std::vsnprintf(buffer, sizeof buffer, text, arguments);
    va_end(arguments);
    return buffer;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '<')
            result += "&lt;";
        else if (c == '&')
            result += "&amp;";
        else
            result += c;
    }
    return result;
}

/// A logarithmic axis from \p low to \p high of the values, drawn from \p begin to \p end.
class Axis {
public:
    Axis(double low, double high, double begin, double end) : begin_(begin), end_(end) {
        low_ = std::log2(low), high_ = std::log2(high);
        const double room = std::max(0.06 * (high_ - low_), 0.1);
        low_ -= room, high_ += room;
    }

    double at(double value) const {
        return begin_ + (end_ - begin_) * (std::log2(value) - low_) / (high_ - low_);
    }

    /// 1, 2 and 5 times powers of ten; only the powers where these would be too many.
    std::vector<double> ticks() const {
        std::vector<double> all, tens;
        for (int exponent = -12; exponent <= 12; ++exponent)
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double value = digit * std::pow(10.0, exponent);
                if (std::log2(value) < low_ || std::log2(value) > high_) continue;
                all.push_back(value);
                if (digit == 1.0) tens.push_back(value);
            }
        return all.size() <= 9 ? all : tens;
    }

private:
    double begin_, end_, low_, high_;
};

/// Ticks at the values themselves where these are few whole numbers, as settings are.
std::vector<double> xTicks(const Plot& plot, const Axis& axis) {
    std::vector<double> values;
    for (const PlotSeries& series : plot.series)
        for (const glm::dvec2& point : series.points) values.push_back(point.x);
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    const bool whole = std::all_of(values.begin(), values.end(),
                                   [](double value) { return value == std::floor(value); });
    return whole && values.size() <= 8 ? values : axis.ticks();
}

std::string text(double x, double y, const char* anchor, const std::string& content,
                 const char* colour = "#333") {
    return format("<text x='%.1f' y='%.1f' text-anchor='%s' fill='%s'>", x, y, anchor, colour) +
           escaped(content) + "</text>\n";
}

std::string line(const PlotSeries& series, const char* colour, const Axis& x, const Axis& y) {
    std::string path, dots;
    for (const glm::dvec2& point : series.points) {
        const double px = x.at(point.x), py = y.at(point.y);
        path += format("%.1f,%.1f ", px, py);
        dots += format("<circle cx='%.1f' cy='%.1f' r='2.6' fill='%s'/>", px, py, colour);
    }
    return "<polyline fill='none' stroke-width='1.6' stroke='" + std::string(colour) +
           "' points='" + path + "'/>\n" + dots + "\n";
}

} // namespace

std::string svgOf(const Plot& plot) {
    glm::dvec2 low(INFINITY), high(-INFINITY);
    for (const PlotSeries& series : plot.series)
        for (const glm::dvec2& point : series.points) {
            low = {std::min(low.x, point.x), std::min(low.y, point.y)};
            high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        }
    const Axis x(low.x, high.x, kLeft, kRight), y(low.y, high.y, kBottom, kTop);

    std::string svg = format("<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d' "
                             "font-family='sans-serif' font-size='11'>\n"
                             "<rect width='%d' height='%d' fill='white'/>\n",
                             kWidth, kHeight, kWidth, kHeight);
    for (const double value : y.ticks()) {
        svg += format("<line x1='%d' x2='%d' y1='%.1f' y2='%.1f' stroke='#ddd'/>\n", kLeft, kRight,
                      y.at(value), y.at(value));
        svg += text(kLeft - 6, y.at(value) + 4, "end", format("%g", value));
    }
    for (const double value : xTicks(plot, x)) {
        svg += format("<line x1='%.1f' x2='%.1f' y1='%d' y2='%d' stroke='#ddd'/>\n", x.at(value),
                      x.at(value), kTop, kBottom);
        svg += text(x.at(value), kBottom + 16, "middle", format("%g", value));
    }
    svg += text(0.5 * (kLeft + kRight), 18, "middle", plot.title, "black");
    svg += text(0.5 * (kLeft + kRight), kBottom + 32, "middle", plot.xLabel);
    svg += format("<g transform='translate(14,%.1f) rotate(-90)'>", 0.5 * (kTop + kBottom)) +
           text(0, 0, "middle", plot.yLabel) + "</g>\n";

    double legend = kLeft;
    for (size_t i = 0; i < plot.series.size(); ++i) {
        const char* colour = kColours[i % kColours.size()];
        svg += line(plot.series[i], colour, x, y);
        svg += text(legend, kHeight - 6, "start", "\u25cf " + plot.series[i].name, colour);
        legend += 22.0 + 6.2 * (double) plot.series[i].name.size();
    }
    return svg + "</svg>\n";
}

} // namespace dirt
