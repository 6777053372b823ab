#pragma once

#include "app/viewer/view_model.h"

#include <string>

namespace dirt {

/// What keys work on: the model, and what the window shows over its picture.
struct Viewer {
    ViewModel& model;
    bool text = true;    ///< figures over the picture
    bool timers = false; ///< among them the time of each pass
    bool help = false;
    bool quit = false;
    std::string said = {}; ///< by the last key that says something

    /// Also on standard error, and in the log.
    void say(const std::string& line);
};

/// Writes what is shown to SCENE-view.png, and the values of an image to SCENE-view.exr; further
/// ones get a number.
void savePicture(Viewer& viewer);

/// Says where the camera stands, as the element of a scene file and as options of the command line.
void logCamera(Viewer& viewer);

} // namespace dirt
