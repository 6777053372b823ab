#pragma once

namespace dirt {

/// Where no more threads can be made (a limit on processes, or memory), libraries that would make
/// their own, and end or hang the program without them, are told to do with the caller's. To be
/// called before they are used.
void spareThreads();

} // namespace dirt
