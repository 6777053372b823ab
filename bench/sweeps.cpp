#include "bench/sweeps.h"

#include <algorithm>

namespace dirt {

namespace {

class Builder {
public:
    explicit Builder(const RenderSettings& around) { result.settings.push_back(around); }

    void begin(const char* name) { result.sweeps.push_back({name, {}}); }

    template <typename Change>
    void add(const std::string& value, const Change& change) {
        RenderSettings changed = result.settings.front();
        change(changed);
        auto& all = result.settings;
        const auto found = std::find(all.begin(), all.end(), changed);
        const size_t index = (size_t) (found - all.begin());
        if (found == all.end()) all.push_back(changed);
        result.sweeps.back().points.emplace_back(value, index);
    }

    Sweeps result;
};

} // namespace

Sweeps makeSweeps(const RenderSettings& around) {
    Builder builder(around);
    const auto number = [&](int value, const auto& change) {
        builder.add(std::to_string(value), [&](RenderSettings& s) { change(s, value); });
    };
    const auto setTile = [](RenderSettings& s, int tile) { s.grid.tile = tile; };
    const auto setBins = [](RenderSettings& s, int bins) { s.grid.bins = bins; };

    builder.begin("tile");
    for (const int tile : {1, 2, 4, 8, 16, 32, 64}) number(tile, setTile);
    builder.begin("bins");
    for (const int bins : {1, 2, 4, 8, 16, 32, 64}) number(bins, setBins);
    builder.begin("tile/bins");
    for (const int tile : {8, 16, 32, 64})
        for (const int bins : {4, 8, 16, 32})
            builder.add(std::to_string(tile) + "/" + std::to_string(bins), [&](RenderSettings& s) {
                setTile(s, tile);
                setBins(s, bins);
            });
    builder.begin("view-size");
    for (const int quarters : {1, 2, 4, 8, 16})
        number(std::max(1, around.grid.height * quarters / 4),
               [](RenderSettings& s, int pixels) { s.grid.viewSize = pixels; });

    builder.begin("traversal");
    builder.add("hierarchical",
                [](RenderSettings& s) { s.grid.traversal = Traversal::hierarchical; });
    builder.add("linear", [](RenderSettings& s) { s.grid.traversal = Traversal::linear; });
    builder.begin("max-mip");
    for (const int level : {0, 2, 4})
        number(level, [](RenderSettings& s, int top) { s.grid.maxMip = top; });
    builder.begin("fetch");
    builder.add("raster", [](RenderSettings& s) { s.fetch = Fetch::raster; });
    builder.add("direct", [](RenderSettings& s) { s.fetch = Fetch::direct; });
    builder.begin("primary");
    builder.add("raster", [](RenderSettings& s) { s.primary = Primary::raster; });
    builder.add("traced", [](RenderSettings& s) { s.primary = Primary::traced; });

    builder.begin("precision");
    builder.add("exact", [](RenderSettings& s) { s.grid.precision = Precision::exact; });
    builder.add("fast", [](RenderSettings& s) { s.grid.precision = Precision::fast; });

    builder.begin("shading");
    builder.add("full", [](RenderSettings& s) { s.shading = Shading::full; });
    builder.add("packed", [](RenderSettings& s) { s.shading = Shading::packed; });

    builder.begin("visibility");
    builder.add("traced", [](RenderSettings& s) { s.visibility = LightVisibility::traced; });
    builder.add("shadowmap", [](RenderSettings& s) { s.visibility = LightVisibility::shadowMap; });

    builder.begin("view");
    builder.add("full", [](RenderSettings& s) { s.grid.mode = ViewMode::full; });
    builder.add("single", [](RenderSettings& s) { s.grid.mode = ViewMode::single; });
    builder.begin("bounces");
    for (const int bounces : {1, 2, 3, 4, 6})
        number(bounces, [](RenderSettings& s, int n) { s.bounces = n; });
    return std::move(builder.result);
}

} // namespace dirt
