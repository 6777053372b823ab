#pragma once

#include <epoxy/gl.h>

namespace dirt {

/// While it lives, pixels are drawn whose centres a primitive covers, though conservative
/// rasterization be enabled.
class OrdinaryRaster {
public:
    OrdinaryRaster()
        : conservative_(epoxy_has_gl_extension("GL_NV_conservative_raster") &&
                        glIsEnabled(GL_CONSERVATIVE_RASTERIZATION_NV)) {
        if (conservative_) glDisable(GL_CONSERVATIVE_RASTERIZATION_NV);
    }
    ~OrdinaryRaster() {
        if (conservative_) glEnable(GL_CONSERVATIVE_RASTERIZATION_NV);
    }
    OrdinaryRaster(const OrdinaryRaster&) = delete;
    OrdinaryRaster& operator=(const OrdinaryRaster&) = delete;

private:
    bool conservative_;
};

} // namespace dirt
