#pragma once

#include "core/io/image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

/// FLIP read off the paper's formulas: pixel by pixel, with whole two-dimensional kernels and the
/// paper's tabulated colour matrices. It shares no code with core/compare.
namespace dirt::test {

class NaiveFlip {
public:
    NaiveFlip(const Image& a, const Image& b) : width_(a.width), height_(a.height) {
        const double pi = std::acos(-1.0), ppd = 0.7 * 3840 / 0.7 * pi / 180;
        const int radius = (int) std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd);
        const auto sensitivity = [&](double a1, double b1, double a2, double b2) {
            return make(radius, [=](double x, double y) {
                const double z = (x * x + y * y) / (ppd * ppd);
                return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * z / b1) +
                       a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * z / b2);
            });
        };
        csf_ = {sensitivity(1, 0.0047, 0, 1e-5), sensitivity(1, 0.0053, 0, 1e-5),
                sensitivity(34.1, 0.04, 13.5, 0.025)};
        const double sd = 0.5 * 0.082 * ppd;
        const int reach = (int) std::ceil(3 * sd);
        edge_ = make(reach, [=](double x, double y) {
            return -x * std::exp(-(x * x + y * y) / (2 * sd * sd));
        });
        point_ = make(reach, [=](double x, double y) {
            return (x * x / (sd * sd) - 1) * std::exp(-(x * x + y * y) / (2 * sd * sd));
        });
        first_ = opponentOf(a);
        second_ = opponentOf(b);
    }

    double at(int x, int y) const {
        const double distance = std::pow(hyab(seen(first_, x, y), seen(second_, x, y)), 0.7);
        const double farthest = std::pow(hyab(hunt({0, 1, 0}), hunt({0, 0, 1})), 0.7);
        const double knee = 0.4 * farthest;
        const double colour = distance < knee ? 0.95 / knee * distance
                                              : 0.95 + (distance - knee) / (farthest - knee) * 0.05;
        const double edges = strength(first_, edge_, x, y) - strength(second_, edge_, x, y);
        const double points = strength(first_, point_, x, y) - strength(second_, point_, x, y);
        const double feature =
            std::sqrt(std::max(std::abs(edges), std::abs(points)) / std::sqrt(2.0));
        return std::pow(colour, 1 - feature);
    }

private:
    using Colour = std::array<double, 3>;
    using Picture = std::vector<Colour>;

    struct Weights {
        int radius;
        std::vector<double> values;
        double at(int x, int y) const {
            return values[(size_t) ((y + radius) * (2 * radius + 1) + x + radius)];
        }
    };

    /// Weights whose positive ones sum to 1 and whose negative ones sum to -1.
    static Weights make(int radius, const std::function<double(double, double)>& f) {
        Weights weights{radius, {}};
        double positive = 0, negative = 0;
        for (int y = -radius; y <= radius; ++y)
            for (int x = -radius; x <= radius; ++x) {
                weights.values.push_back(f(x, y));
                (f(x, y) > 0 ? positive : negative) += f(x, y);
            }
        for (double& weight : weights.values) weight /= weight > 0 ? positive : -negative;
        return weights;
    }

    static Colour multiply(const double m[3][3], const Colour& c) {
        Colour result{};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) result[i] += m[i][j] * c[j];
        return result;
    }

    /// XYZ over that of white.
    static Colour relativeXyz(const Colour& linear) {
        constexpr double kMatrix[3][3] = {
            {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
            {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
            {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
        const Colour xyz = multiply(kMatrix, linear), white = multiply(kMatrix, {1, 1, 1});
        return {xyz[0] / white[0], xyz[1] / white[1], xyz[2] / white[2]};
    }

    static Colour hunt(const Colour& linear) {
        Colour p = relativeXyz(linear);
        for (double& t : p)
            t = t > std::pow(6.0 / 29, 3) ? std::pow(t, 1.0 / 3) : t * 841 / 108 + 4.0 / 29;
        const double lightness = 116 * p[1] - 16;
        return {lightness, lightness / 100 * 500 * (p[0] - p[1]),
                lightness / 100 * 200 * (p[1] - p[2])};
    }

    static double hyab(const Colour& a, const Colour& b) {
        return std::abs(a[0] - b[0]) +
               std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
    }

    static Picture opponentOf(const Image& image) {
        Picture picture;
        for (const glm::vec3& pixel : image.pixels) {
            const Colour p = relativeXyz({pixel.r, pixel.g, pixel.b});
            picture.push_back({116 * p[1] - 16, 500 * (p[0] - p[1]), 200 * (p[1] - p[2])});
        }
        return picture;
    }

    double sum(const Picture& picture, const Weights& weights, int channel, int x, int y,
               bool turned = false) const {
        double result = 0;
        for (int j = -weights.radius; j <= weights.radius; ++j)
            for (int i = -weights.radius; i <= weights.radius; ++i) {
                const int column = std::clamp(x + i, 0, width_ - 1);
                const int row = std::clamp(y + j, 0, height_ - 1);
                result += (turned ? weights.at(j, i) : weights.at(i, j)) *
                          picture[(size_t) (row * width_ + column)][(size_t) channel];
            }
        return result;
    }

    Colour seen(const Picture& picture, int x, int y) const {
        // The inverse of the matrix above, as tabulated, to nine digits.
        constexpr double kInverse[3][3] = {{3.241003275, -1.537398934, -0.498615861},
                                           {-0.969224334, 1.875930071, 0.041554224},
                                           {0.055639423, -0.204011202, 1.057148933}};
        const double lightness = (sum(picture, csf_[0], 0, x, y) + 16) / 116;
        const Colour xyz = {(lightness + sum(picture, csf_[1], 1, x, y) / 500) * 0.950428545,
                            lightness,
                            (lightness - sum(picture, csf_[2], 2, x, y) / 200) * 1.088900371};
        Colour linear = multiply(kInverse, xyz);
        for (double& value : linear) value = std::clamp(value, 0.0, 1.0);
        return hunt(linear);
    }

    /// Of a feature in the achromatic channel, scaled to [0, 1]; its constant part cancels.
    double strength(const Picture& picture, const Weights& weights, int x, int y) const {
        return std::hypot(sum(picture, weights, 0, x, y), sum(picture, weights, 0, x, y, true)) /
               116;
    }

    int width_, height_;
    std::array<Weights, 3> csf_;
    Weights edge_, point_;
    Picture first_, second_;
};

} // namespace dirt::test
