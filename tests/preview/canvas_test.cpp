// What is drawn into pictures stands where it should, and nowhere else.

#include "core/preview/canvas.h"

#include "core/preview/font.h"
#include "core/preview/marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace dirt {
namespace {

constexpr Colour kInk{200, 100, 50};

size_t inkIn(const Picture& picture) {
    size_t count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) count += picture.at(x, y) == kInk;
    return count;
}

TEST(Canvas, CutsOffWhatIsOutside) {
    Picture picture(20, 10);
    Canvas canvas(picture);
    canvas.fill({-5, -5, 8, 7}, kInk);
    EXPECT_EQ(inkIn(picture), 3u * 2u);
    Canvas part = canvas.within({10, 5, 100, 2});
    part.fill({0, 0, 100, 100}, kInk);
    EXPECT_EQ(inkIn(picture), 3u * 2u + 10u * 2u);
    part.text(0, 0, "cut off", kInk);
    part.ring({1e30, -1e30}, 5, kInk);
    part.cross({-3.0, 50.0}, 5, kInk);
    EXPECT_EQ(inkIn(picture), 3u * 2u + 10u * 2u);
}

TEST(Canvas, DrawsLinesWithEndsFarAway) {
    Picture picture(20, 10);
    Canvas canvas(picture);
    canvas.line({-1e12, 5.5}, {1e12, 5.5}, kInk);
    EXPECT_EQ(inkIn(picture), 20u);
    for (int x = 0; x < 20; ++x) EXPECT_EQ(picture.at(x, 5), kInk);
    canvas.line({NAN, 0.0}, {1.0, 1.0}, kInk);
    canvas.line({0.0, 0.0}, {INFINITY, 1.0}, kInk);
    canvas.line({0.0, -1e12}, {20.0, -1e11}, kInk);
    EXPECT_EQ(inkIn(picture), 20u);
}

TEST(Canvas, EnlargesAPicture) {
    Picture small(2, 1);
    small.set(1, 0, kInk);
    Picture picture(10, 5);
    Canvas(picture).paste(small, 1, 1, 3);
    EXPECT_EQ(inkIn(picture), 9u);
    EXPECT_EQ(picture.at(4, 1), kInk);
    EXPECT_EQ(picture.at(6, 3), kInk);
    EXPECT_EQ(picture.at(3, 1), Colour(0, 0, 0));
}

/// As it is, and cut off on all sides.
TEST(Canvas, PastesWhatFits) {
    Picture small(4, 3);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 4; ++x) small.set(x, y, Colour(10 + x, 20 + y, 30));
    for (const int left : {-9, -2, 0, 3, 5, 9})
        for (const int top : {-9, -1, 0, 2, 4, 9}) {
            Picture picture(6, 5);
            Canvas(picture).paste(small, left, top);
            for (int y = 0; y < 5; ++y)
                for (int x = 0; x < 6; ++x)
                    EXPECT_EQ(picture.at(x, y), small.holds(x - left, y - top)
                                                    ? small.at(x - left, y - top)
                                                    : Colour(0, 0, 0));
        }
}

/// Lines of marks have dark ones beneath them, for bright pictures; boxes inside.
TEST(Marks, StandOutOfBrightPictures) {
    const Colour bright(250, 250, 250);
    Picture picture(60, 60);
    Canvas canvas(picture);
    canvas.fill({0, 0, 60, 60}, bright);
    drawMarks(canvas, {{Mark::Shape::box, {1, 1}, {2, 2}, kInk}}, {0, 0}, 20);
    EXPECT_EQ(picture.at(19, 30), bright);
    EXPECT_EQ(picture.at(20, 30), kInk);
    EXPECT_EQ(picture.at(21, 30), kInk);
    EXPECT_EQ(picture.at(22, 30), kBackground);
    EXPECT_EQ(picture.at(24, 30), bright);
    canvas.fill({0, 0, 60, 60}, bright);
    drawMarks(canvas, {{Mark::Shape::line, {0, 1}, {3, 1}, kInk}}, {0, 0}, 20);
    EXPECT_EQ(picture.at(30, 20), kInk);
    EXPECT_EQ(picture.at(30, 18), kBackground);
    EXPECT_EQ(picture.at(30, 16), bright);
}

/// Each letter has a shape of its own; one that is not there has a box.
TEST(Font, TellsLettersApart) {
    const auto shapeOf = [](char letter) {
        std::string shape;
        for (int y = 0; y < kGlyphHeight; ++y)
            for (int x = 0; x < kGlyphWidth; ++x) shape += isSet(letter, x, y) ? '#' : '.';
        return shape;
    };
    std::set<std::string> shapes;
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789"
                                ".,:-+=()[]/<>';_ ~";
    for (const char letter : letters) shapes.insert(shapeOf(letter));
    EXPECT_EQ(shapes.size(), letters.size());
    EXPECT_EQ(shapeOf('~'), shapeOf('\xc3'));
    EXPECT_EQ(shapeOf('T').substr(0, 10), "#####..#..");
    EXPECT_EQ(shapeOf('_').substr(35, 5), "#####");
}

} // namespace
} // namespace dirt
