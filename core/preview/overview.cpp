#include "core/preview/overview.h"

#include "core/dump/dump.h"
#include "core/path/camera_rays.h"
#include "core/preview/paint.h"
#include "core/preview/present.h"
#include "core/preview/sheet.h"
#include "core/preview/view_image.h"

#include <algorithm>

namespace dirt {

namespace {

// Pixels: between pictures, and of the image at least.
constexpr int kSpace = 12, kLeastWidth = 768;

/// Where the pictures stand in the whole.
struct Layout {
    int imageTimes, cellTimes; ///< how many times they are enlarged
    int width, height;
    glm::ivec2 image;              ///< top left corners: of the image,
    std::vector<glm::ivec2> views; ///< of the views; their names stand above them
    int caption;                   ///< y

    Layout(const PreviewPicture& picture, const PreviewPicture& sheet, const Sheet& places,
           size_t viewCount) {
        imageTimes = std::max((kLeastWidth + picture.width - 1) / picture.width, 1);
        const int imageWidth = picture.width * imageTimes;
        const int room = (imageWidth - (places.across - 1) * kSpace) / places.across;
        cellTimes = std::max(room / places.columns, 1);
        const int viewWidth = places.columns * cellTimes, viewHeight = places.rows * cellTimes;
        const int step = viewWidth + kSpace;
        width = std::max({imageWidth, places.across * step - kSpace, captionWidth(sheet),
                          captionWidth(picture)}) +
                2 * kSpace;
        int y = kSpace;
        const auto addRow = [&] {
            const int left = (width - (places.across * step - kSpace)) / 2;
            for (int i = 0; i < places.across; ++i)
                views.emplace_back(left + i * step, y + textHeight());
            y += textHeight() + viewHeight + kSpace;
        };
        addRow();
        image = {(width - imageWidth) / 2, y};
        y += picture.height * imageTimes + kSpace;
        if (viewCount > (size_t) places.across) addRow();
        caption = y;
        height = y + captionHeight(sheet) + captionHeight(picture) + kSpace;
    }
};

/// Whether a point of a view, in tiles, is in it.
bool isIn(const View& view, glm::dvec2 at) {
    return at.x >= 0.0 && at.y >= 0.0 && at.x <= view.columns && at.y <= view.rows;
}

/// The rim of the image as the views see it, in the pixels of a view's picture.
std::vector<Mark> rimOf(const View& view, const CameraRays& camera, int width, int height,
                        int level) {
    constexpr int kPieces = 64; // of a side
    const glm::dvec2 size(width, height);
    const glm::dvec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    std::vector<Mark> marks;
    std::optional<glm::dvec2> last;
    for (int side = 0; side < 4; ++side)
        for (int i = 0; i <= kPieces; ++i) {
            const glm::dvec2 along = corners[side + 1] - corners[side];
            const glm::dvec2 p = size * (corners[side] + along * ((double) i / kPieces));
            const Ray ray = camera.through((float) p.x, (float) p.y);
            auto at = inTiles(view, glm::dvec3(ray.direction));
            if (at && !isIn(view, *at)) at.reset();
            const double cell = (double) (1 << level);
            if (at && last) marks.push_back({Mark::Shape::line, *last / cell, *at / cell, kWords});
            last = at;
        }
    return marks;
}

/// The values of a picture that stands at \p corner, enlarged \p times.
PictureValues placed(PictureValues values, glm::ivec2 corner, int times) {
    values.pixels = {corner.x, corner.y, values.columns() * times, values.rows() * times};
    values.times = times;
    return values;
}

/// The part of a sheet that is one view's.
Picture cutOut(const Picture& sheet, const Sheet& places, size_t view) {
    Picture part(places.columns, places.rows);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x)
            part.set(x, y, sheet.at(places.left(view) + x, places.top(view) + y));
    return part;
}

} // namespace

PreviewPicture drawOverview(const PreviewPicture& image, const PreviewPicture& sheet,
                            const Grid& grid, const Camera& camera, int level) {
    const Sheet places(grid, level);
    const Layout layout(image, sheet, places, grid.views.size());
    PreviewPicture all = blank(layout.width, layout.height);
    all.scale = sheet.scale;
    all.bare = true;
    Canvas canvas(all);
    canvas.fill({0, 0, all.width, all.height}, kBackground);
    const GridSettings& settings = grid.settings;
    const CameraRays rays(camera, settings.width, settings.height, settings.mode);
    for (size_t view = 0; view < grid.views.size(); ++view) {
        const glm::ivec2 at = layout.views[view];
        const Box box{at.x, at.y, places.columns * layout.cellTimes,
                      places.rows * layout.cellTimes};
        canvas.text(at.x, at.y - textHeight() + 4, viewName(grid, view), kFaintWords);
        canvas.paste(cutOut(sheet, places, view), at.x, at.y, layout.cellTimes);
        all.values.push_back(placed(sheet.values[view], at, layout.cellTimes));
        Canvas within = canvas.within(box);
        const glm::dvec2 corner(at);
        if (settings.mode == ViewMode::full)
            drawMarks(within, rimOf(grid.views[view], rays, settings.width, settings.height, level),
                      corner, layout.cellTimes);
        const glm::dvec2 inSheet(places.left(view), places.top(view));
        drawMarks(within, sheet.marks.marks, corner - inSheet * (double) layout.cellTimes,
                  layout.cellTimes);
    }
    canvas.paste(image, layout.image.x, layout.image.y, layout.imageTimes);
    all.values.push_back(placed(image.values.front(), layout.image, layout.imageTimes));
    Canvas within = canvas.within({layout.image.x, layout.image.y, image.width * layout.imageTimes,
                                   image.height * layout.imageTimes});
    drawMarks(within, image.marks.marks, glm::dvec2(layout.image), layout.imageTimes);
    drawCaption(canvas, kSpace, layout.caption, sheet);
    drawCaption(canvas, kSpace, layout.caption + captionHeight(sheet), image);
    return all;
}

} // namespace dirt
