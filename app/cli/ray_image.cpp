#include "app/cli/ray_image.h"

#include "app/cli/log.h"
#include "core/base/error.h"
#include "core/io/image.h"
#include "core/io/output_file.h"

namespace dirt {

void checkRayImage(const std::string& path) {
    if (imageFormat(path) != ImageFormat::png) throw InputError(path + ": the picture is a PNG");
    checkWritable(path);
}

void writeRayImage(const std::string& path, const Picture& picture, const std::string& title) {
    writePng(path, picture.width, picture.height, picture.rgb, {{"dirt:rays", title}});
    logWritten(path);
}

} // namespace dirt
