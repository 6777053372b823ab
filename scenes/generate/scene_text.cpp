#include "scenes/generate/scene_text.h"

#include <stdexcept>
#include <string_view>

namespace dirt::generate {
namespace {

// Low afternoon sun from behind the left shoulder, over the roof: it leaves the left arcade in the
// shade, and what it lights on the right lights the left again.
constexpr std::string_view atrium = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="1.5 1.9 2.5" ambient="0 0 0" microfacet_model="ggx">

    <tracing faces="cubemap" indirect_bounces="2" accurate_visibility="true"/>

    <camera name="first_person" aperture="62" near="0.1" far="120" follow="default_user" primary="true"/>

    <light name="sun" type="spotlight" shadows="on" active="true" flux="20000" color="1 0.9 0.74"
        position="-22 60 24" target="1.5 3 -2" conical="true" aperture="42" penumbra="36"
        spotlight_exponent="1.0" resolution="4096" near_range="20" far_range="120"
        soft_shadow_size="0.05" constant_bias="0.0005"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="atrium" file="@MODEL@"/>
    </transformation>

    <user name="default_user" control="roaming" linear_speed="2" angular_speed="1"
        position="-1.4 2.8 10.3" target="0.3 4.1 -3"/>

    <tonemapping name="tone" key="1.5" white="4 4 4" auto="0" active="1"/>

</world>
)";

constexpr std::string_view cornell = R"(<?xml version="1.0" encoding="utf-8"?>

<world background="0 0 0" ambient="0 0 0" microfacet_model="beckmann">

    <tracing faces="cubemap" indirect_bounces="2" accurate_visibility="true"/>

    <camera name="first_person" aperture="38" near="0.1" far="10" follow="default_user" primary="true"/>

    <light name="lamp" type="spotlight" shadows="on" active="true" flux="48" color="1 0.85 0.62"
        position="0 1.99 0" target="0 0 0" conical="true" aperture="150" penumbra="110"
        spotlight_exponent="1.0" resolution="1024" near_range="0.05" far_range="5"
        soft_shadow_size="0.1" constant_bias="0.002"/>

    <transformation name="environment" rotation="0,0,1,0" scale="1 1 1" translation="0,0,0">
        <object name="cornell" file="@MODEL@"/>
    </transformation>

    <user name="default_user" control="roaming" linear_speed="0.5" angular_speed="1"
        position="0 1 3.85" target="0 1 0"/>

    <tonemapping name="tone" key="1.3" white="5 5 5" auto="0" active="1"/>

</world>
)";

} // namespace

std::string sceneText(const std::string& name, const std::string& modelPath) {
    if (name != "atrium" && name != "cornell") {
        throw std::runtime_error("no scene text for '" + name + "'");
    }
    std::string text(name == "atrium" ? atrium : cornell);
    constexpr std::string_view mark = "@MODEL@";
    text.replace(text.find(mark), mark.size(), modelPath);
    return text;
}

} // namespace dirt::generate
