#pragma once

#include "backend_gl/gl_objects.h"

#include <vector>

namespace dirt {

/// The device's clock around passes. The host does not wait for it: times are asked for later.
class PassTimer {
public:
    PassTimer();

    /// Whether the device has a clock.
    bool works() const { return works_; }

    void begin() { mark(); }
    void end() { mark(); }

    /// Milliseconds of each pass since the last call; waits for the device. Nothing without a
    /// clock, or where a pass has begun and not ended.
    std::vector<double> take();

private:
    struct QueryKind {
        static void destroy(GLuint id) { glDeleteQueries(1, &id); }
    };

    void mark();
    void collect();

    bool works_ = false;
    std::vector<GlObject<QueryKind>> pending_, free_;
    std::vector<GLuint64> marks_; ///< nanoseconds, as far as they have been collected
};

} // namespace dirt
