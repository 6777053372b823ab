#pragma once

#include "app/cli/command.h"

namespace dirt {

// Each function adds one command to the program. The command runs in its callback, throws
// InputError or CapabilityError where it cannot go on (main turns them into one line and a
// status), and sets \p status otherwise: 0 done, 1 a check failed, 130 stopped by Ctrl-C.

/// `dirt render SCENE`: renders an image.
void addRender(Command program, int& status);

/// `dirt verify SCENE`: adjudicates rays exactly, beside Embree.
void addVerify(Command program, int& status);

/// `dirt check SCENE`: two backends against each other, buffer by buffer.
void addCheck(Command program, int& status);

/// `dirt compare A B`: figures of how much two images differ.
void addCompare(Command program, int& status);

/// `dirt bench frame SCENE…`: times beside Embree's.
void addBench(Command program, int& status);

/// `dirt bench tradeoff SCENE`: time, memory and error against each choice.
void addBenchTradeoff(Command bench, int& status);

/// `dirt bench scaling`: time against triangles and resolution.
void addBenchScaling(Command bench, int& status);

/// `dirt info SCENE`: what a scene holds and what its structure costs.
void addInfo(Command program, int& status);

/// `dirt dump SCENE`: writes the buffers of a frame.
void addDump(Command program, int& status);

/// `dirt explain SCENE`: one pixel's path, ray by ray; a tile's lists; a primitive's tiles.
void addExplain(Command program, int& status);

/// `dirt preview SCENE`: a buffer as a picture.
void addPreview(Command program, int& status);

/// `dirt view SCENE`: a window on it.
void addView(Command program, int& status);

/// `dirt replay DIR`: judges a dump, and says which pass went wrong first.
void addReplay(Command program, int& status);

/// `dirt generate NAME`: writes a procedural scene's geometry.
void addGenerate(Command program, int& status);

} // namespace dirt
