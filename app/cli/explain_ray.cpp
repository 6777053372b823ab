#include "app/cli/explain_ray.h"

#include "app/cli/explain_json.h"
#include "app/cli/explain_text.h"
#include "app/cli/ray_image.h"
#include "app/cli/verify_report.h"
#include "core/verify/judge.h"
#include "core/verify/view_scope.h"
#include "shaders/shared/margins.h"

#include <cmath>
#include <cstdio>
#include <span>
#include <string>

namespace dirt {

namespace {

std::string hitText(bool found, uint32_t primitive, double t) {
    if (!found) return "nothing is hit";
    char text[64];
    std::snprintf(text, sizeof text, "primitive %u at t %.9g", primitive, t);
    return text;
}

std::string blockedText(bool blocked) {
    return blocked ? "blocked" : "open";
}

/// What the backend, core's definition and exact arithmetic say of a ray.
struct Answers {
    std::optional<Grid> grid; ///< of the backend, where its structure is one
    Hit hit;                  ///< of the backend
    bool blocked = false;     ///< likewise
    std::optional<RayTrail> trail;
    Verdict truth;
    bool counts = true;         ///< false: the single view does not answer for this ray
    Grade grade = Grade::right; ///< of the backend
};

Answers answersOf(const FrameGeometry& geometry, Backend& backend, const Input& input,
                  const AskedRay& asked) {
    Answers answers;
    if (asked.maxT) {
        uint8_t blocked = 0;
        backend.occluded(std::span(&asked.ray, 1), std::span(&*asked.maxT, 1),
                         std::span(&blocked, 1));
        answers.blocked = blocked != 0;
    } else {
        backend.intersect(std::span(&asked.ray, 1), std::span(&answers.hit, 1));
    }
    if (backend.hasGrid()) {
        answers.grid = backend.readGrid();
        answers.trail = asked.maxT ? anyTrail(*answers.grid, geometry, asked.ray, *asked.maxT)
                                   : closestTrail(*answers.grid, geometry, asked.ray);
    }
    const Judge judge(geometry);
    const Ray ray = withoutDenormals(asked.ray);
    answers.truth = judge.nearest(ray);
    answers.counts =
        ViewScope(input.settings.grid, input.scene.camera).counts(ray, answers.truth, geometry);
    if (!asked.maxT) {
        answers.grade = judge.judge(ray, answers.truth, answers.hit).grade;
    } else if (std::abs(answers.truth.t - *asked.maxT) > kRelativeErrorT * answers.truth.t) {
        const bool blocked = answers.truth.found() && answers.truth.t < *asked.maxT;
        if (blocked != answers.blocked) answers.grade = blocked ? Grade::missed : Grade::falseHit;
    }
    return answers;
}

/// How the backend's answer is another than it should be; empty where it is not.
std::string problemOf(const Answers& answers, const AskedRay& asked) {
    if (answers.counts && answers.grade != Grade::right)
        return std::string("exact arithmetic says: ") + word(answers.grade);
    if (!answers.trail) return "";
    const Hit& own = answers.trail->hit;
    const bool agrees = asked.maxT ? answers.trail->blocked == answers.blocked
                                   : own.primitive == answers.hit.primitive &&
                                         (!own.found() || own.t == answers.hit.t);
    return agrees ? "" : "the definition over the same grid says otherwise";
}

} // namespace

int explainRay(const Input& input, Backend& backend, const AskedRay& asked,
               const std::optional<std::string>& image, bool json) {
    const Scene& scene = input.scene;
    const GridSettings& settings = input.settings.grid;
    const FrameGeometry geometry = makeFrameGeometry(scene.mesh, scene.camera, settings.mode);
    Tracer& tracer = backend;
    tracer.build(geometry, scene.camera, settings);
    const Answers answers = answersOf(geometry, backend, input, asked);
    const std::string problem = problemOf(answers, asked);
    const ExplainedRay explained{"asked", asked.ray, asked.maxT, answers.trail};
    const Verdict& truth = answers.truth;
    const std::string title = "a ray of " + scene.name + ", " + backend.name();
    if (image)
        writeRayImage(*image, drawRay(*answers.grid, geometry, *answers.trail, title), title);

    if (json) {
        Json object = {{"scene", scene.name}, {"backend", backend.name()}};
        object["ray"] = rayJson(explained);
        if (asked.maxT)
            object["blocked"] = answers.blocked;
        else
            object["traced_hit"] = hitJson(answers.hit);
        object["exact"] = {{"primitives", truth.primitives},
                           {"t", truth.found() ? Json(truth.t) : Json()},
                           {"counts", answers.counts}};
        object["disagreements"] = Json::array();
        if (!problem.empty()) object["disagreements"].push_back(problem);
        std::printf("%s\n", object.dump(2).c_str());
        return problem.empty() ? 0 : 1;
    }
    std::string text = title + "\n" + rayText(answers.grid, explained);
    text += "  backend  " +
            (asked.maxT ? blockedText(answers.blocked)
                        : hitText(answers.hit.found(), answers.hit.primitive, answers.hit.t)) +
            "\n";
    text += "  exact    " +
            hitText(truth.found(), truth.found() ? truth.primitives[0] : kNoPrimitive, truth.t);
    for (size_t i = 1; i < truth.primitives.size(); ++i)
        text += (i == 1 ? ", as are " : ", ") + std::to_string(truth.primitives[i]);
    text += answers.counts ? "\n" : ": outside of what the single view answers for\n";
    if (!problem.empty()) text += "  DIFFERENT: " + problem + "\n";
    std::fwrite(text.data(), 1, text.size(), stdout);
    return problem.empty() ? 0 : 1;
}

} // namespace dirt
