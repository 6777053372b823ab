#include "app/cli/verify_report.h"

#include "app/cli/structure_options.h"

#include <algorithm>

namespace dirt {

namespace {

const char* describe(Grade grade) {
    switch (grade) {
    case Grade::right:
        return "right";
    case Grade::missed:
        return "missed";
    case Grade::falseHit:
        return "false hit";
    case Grade::wrongPrimitive:
        return "wrong primitive";
    }
    return "";
}

/// The command that casts the same rays, with everything said that shapes them.
std::string commandFor(RayKind kind, const std::string& scene, const Input& input,
                       const VerifySettings& settings) {
    std::string command = "dirt verify " + scene;
    command += " --kinds " + std::string(rayKindName(kind));
    command += " --rays " + std::to_string(settings.rays);
    command += " --seed " + std::to_string(settings.seed);
    return command + structureOptions(input);
}

Json countsJson(const BackendReport& backend) {
    return {{"missed", backend.missed},
            {"false_hits", backend.falseHits},
            {"wrong_primitive", backend.wrongPrimitive},
            {"max_relative_t_error", backend.maxRelativeTError},
            {"trace_ms", backend.traceMs}};
}

} // namespace

void printVerifyHeader(std::FILE* file) {
    std::fprintf(file, "%-8s %-14s %9s %9s %9s %9s %12s %10s\n", "kind", "", "rays", "missed",
                 "false", "wrong", "max t error", "ms");
}

void printKind(std::FILE* file, const KindReport& report, const std::vector<std::string>& names) {
    for (size_t b = 0; b < names.size(); ++b) {
        const BackendReport& r = report.backends[b];
        const std::string kind(b == 0 ? rayKindName(report.kind) : "");
        const std::string rays = b == 0 ? std::to_string(report.rays) : "";
        std::fprintf(file, "%-8s %-14s %9s %9llu %9llu %9llu %12.3g %10.1f\n", kind.c_str(),
                     names[b].c_str(), rays.c_str(), (unsigned long long) r.missed,
                     (unsigned long long) r.falseHits, (unsigned long long) r.wrongPrimitive,
                     r.maxRelativeTError, r.traceMs);
    }
    std::fflush(file);
}

void printWrongAnswers(std::FILE* file, const KindReport& report, const std::string& scene,
                       const Input& input, const VerifySettings& settings) {
    for (const WrongAnswer& wrong : report.wrong) {
        const auto primitive = [](uint32_t id) {
            return id == kNoPrimitive ? std::string("none") : std::to_string(id);
        };
        const glm::vec3 o = wrong.ray.origin, d = wrong.ray.direction;
        std::fprintf(file, "%s: ray %u of kind %s, in the grid frame:\n", describe(wrong.grade),
                     wrong.index, std::string(rayKindName(wrong.kind)).c_str());
        std::fprintf(file, "  origin %a %a %a  direction %a %a %a  skip %s\n", o.x, o.y, o.z, d.x,
                     d.y, d.z, primitive(wrong.ray.skip).c_str());
        std::fprintf(
            file, "  given: primitive %s, t %a;  exact: primitive %s, t %.17g\n",
            primitive(wrong.given.primitive).c_str(), wrong.given.t,
            primitive(wrong.truth.found() ? wrong.truth.primitives[0] : kNoPrimitive).c_str(),
            wrong.truth.t);
    }
    if (!report.wrong.empty())
        std::fprintf(file, "  again: %s\n",
                     commandFor(report.kind, scene, input, settings).c_str());
}

Json kindJson(const KindReport& report, const std::vector<std::string>& names) {
    Json json{{"rays", report.rays}};
    json.update(countsJson(report.backends[0]));
    json["outside_view"] = report.outside;
    json["disagreed"] = report.disagreed;
    json["agreed_and_judged"] = report.agreed;
    for (size_t b = 1; b < names.size(); ++b) {
        std::string key = names[b];
        std::replace(key.begin(), key.end(), ' ', '_');
        json[key] = countsJson(report.backends[b]);
    }
    return json;
}

} // namespace dirt
