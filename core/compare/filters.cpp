#include "core/compare/filters.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace dirt {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr size_t kRowsPerPiece = 16;

/// f at -radius … radius.
std::vector<double> sampled(int radius, const std::function<double(double)>& f) {
    std::vector<double> weights;
    for (int i = -radius; i <= radius; ++i) weights.push_back(f(i));
    return weights;
}

double sum(const std::vector<double>& weights) {
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

std::vector<double> scaled(std::vector<double> weights, double factor) {
    for (double& weight : weights) weight *= factor;
    return weights;
}

/// A sensitivity that is a e^(-b f^2) in frequency is a √(π/b) e^(-π² x²/b) in space, x in degrees.
struct Gaussian {
    double a, b;
};

Kernel spatialKernel(const std::vector<Gaussian>& gaussians, int radius, double pixelsPerDegree) {
    Kernel kernel;
    double total = 0.0;
    for (const Gaussian& gaussian : gaussians) {
        const double a = gaussian.a, b = gaussian.b;
        const auto profile = sampled(radius, [&](double x) {
            const double degrees = x / pixelsPerDegree;
            return std::exp(-kPi * kPi * degrees * degrees / b);
        });
        const double height = a * std::sqrt(kPi / b);
        total += height * sum(profile) * sum(profile);
        kernel.push_back({profile, scaled(profile, height)});
    }
    for (KernelTerm& term : kernel) term.y = scaled(term.y, 1.0 / total);
    return kernel;
}

/// Positive weights to sum 1, negative ones to -1.
std::vector<double> balanced(std::vector<double> weights) {
    double positive = 0.0, negative = 0.0;
    for (double weight : weights) (weight > 0.0 ? positive : negative) += weight;
    for (double& weight : weights) weight /= weight > 0.0 ? positive : -negative;
    return weights;
}

void filterRow(const double* in, int width, const std::vector<double>& weights, double* out) {
    const int radius = (int) weights.size() / 2;
    std::vector<double> padded((size_t) width + 2 * radius);
    for (int x = 0; x < (int) padded.size(); ++x)
        padded[x] = in[std::clamp(x - radius, 0, width - 1)];
    std::fill(out, out + width, 0.0);
    for (size_t i = 0; i < weights.size(); ++i)
        for (int x = 0; x < width; ++x) out[x] += weights[i] * padded[x + i];
}

/// Adds one row of the plane filtered along y to \p out.
void addColumns(const Plane& plane, int y, const std::vector<double>& weights, double* out) {
    const int radius = (int) weights.size() / 2;
    for (int i = -radius; i <= radius; ++i) {
        const double weight = weights[i + radius];
        const double* in = plane.row(std::clamp(y + i, 0, plane.height - 1));
        for (int x = 0; x < plane.width; ++x) out[x] += weight * in[x];
    }
}

} // namespace

ContrastSensitivity::ContrastSensitivity(double pixelsPerDegree) {
    // All channels reach as far as the widest Gaussian does at three standard deviations.
    const double deviation = std::sqrt(0.04 / (2.0 * kPi * kPi));
    const int radius = (int) std::ceil(3.0 * deviation * pixelsPerDegree);
    achromatic = spatialKernel({{1.0, 0.0047}}, radius, pixelsPerDegree);
    redGreen = spatialKernel({{1.0, 0.0053}}, radius, pixelsPerDegree);
    blueYellow = spatialKernel({{34.1, 0.04}, {13.5, 0.025}}, radius, pixelsPerDegree);
}

FeatureDetectors::FeatureDetectors(double pixelsPerDegree) {
    const double deviation = 0.5 * 0.082 * pixelsPerDegree;
    const int radius = (int) std::ceil(3.0 * deviation);
    const auto gaussian = [&](double x) {
        return std::exp(-x * x / (2.0 * deviation * deviation));
    };
    auto smooth = sampled(radius, gaussian);
    smooth = scaled(smooth, 1.0 / sum(smooth));
    const auto edge = balanced(sampled(radius, [&](double x) { return x * gaussian(x); }));
    const auto point = balanced(sampled(
        radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * gaussian(x); }));
    edgeX = {{edge, smooth}};
    edgeY = {{smooth, edge}};
    pointX = {{point, smooth}};
    pointY = {{smooth, point}};
}

Plane filtered(const Plane& plane, const Kernel& kernel, Executor& executor) {
    Plane result(plane.width, plane.height), rows(plane.width, plane.height);
    const auto forRows = [&](auto&& body) {
        executor.forRange((size_t) plane.height, kRowsPerPiece, [&](size_t begin, size_t end) {
            for (size_t y = begin; y < end; ++y) body((int) y);
        });
    };
    for (const KernelTerm& term : kernel) {
        forRows([&](int y) { filterRow(plane.row(y), plane.width, term.x, rows.row(y)); });
        forRows([&](int y) { addColumns(rows, y, term.y, result.row(y)); });
    }
    return result;
}

} // namespace dirt
