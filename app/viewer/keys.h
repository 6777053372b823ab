#pragma once

#include "app/viewer/viewer.h"

#include <span>
#include <string_view>

namespace dirt {

/// A key: the letter, digit or sign that it is labelled with, or one of these.
enum KeyCode : int {
    kEscape = 256,
    kLeft,
    kRight,
    kUp,
    kDown,
    kPageUp,
    kPageDown,
    kF1,
    kF5,
    kF6,
    kF8,
    kTab,
};

/// What a key does: once when it is pressed, or for as long as it is held.
struct KeyBinding {
    int key;
    const char* label;   ///< as keyboards have it
    const char* meaning; ///< for the list of F1 and for docs/viewer.md
    void (*press)(Viewer& viewer);
    void (*hold)(Viewer& viewer, double seconds) = nullptr;
};

/// All keys, in the order of the list. Those of the demo of 2017 do what they did there.
std::span<const KeyBinding> keyBindings();

/// Null where the key has no meaning.
const KeyBinding* keyBinding(int key);

/// Turns the view as far as a drag over so many pixels of the window says.
void dragView(Viewer& viewer, double right, double down);

} // namespace dirt
