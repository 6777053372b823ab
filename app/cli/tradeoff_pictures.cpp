#include "app/cli/tradeoff_pictures.h"

#include "app/cli/log.h"
#include "bench/plot.h"
#include "core/compare/colour_map.h"
#include "core/io/output_file.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

void writePlot(const std::string& file, const Plot& plot) {
    writeFile(file, svgOf(plot));
    logWritten(file);
}

void writePicture(const std::string& file, const Image& image, std::span<const uint8_t> rgb) {
    writePng(file, image.width, image.height, rgb, {});
    logWritten(file);
}

/// Whether the sweep's values are numbers, to be put on an axis.
bool isNumeric(const Sweep& sweep) {
    return std::all_of(sweep.points.begin(), sweep.points.end(), [](const auto& point) {
        return point.first.find_first_not_of("0123456789") == std::string::npos &&
               point.first != "0";
    });
}

/// \p value(settings) over the numeric values of a sweep.
template <typename Value>
PlotSeries seriesOf(const std::string& name, const Sweep& sweep, const TradeoffReport& report,
                    const Value& value) {
    PlotSeries series{name, {}};
    for (const auto& [x, index] : sweep.points)
        series.points.emplace_back(std::stod(x), value(report.settings[index]));
    return series;
}

void plotTimes(const std::string& stem, const Sweep& sweep, const TradeoffReport& report) {
    const auto build = [](const SettingsReport& s) { return s.build.median(); };
    const auto sample = [](const SettingsReport& s) { return s.sample.median(); };
    const Plot plot{"Time against " + sweep.name,
                    sweep.name,
                    "ms",
                    {seriesOf("build", sweep, report, build),
                     seriesOf("one sample", sweep, report, sample),
                     seriesOf("frame of one sample", sweep, report,
                              [&](const SettingsReport& s) { return build(s) + sample(s); })}};
    writePlot(stem + "-time-" + sweep.name + ".svg", plot);
}

/// The name of the settings: the first point that has them.
std::string settingName(size_t index, const Sweeps& sweeps) {
    if (index == 0) return "as given";
    for (const Sweep& sweep : sweeps.sweeps)
        for (const auto& [value, i] : sweep.points)
            if (i == index) return sweep.name + " " + value;
    return {};
}

/// Error against time for the images of as many bounces as the reference; that of others is the
/// truncated paths' and has a reference of its own.
void plotErrors(const std::string& stem, const TradeoffReport& report) {
    Plot plot{"Error against time", "ms", "relative MSE", {}};
    for (size_t i = 0; i < report.settings.size(); ++i) {
        const SettingsReport& settings = report.settings[i];
        const bool sameLength =
            report.sweeps.settings[i].bounces == report.sweeps.settings.front().bounces;
        PlotSeries series{settingName(i, report.sweeps), {}};
        for (const ErrorAt& error : settings.errors)
            if (error.relativeMse > 0.0)
                series.points.emplace_back(settings.build.median() +
                                               error.samples * settings.sample.median(),
                                           error.relativeMse);
        if (sameLength && !series.points.empty()) plot.series.push_back(std::move(series));
    }
    if (!plot.series.empty()) writePlot(stem + "-error.svg", plot);
}

/// |image - reference| over the reference's brightness, from 0 to 1.
std::vector<uint8_t> relativeError(const Image& image, const Image& reference) {
    std::vector<uint8_t> bytes;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const double difference = glm::length(image.pixels[i] - reference.pixels[i]);
        const double brightness = glm::length(reference.pixels[i]) + 1e-3;
        const glm::u8vec3 colour = falseColour(std::min(difference / brightness, 1.0));
        bytes.insert(bytes.end(), {colour.x, colour.y, colour.z});
    }
    return bytes;
}

} // namespace

void writePictures(const std::string& stem, const TradeoffReport& report,
                   const DisplayEncoding& display) {
    Plot memory{"Memory", "tile, or bins", "MB", {}};
    for (const Sweep& sweep : report.sweeps.sweeps) {
        if (!isNumeric(sweep)) continue;
        plotTimes(stem, sweep, report);
        if (sweep.name == "tile" || sweep.name == "bins")
            memory.series.push_back(
                seriesOf(sweep.name, sweep, report,
                         [](const SettingsReport& s) { return (double) s.bytes * 1e-6; }));
    }
    writePlot(stem + "-memory.svg", memory);
    plotErrors(stem, report);
    for (size_t i = 0; i < report.images.size(); ++i) {
        const Image& image = report.images[i];
        if (image.pixels.empty()) continue;
        std::string name = stem + "-" + settingName(i, report.sweeps);
        std::replace(name.begin() + (ptrdiff_t) stem.size(), name.end(), ' ', '-');
        std::replace(name.begin() + (ptrdiff_t) stem.size(), name.end(), '/', '-');
        writePicture(name + ".png", image, display.bytes(image.pixels));
        writePicture(name + "-error.png", image, relativeError(image, report.reference));
    }
}

} // namespace dirt
