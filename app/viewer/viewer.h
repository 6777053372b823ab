#pragma once

#include "app/viewer/placement.h"
#include "app/viewer/view_model.h"

#include <string>
#include <vector>

namespace dirt {

/// What keys work on: the model, and what the window shows over its picture.
struct Viewer {
    ViewModel& model;
    bool text = true;    ///< figures over the picture
    bool timers = false; ///< among them the time of each pass
    bool help = false;
    bool panel = false; ///< what keys do, for the mouse
    bool quit = false;
    Zoom zoom = {};
    int step = 0;                   ///< of the path that is shown; 0: all rays
    std::string under = {};         ///< the cursor: the values there
    std::string said = {};          ///< by the last key that says something
    std::vector<float> frames = {}; ///< milliseconds of the last pictures' samples

    /// Also on standard error, and in the log.
    void say(const std::string& line);
    /// That is shown of a picture's path; null: it has none.
    const PathStep* stepOf(const ViewPicture& picture) const;
    /// Takes down how long a new picture took.
    void count(const ViewPicture& picture);
};

/// Writes what is shown to SCENE-view.png, and its values to SCENE-view.exr; further ones get a
/// number.
void savePicture(Viewer& viewer);

/// Says where the camera stands, as the element of a scene file and as options of the command line.
void logCamera(Viewer& viewer);

/// Acts on a click on a pixel of what is shown: where rays are drawn they become those of the pixel
/// there; of a tile all lists are told; of anything else its values.
void clickPicture(Viewer& viewer, const ViewPicture& shown, int x, int y);

} // namespace dirt
