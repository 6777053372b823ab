#include "app/cli/verify_report.h"

#include "app/cli/again.h"
#include "core/base/finite.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

std::string primitiveText(uint32_t id) {
    return id == kNoPrimitive ? "none" : std::to_string(id);
}

} // namespace

const char* word(Grade grade) {
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

void printWrongAnswers(std::FILE* file, const std::vector<WrongAnswer>& answers) {
    for (const WrongAnswer& wrong : answers) {
        const glm::vec3 o = wrong.ray.origin, d = wrong.ray.direction;
        std::fprintf(file, "%s: ray %u of kind %s, in the grid frame:\n", word(wrong.grade),
                     wrong.index, std::string(rayKindName(wrong.kind)).c_str());
        std::fprintf(file, "  origin %a %a %a  direction %a %a %a  skip %s\n", o.x, o.y, o.z, d.x,
                     d.y, d.z, primitiveText(wrong.ray.skip).c_str());
        if (wrong.maxT)
            std::fprintf(file, "  asked for any hit before t %a, given: %s;", *wrong.maxT,
                         wrong.grade == Grade::missed ? "none" : "there is one");
        else
            std::fprintf(file, "  given: primitive %s, t %a;",
                         primitiveText(wrong.given.primitive).c_str(), wrong.given.t);
        std::fprintf(
            file, "  exact: primitive %s, t %.17g\n",
            primitiveText(wrong.truth.found() ? wrong.truth.primitives[0] : kNoPrimitive).c_str(),
            wrong.truth.t);
    }
}

void printAgain(std::FILE* file, const std::string& command) {
    std::fprintf(file, "  again: %s\n", command.c_str());
}

void printLook(std::FILE* file, const CommonOptions& options, const Input& input,
               const WrongAnswer& wrong) {
    if (!isFinite(wrong.ray.origin) || !isFinite(wrong.ray.direction)) return; // no option has it
    const glm::vec3 o = wrong.ray.origin, d = wrong.ray.direction;
    char ray[160];
    std::snprintf(ray, sizeof ray, " --ray=%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", (double) o.x,
                  (double) o.y, (double) o.z, (double) d.x, (double) d.y, (double) d.z);
    std::string command = commandStart("explain", options.scene) + ray;
    if (wrong.ray.skip != kNoPrimitive) command += " --skip " + std::to_string(wrong.ray.skip);
    char limit[32] = "";
    if (wrong.maxT) std::snprintf(limit, sizeof limit, " --max-t %.9g", (double) *wrong.maxT);
    command += std::string(limit) + " --backend " + nameOf(options.backend);
    std::fprintf(file, "  look: %s%s\n", command.c_str(), structureOptions(input, options).c_str());
}

std::string verifyCommand(const CommonOptions& options, const Input& input,
                          const VerifySettings& settings) {
    std::string command = commandStart("verify", options.scene) + " --backend ";
    command += nameOf(options.backend);
    command += " --rays " + std::to_string(settings.rays);
    command += " --seed " + std::to_string(settings.seed);
    return command + structureOptions(input, options);
}

std::vector<std::string> verifiedNames(const std::vector<Tracer*>& backends) {
    std::vector<std::string> names;
    for (const Tracer* backend : backends) names.push_back(backend->name());
    names[0] = "dirt " + names[0];
    return names;
}

std::string jsonKey(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

Json countsJson(const BackendReport& backend) {
    return {{"missed", backend.missed},
            {"false_hits", backend.falseHits},
            {"wrong_primitive", backend.wrongPrimitive},
            {"max_relative_t_error", backend.maxRelativeTError},
            {"trace_ms", backend.traceMs}};
}

Json kindJson(const KindReport& report, const std::vector<std::string>& names) {
    Json json{{"rays", report.rays}};
    json.update(countsJson(report.backends[0]));
    json["outside_view"] = report.outside;
    json["disagreed"] = report.disagreed;
    json["agreed_and_judged"] = report.agreed;
    for (size_t b = 1; b < names.size(); ++b)
        json[jsonKey(names[b])] = countsJson(report.backends[b]);
    return json;
}

} // namespace dirt
