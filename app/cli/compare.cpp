#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/log.h"
#include "app/cli/thread_limit.h"
#include "core/base/error.h"
#include "core/base/finite.h"
#include "core/compare/colour.h"
#include "core/compare/colour_map.h"
#include "core/compare/differences.h"
#include "core/compare/flip.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace dirt {

namespace {

struct CompareOptions {
    std::string image, reference, diff;
    bool json = false;
};

/// Everything that is said of two images.
struct Comparison {
    Differences differences;
    uint64_t nonFinite = 0, nonFiniteReference = 0;
    Plane flip;
    double meanFlip = 0.0; ///< over the compared pixels
};

/// Both formats hold other quantities; with unlike ones there is nothing to subtract.
ImageFormat formatOf(const CompareOptions& options) {
    const ImageFormat format = imageFormat(options.image);
    if (imageFormat(options.reference) != format)
        throw InputError(options.image + " and " + options.reference +
                         ": a PNG holds display values and an EXR radiance; compare two of a kind");
    return format;
}

void requireEqualSize(const CompareOptions& options, const Image& a, const Image& b) {
    const auto size = [](const Image& image) {
        return std::to_string(image.width) + "x" + std::to_string(image.height);
    };
    if (a.width != b.width || a.height != b.height)
        throw InputError(options.image + " has " + size(a) + " pixels and " + options.reference +
                         " " + size(b) + ": images of different sizes cannot be compared");
}

/// What FLIP is given: linear, and black in both images where a pixel is left out.
std::pair<Image, Image> flipInput(const Image& image, const Image& reference, ImageFormat format) {
    std::pair<Image, Image> result(image, reference);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (Image* each : {&result.first, &result.second}) {
            glm::vec3& pixel = each->pixels[i];
            if (!isFinite(image.pixels[i]) || !isFinite(reference.pixels[i]))
                pixel = glm::vec3(0.0f);
            else if (format == ImageFormat::png)
                for (int c = 0; c < 3; ++c) pixel[c] = (float) decodeSrgb((double) pixel[c]);
        }
    return result;
}

Comparison compare(const Image& image, const Image& reference, ImageFormat format) {
    Comparison result;
    result.differences = differencesOf(image, reference);
    result.nonFinite = countNonFinite(image);
    result.nonFiniteReference = countNonFinite(reference);
    const auto executor = makeExecutor({});
    const auto [a, b] = flipInput(image, reference, format);
    result.flip = format == ImageFormat::png ? flip(a, b, *executor) : hdrFlip(a, b, *executor);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        if (isFinite(image.pixels[i]) && isFinite(reference.pixels[i]))
            result.meanFlip += result.flip.values[i];
    result.meanFlip /= (double) std::max<uint64_t>(result.differences.pixels, 1);
    return result;
}

/// The FLIP map in false colours; green, which the map has not, where pixels are left out.
void writeDiff(const std::string& path, const Comparison& comparison, const Image& image,
               const Image& reference) {
    std::vector<uint8_t> rgb;
    rgb.reserve(image.pixels.size() * 3);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const bool compared = isFinite(image.pixels[i]) && isFinite(reference.pixels[i]);
        const glm::u8vec3 colour =
            compared ? falseColour(comparison.flip.values[i]) : glm::u8vec3(0, 255, 0);
        rgb.insert(rgb.end(), {colour.r, colour.g, colour.b});
    }
    writePng(path, image.width, image.height, rgb, {});
}

/// The number, or null where there is none: infinite, or nothing was compared.
Json numberOrNull(double value, bool exists) {
    return exists ? Json(value) : Json(nullptr);
}

Json comparisonReport(const CompareOptions& options, const Image& image,
                      const Comparison& comparison, ImageFormat format) {
    const Differences& d = comparison.differences;
    const bool any = d.pixels > 0;
    Json report;
    report["image"] = options.image;
    report["reference"] = options.reference;
    report["size"] = {image.width, image.height};
    report["values"] = format == ImageFormat::png ? "display" : "linear";
    report["compared"] = d.pixels;
    report["not_finite"] = {{"image", comparison.nonFinite},
                            {"reference", comparison.nonFiniteReference}};
    report["rmse"] = numberOrNull(d.rmse, any);
    report["relative_mse"] = numberOrNull(d.relativeMse, any);
    report["psnr"] = numberOrNull(d.psnr(), any && d.rmse > 0.0);
    report["peak"] = numberOrNull(d.peak, any);
    report["max"] = numberOrNull(d.max, any);
    report["max_at"] = {d.x, d.y};
    report["flip"] = numberOrNull(comparison.meanFlip, any);
    return report;
}

void print(const CompareOptions& options, const Image& image, const Comparison& comparison,
           ImageFormat format) {
    const Differences& d = comparison.differences;
    std::printf("%s against %s, %dx%d, %s\n", options.image.c_str(), options.reference.c_str(),
                image.width, image.height,
                format == ImageFormat::png ? "display values" : "linear radiance");
    if (d.pixels == 0) return;
    std::printf("  RMSE          %.6g\n", d.rmse);
    std::printf("  relative MSE  %.6g\n", d.relativeMse);
    if (d.rmse > 0.0)
        std::printf("  PSNR          %.2f dB, peak %.6g\n", d.psnr(), d.peak);
    else
        std::printf("  PSNR          infinite: all values are equal\n");
    std::printf("  max           %.6g", d.max);
    if (d.max > 0.0) std::printf(" at (%d, %d), %c", d.x, d.y, "RGB"[d.channel]);
    std::printf("\n  %-13s %.6g\n", format == ImageFormat::png ? "FLIP" : "HDR-FLIP",
                comparison.meanFlip);
}

/// Whether all pixels could be compared.
bool runCompare(const CompareOptions& options) {
    const ImageFormat format = formatOf(options);
    spareThreads();
    noteInput(options.image);
    noteInput(options.reference);
    if (!options.diff.empty()) {
        if (imageFormat(options.diff) != ImageFormat::png)
            throw InputError(options.diff + ": the picture of --diff has to end in .png");
        checkWritable(options.diff);
    }
    const Image image = readImage(options.image), reference = readImage(options.reference);
    requireEqualSize(options, image, reference);
    const Comparison comparison = compare(image, reference, format);

    if (!options.diff.empty()) {
        writeDiff(options.diff, comparison, image, reference);
        logWritten(options.diff);
    }
    if (options.json)
        std::printf("%s\n", comparisonReport(options, image, comparison, format).dump(2).c_str());
    else
        print(options, image, comparison, format);

    const uint64_t leftOut = image.pixels.size() - comparison.differences.pixels;
    if (leftOut > 0)
        sayError(std::to_string(leftOut) + " of " + std::to_string(image.pixels.size()) +
                 " pixels are NaN or infinite and left out: " +
                 std::to_string(comparison.nonFinite) + " in " + options.image + ", " +
                 std::to_string(comparison.nonFiniteReference) + " in " + options.reference);
    return leftOut == 0;
}

} // namespace

void addCompare(Command program, int& status) {
    const Command command = program.addCommand(
        "compare", "RMSE, relative MSE, PSNR, largest difference and FLIP of two images");
    const auto options = std::make_shared<CompareOptions>();
    command.addText("A", options->image, "image: two PNGs, or two EXRs").required();
    command.addText("B", options->reference, "the reference it is compared with").required();
    command.addText("--diff", options->diff, "write FLIP per pixel in false colours: a PNG");
    command.addFlag("--json", options->json, "print one JSON object on standard output");
    command.onRun([options, &status] { status = runCompare(*options) ? 0 : 1; });
}

} // namespace dirt
