#include "app/cli/extremes_report.h"

#include "app/cli/verify_report.h"

namespace dirt {

namespace {

/// A count, or a stroke where nothing was counted.
std::string text(const std::optional<uint64_t>& count) {
    return count ? std::to_string(*count) : "-";
}

Json variantsJson(const ExtremeBackendReport& backend) {
    Json json = countsJson(backend.rays);
    json["max_ulp_t_error"] = backend.rays.maxUlpTError;
    json["non_finite_pixels"] = backend.nonFinitePixels;
    json["leaks"] = backend.leaks ? Json(*backend.leaks) : Json();
    json["self_shadows"] = backend.selfShadows ? Json(*backend.selfShadows) : Json();
    return json;
}

} // namespace

void ExtremesSum::add(const ExtremeReport& report) {
    variants++;
    leftOut += !report.leftOut.empty();
    wrong += !report.backends[0].right();
    rays += report.rays;
}

void printExtremesHeader(std::FILE* file) {
    std::fprintf(file, "%-24s %-14s %8s %8s %7s %7s %7s %8s %7s %7s %7s\n", "variant", "", "rays",
                 "hits", "missed", "false", "wrong", "t ulp", "NaN", "leaks", "shadows");
}

void printExtreme(std::FILE* file, const ExtremeReport& report,
                  const std::vector<std::string>& names) {
    const std::string name(report.extreme->name);
    if (!report.leftOut.empty()) {
        std::fprintf(file, "%-24s left out: %s\n", name.c_str(), report.leftOut.c_str());
        return;
    }
    for (size_t b = 0; b < names.size(); ++b) {
        const ExtremeBackendReport& r = report.backends[b];
        std::fprintf(file, "%-24s %-14s %8s %8s %7llu %7llu %7llu %8.3g %7llu %7s %7s\n",
                     b == 0 ? name.c_str() : "", names[b].c_str(),
                     b == 0 ? std::to_string(report.rays).c_str() : "",
                     b == 0 ? std::to_string(report.hits).c_str() : "",
                     (unsigned long long) r.rays.missed, (unsigned long long) r.rays.falseHits,
                     (unsigned long long) r.rays.wrongPrimitive, r.rays.maxUlpTError,
                     (unsigned long long) r.nonFinitePixels, text(r.leaks).c_str(),
                     text(r.selfShadows).c_str());
    }
    std::fflush(file);
}

void printSum(std::FILE* file, const ExtremesSum& sum) {
    std::fprintf(file, "%llu variants, %llu rays: %llu variants wrong",
                 (unsigned long long) sum.variants, (unsigned long long) sum.rays,
                 (unsigned long long) sum.wrong);
    if (sum.leftOut > 0) std::fprintf(file, ", %llu left out", (unsigned long long) sum.leftOut);
    std::fprintf(file, "\n");
}

Json extremeJson(const ExtremeReport& report, const std::vector<std::string>& names) {
    if (!report.leftOut.empty()) return {{"left_out", report.leftOut}};
    Json json{{"triangles", report.triangles}, {"rays", report.rays}, {"hits", report.hits}};
    json.update(variantsJson(report.backends[0]));
    for (size_t b = 1; b < names.size(); ++b)
        json[jsonKey(names[b])] = variantsJson(report.backends[b]);
    return json;
}

} // namespace dirt
