#include "scenes/generate/scene_text.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace dirt::generate {
namespace {

// Low afternoon sun from behind the left shoulder, over the roof: it leaves the left arcade in the
// shade, and what it lights on the right lights the left again.
constexpr std::string_view atriumText = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="1.5 1.9 2.5">

    <tracing faces="cubemap" indirect_bounces="2"/>

    <camera name="first_person" aperture="62"/>

    <light name="sun" type="spotlight" active="true" flux="20000" color="1 0.9 0.74"
        position="-22 60 24" target="1.5 3 -2" conical="true" aperture="42" penumbra="36"
        spotlight_exponent="1.0"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="atrium" file="@MODEL@"/>
    </transformation>

    <user name="default_user"
        position="-1.4 2.8 10.3" target="0.3 4.1 -3"/>

    <tonemapping name="tone" key="1.5" white="4 4 4"/>

</world>
)";

constexpr std::string_view cornellText = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="0 0 0">

    <tracing faces="cubemap" indirect_bounces="2"/>

    <camera name="first_person" aperture="38"/>

    <light name="lamp" type="spotlight" active="true" flux="48" color="1 0.85 0.62"
        position="0 1.99 0" target="0 0 0" conical="true" aperture="150" penumbra="110"
        spotlight_exponent="1.0"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="cornell" file="@MODEL@"/>
    </transformation>

    <user name="default_user"
        position="0 1 3.85" target="0 1 0"/>

    <tonemapping name="tone" key="1.3" white="5 5 5"/>

</world>
)";

// Morning sun through the open door, past the camera's left shoulder; panels light the rest.
constexpr std::string_view hangarText = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="1.6 2.2 3.0">

    <tracing faces="cubemap" indirect_bounces="2"/>

    <camera name="first_person" aperture="39"/>

    <light name="sun" type="spotlight" active="true" flux="78000" color="1 0.86 0.66"
        position="-30 20 74" target="2 2.5 4" conical="true" aperture="50" penumbra="42"
        spotlight_exponent="1.0"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="hangar" file="@MODEL@"/>
    </transformation>

    <user name="default_user"
        position="7.9 1.9 17.0" target="-0.6 3.25 0"/>

    <tonemapping name="tone" key="1.2" white="4 4 4"/>

</world>
)";

// Late sun from the left, within the dome of the sky.
constexpr std::string_view templesText = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="0.5 0.7 1.0">

    <tracing faces="cubemap" indirect_bounces="2"/>

    <camera name="first_person" aperture="40"/>

    <light name="sun" type="spotlight" active="true" flux="40000000" color="1 0.87 0.68"
        position="-740 310 130" target="0 0 -120" conical="true" aperture="110" penumbra="108"
        spotlight_exponent="1.0"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="temples" file="@MODEL@"/>
    </transformation>

    <user name="default_user"
        position="0 3.1 1.5" target="0.6 3.9 -20"/>

    <tonemapping name="tone" key="1.2" white="4 4 4"/>

</world>
)";

// Morning sun through the window, the lamp faint beside it; and the lamp alone, in moonlight.
constexpr std::string_view bunnyDayText = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="3.0 3.4 4.0">

    <tracing faces="cubemap" indirect_bounces="2"/>

    <camera name="first_person" aperture="33"/>

    <light name="sun" type="spotlight" active="true" flux="2000" color="1 0.86 0.64"
        position="-7.33 5.34 -4.21" target="0.14 0.2 0.33" conical="true" aperture="34"
        penumbra="32" spotlight_exponent="1.0"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="bunny" file="@MODEL@"/>
    </transformation>

    <user name="default_user"
        position="0.30 0.60 2.45" target="-0.02 0.43 -0.4"/>

    <tonemapping name="tone" key="0.75" white="7 7 7"/>

</world>
)";

constexpr std::string_view bunnyNightText = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="0.05 0.075 0.13">

    <tracing faces="cubemap" indirect_bounces="2"/>

    <camera name="first_person" aperture="33"/>

    <light name="lamp" type="spotlight" active="true" flux="100" color="1 0.74 0.46"
        position="-0.885 0.824 0.0" target="-0.83 0 0.02" conical="true" aperture="168"
        penumbra="130" spotlight_exponent="1.0"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="bunny" file="@MODEL@"/>
    </transformation>

    <user name="default_user"
        position="0.30 0.60 2.45" target="-0.02 0.43 -0.4"/>

    <tonemapping name="tone" key="1.5" white="2.2 2.2 2.2"/>

</world>
)";

constexpr std::pair<std::string_view, std::string_view> texts[] = {
    {"atrium", atriumText},   {"bunny_day", bunnyDayText}, {"bunny_night", bunnyNightText},
    {"cornell", cornellText}, {"hangar", hangarText},      {"temples", templesText},
};

} // namespace

std::string sceneText(const std::string& name, const std::string& modelPath) {
    const auto* const found = std::find_if(std::begin(texts), std::end(texts),
                                           [&](const auto& entry) { return entry.first == name; });
    if (found == std::end(texts)) throw std::runtime_error("no scene text for '" + name + "'");
    std::string text(found->second);
    constexpr std::string_view mark = "@MODEL@";
    text.replace(text.find(mark), mark.size(), modelPath);
    return text;
}

} // namespace dirt::generate
