#include "scenes/generate/profile.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt::generate {

Vec2 Profile::Piece::at(double t) const {
    const auto spans = static_cast<int>(controls.size()) - 1;
    const int span = std::min(static_cast<int>(t * spans), spans - 1);
    const double s = t * spans - span;
    const auto control = [this](int k) {
        return controls[static_cast<std::size_t>(
            std::clamp(k, 0, static_cast<int>(controls.size()) - 1))];
    };
    const Vec2 p0 = control(span - 1);
    const Vec2 p1 = control(span);
    const Vec2 p2 = control(span + 1);
    const Vec2 p3 = control(span + 2);
    if (spans == 1) {
        return p1 + (p2 - p1) * s;
    }
    return 0.5 * (2.0 * p1 + (p2 - p0) * s + (2.0 * p0 - 5.0 * p1 + 4.0 * p2 - p3) * (s * s) +
                  (3.0 * p1 - p0 - 3.0 * p2 + p3) * (s * s * s));
}

Profile& Profile::add(std::vector<Vec2> controls, double steps) {
    Piece piece{std::move(controls), steps, 0};
    Vec2 previous = piece.at(0);
    for (int k = 1; k <= 32; ++k) {
        const Vec2 next = piece.at(k / 32.0);
        piece.length += glm::distance(previous, next);
        previous = next;
    }
    end_ = piece.controls.back();
    pieces_.push_back(std::move(piece));
    return *this;
}

Profile& Profile::line(Vec2 to) {
    return add({end_, to}, 1);
}

Profile& Profile::bow(Vec2 to, double bulge) {
    const Vec2 chord = to - end_;
    const Vec2 side(chord.y, -chord.x);
    std::vector<Vec2> controls;
    constexpr int spans = 8;
    for (int k = 0; k <= spans; ++k) {
        const double angle = std::numbers::pi * k / spans;
        controls.push_back(end_ + chord * (0.5 - 0.5 * std::cos(angle)) +
                           side * (bulge * std::sin(angle)));
    }
    controls.back() = to;
    return add(std::move(controls), 4);
}

Profile& Profile::cyma(Vec2 to, double strength) {
    const Vec2 chord = to - end_;
    const Vec2 side(chord.y, -chord.x);
    std::vector<Vec2> controls;
    constexpr int spans = 8;
    for (int k = 0; k <= spans; ++k) {
        const double t = static_cast<double>(k) / spans;
        controls.push_back(end_ + chord * t +
                           side * (strength * 0.5 * std::sin(2 * std::numbers::pi * t)));
    }
    controls.back() = to;
    return add(std::move(controls), 4);
}

Profile& Profile::spline(std::vector<Vec2> through) {
    through.insert(through.begin(), end_);
    const double steps = 2.0 * static_cast<double>(through.size() - 1);
    return add(std::move(through), steps);
}

double Profile::length() const {
    double sum = 0;
    for (const Piece& piece : pieces_) {
        sum += piece.length;
    }
    return sum;
}

} // namespace dirt::generate
