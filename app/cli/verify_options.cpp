#include "app/cli/verify_options.h"

#include "core/base/error.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

namespace dirt {

std::vector<RayKind> kindsOf(const VerifyOptions& options) {
    if (options.kinds.empty()) return {kRayKinds.begin(), kRayKinds.end()};
    std::vector<RayKind> kinds;
    for (const std::string& name : options.kinds) {
        const auto kind = rayKindByName(name);
        if (!kind) throw InputError("--kinds: '" + name + "' is none of " + rayKindNames());
        kinds.push_back(*kind);
    }
    return kinds;
}

std::vector<const Extreme*> extremesOf(const VerifyOptions& options) {
    if (!options.extremes && !options.only.empty())
        throw InputError("--only: has no effect without --extremes");
    std::vector<const Extreme*> chosen;
    for (const std::string& name : options.only) {
        const Extreme* extreme = extremeByName(name);
        if (!extreme) {
            std::string names;
            for (const Extreme& known : extremes())
                names.append(names.empty() ? "" : ",").append(known.name);
            throw InputError("--only: '" + name + "' is none of " + names);
        }
        chosen.push_back(extreme);
    }
    if (chosen.empty())
        for (const Extreme& extreme : extremes()) chosen.push_back(&extreme);
    return chosen;
}

std::vector<std::unique_ptr<Backend>> makePeers([[maybe_unused]] Executor& executor) {
#ifdef DIRT_HAVE_EMBREE
    std::vector<std::unique_ptr<Backend>> peers;
    for (const bool robust : {false, true})
        peers.push_back(std::make_unique<EmbreeBackend>(executor, robust, EmbreeDecision::plain));
    return peers;
#else
    throw CapabilityError("verify compares with Embree, and this build is without it");
#endif
}

} // namespace dirt
