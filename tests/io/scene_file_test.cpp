#include "core/io/scene_file.h"

#include "shaders/shared/radiance.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace dirt {
namespace {

class SceneXml : public testing::Test {
protected:
    SceneFile read(const std::string& text) {
        return readSceneFile(folder_.write("test.scene", text), report_);
    }
    SceneFile readWorld(const std::string& content) {
        return read("<world>\n" + content + "\n</world>");
    }
    /// The error's text after the file's name: ":line: message".
    std::string error(const std::string& text) {
        const std::string file = folder_.write("test.scene", text);
        const std::string what = inputError([&] { readSceneFile(file, report_); });
        return what.empty() ? what : what.substr(file.size());
    }
    std::string errorInWorld(const std::string& content) {
        return error("<world>\n" + content + "\n</world>");
    }

    test::TemporaryFolder folder_;
    LoadReport report_;
};

TEST_F(SceneXml, EmptyWorldGivesDefaults) {
    const SceneFile scene = read("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<world/>\n");
    EXPECT_FALSE(scene.hasCamera);
    EXPECT_FALSE(scene.light);
    EXPECT_FALSE(scene.settings.tile || scene.settings.bins || scene.settings.bounces ||
                 scene.settings.view);
    EXPECT_EQ(scene.background, glm::vec3(0));
    EXPECT_TRUE(report_.ignored().empty());
}

TEST_F(SceneXml, ReadsWhetherObjectsHaveTwoSides) {
    const SceneFile scene = readWorld("<object file='a.obj'/><object file='b.obj' "
                                      "double_sided='TRUE'/><object file='c.obj' "
                                      "double_sided='false'/>");
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_TRUE(scene.objects[0].doubleSided);
    EXPECT_TRUE(scene.objects[1].doubleSided);
    EXPECT_FALSE(scene.objects[2].doubleSided);
    EXPECT_TRUE(report_.ignored().empty());
    EXPECT_NE(errorInWorld("<object file='a.obj' double_sided='both'/>"), "");
}

TEST_F(SceneXml, ReadsTracing) {
    const SceneFile scene = readWorld("<tracing block_size=' 4 ' buckets='44' faces='single' "
                                      "indirect_bounces='0'/>");
    EXPECT_EQ(scene.settings.tile, 4);
    EXPECT_EQ(scene.settings.bins, 44);
    EXPECT_EQ(scene.settings.bounces, 1);
    EXPECT_EQ(scene.settings.view, ViewMode::single);
    EXPECT_EQ(readWorld("<tracing faces='cubemap'/>").settings.view, ViewMode::full);
    EXPECT_FALSE(readWorld("<tracing/>").settings.visibility);
    EXPECT_EQ(readWorld("<tracing accurate_visibility='true'/>").settings.visibility,
              LightVisibility::traced);
    EXPECT_EQ(readWorld("<tracing accurate_visibility='off'/>").settings.visibility,
              LightVisibility::shadowMap);
    EXPECT_EQ(error("<world>\n\n<tracing\n faces='seven'/></world>"),
              ":3: <tracing>: faces='seven' is neither cubemap nor single");
    EXPECT_EQ(errorInWorld("<tracing block_size='two'/>"),
              ":2: <tracing>: block_size='two' is not an integer from 1 to 64");
    EXPECT_NE(errorInWorld("<tracing block_size='0'/>"), "");
    EXPECT_NE(errorInWorld("<tracing buckets='0'/>"), "");
    EXPECT_NE(errorInWorld("<tracing indirect_bounces='-1'/>"), "");
}

TEST_F(SceneXml, ReadsCameraAndUser) {
    const SceneFile scene = readWorld("<camera aperture='35'/>"
                                      "<user position='1,2 3' lookat=' 4 , 5,6 '/>");
    EXPECT_TRUE(scene.hasCamera);
    EXPECT_EQ(scene.camera.verticalFov, 35.0f);
    EXPECT_EQ(scene.camera.eye, glm::vec3(1, 2, 3));
    EXPECT_EQ(scene.camera.target, glm::vec3(4, 5, 6));
    EXPECT_EQ(scene.camera.up, glm::vec3(0, 1, 0));
    EXPECT_EQ(readWorld("<user position='0 0 0' target='1 0 0'/>").camera.target,
              glm::vec3(1, 0, 0));
    EXPECT_EQ(readWorld("<user position='7 0 0'/>").camera.target, glm::vec3(7, 0, -1));
    EXPECT_FALSE(readWorld("<camera aperture='35'/>").hasCamera);
    EXPECT_EQ(errorInWorld("<user position='1 2 3' lookat='1 2 3'/>"),
              ":2: <user>: position and lookat are the same point");
    EXPECT_EQ(errorInWorld("<camera aperture='180'/>"),
              ":2: <camera>: aperture='180' is out of range");
}

TEST_F(SceneXml, ReadsTheLight) {
    const SceneFile scene = readWorld(
        "<light type='spotlight' active='ON' flux='12' color='1 0.5 0.25' position='0 9 0'\n"
        " target='0 0 0' aperture='90' penumbra='80' spotlight_exponent='2' conical='False'/>");
    ASSERT_TRUE(scene.light);
    EXPECT_EQ(scene.light->flux, 12.0f);
    EXPECT_EQ(scene.light->color, glm::vec3(1, 0.5f, 0.25f));
    EXPECT_EQ(scene.light->position, glm::vec3(0, 9, 0));
    EXPECT_EQ(scene.light->target, glm::vec3(0, 0, 0));
    EXPECT_EQ(scene.light->aperture, 90.0f);
    EXPECT_EQ(scene.light->penumbra, 80.0f);
    EXPECT_EQ(scene.light->exponent, 2.0f);
    EXPECT_FALSE(scene.light->conical);
    EXPECT_TRUE(scene.light->shadows);
    EXPECT_FALSE(readWorld("<light shadows='off'/>").light->shadows);
    EXPECT_TRUE(readWorld("<light shadows='on'/>").light->shadows);
    EXPECT_NE(errorInWorld("<light shadows='soft'/>").find(":2: <light>: shadows="),
              std::string::npos);
    readWorld("<light shadow='off'/>");
    EXPECT_EQ(report_.ignored(), std::vector<std::string>{"attribute shadow of <light>"});

    const Spotlight light = *readWorld("<light resolution='2048' near_range='0.5' far_range='20'\n"
                                       " constant_bias='0.002' soft_shadow_size='0.1'/>")
                                 .light;
    EXPECT_EQ(light.resolution, 2048);
    EXPECT_EQ(light.nearRange, 0.5f);
    EXPECT_EQ(light.farRange, 20.0f);
    EXPECT_EQ(light.constantBias, 0.002f);
    EXPECT_EQ(light.softShadowSize, 0.1f);
}

TEST_F(SceneXml, LightWithoutPenumbraHasNoFalloff) {
    EXPECT_EQ(readWorld("<light aperture='40'/>").light->penumbra, 40.0f);
}

TEST_F(SceneXml, LeavesInactiveLightsOut) {
    EXPECT_FALSE(readWorld("<light active='off'/>").light);
    EXPECT_EQ(readWorld("<light active='0' flux='1'/><light flux='2'/>").light->flux, 2.0f);
    EXPECT_EQ(errorInWorld("<light/>\n<light/>"),
              ":3: <light>: there may be one active light only");
}

TEST_F(SceneXml, RefusesImpossibleLights) {
    EXPECT_EQ(errorInWorld("<light type='sun'/>"), ":2: <light>: type='sun' is not spotlight");
    EXPECT_EQ(errorInWorld("<light flux='-1'/>"), ":2: <light>: flux='-1' is out of range");
    EXPECT_EQ(errorInWorld("<light color='1 -1 1'/>"), ":2: <light>: color='1 -1 1' is negative");
    EXPECT_EQ(errorInWorld("<light aperture='40' penumbra='41'/>"),
              ":2: <light>: penumbra='41' is out of range");
    EXPECT_EQ(errorInWorld("<light position='1 1 1' target='1 1 1'/>"),
              ":2: <light>: position and target are the same point");
    EXPECT_EQ(errorInWorld("<light resolution='0'/>"),
              ":2: <light>: resolution='0' is not an integer from 1 to 16384");
    EXPECT_EQ(errorInWorld("<light near_range='2' far_range='2'/>"),
              ":2: <light>: far_range is not beyond near_range");
    EXPECT_EQ(errorInWorld("<light constant_bias='-0.1'/>"),
              ":2: <light>: constant_bias='-0.1' is out of range");
    EXPECT_EQ(errorInWorld("<light active='maybe'/>"),
              ":2: <light>: active='maybe' is neither true nor false");
}

TEST_F(SceneXml, ReadsBackgroundAndToneMapping) {
    const SceneFile scene =
        read("<world background='0.45, 0.65, 0.86'><tonemapping key='2' white='1,4 3'/></world>");
    EXPECT_EQ(scene.background, glm::vec3(0.45f, 0.65f, 0.86f));
    EXPECT_EQ(scene.toneMapping.key, 2.0f);
    EXPECT_EQ(scene.toneMapping.white, 4.0f);
    EXPECT_NE(errorInWorld("<tonemapping white='0 0 0'/>"), "");
    EXPECT_NE(errorInWorld("<tonemapping key='39'/>"), "");
}

TEST_F(SceneXml, NestsTransformations) {
    const SceneFile scene = readWorld("<transformation scale='2 2 2' translation='1 0 0'>\n"
                                      "<object file='a.obj'/>\n"
                                      "<transformation rotation='90,0,1,0' translation='0,0,3'>\n"
                                      "<object file='b.obj'/></transformation></transformation>\n"
                                      "<object file='c.obj'/>");
    ASSERT_EQ(scene.objects.size(), 3u);
    const auto place = [&](size_t i) {
        return glm::dvec3(scene.objects[i].toSpace * glm::dvec4(1, 0, 0, 1));
    };
    EXPECT_EQ(scene.objects[0].file, "a.obj");
    EXPECT_EQ(scene.objects[1].file, "b.obj");
    EXPECT_EQ(scene.objects[1].line, 5u);
    EXPECT_EQ(place(0), glm::dvec3(3, 0, 0));
    EXPECT_EQ(place(1), glm::dvec3(1, 0, 4)); // turned to -Z, moved by 3, doubled, moved by 1
    EXPECT_EQ(place(2), glm::dvec3(1, 0, 0));
}

TEST_F(SceneXml, RefusesMalformedNumbers) {
    EXPECT_EQ(errorInWorld("<transformation scale='1 1'/>"),
              ":2: <transformation>: scale='1 1' has 2 numbers, not 3");
    EXPECT_EQ(errorInWorld("<transformation scale='1 1 1 1'/>"),
              ":2: <transformation>: scale='1 1 1 1' has 4 numbers, not 3");
    EXPECT_EQ(errorInWorld("<transformation scale='1 1 x'/>"),
              ":2: <transformation>: scale='1 1 x' is malformed: 'x' is not a number");
    EXPECT_EQ(errorInWorld("<transformation translation='nan 0 0'/>"),
              ":2: <transformation>: translation='nan 0 0' is not finite in float32");
    EXPECT_EQ(errorInWorld("<transformation rotation='10 0 0 0'/>"),
              ":2: <transformation>: the rotation's axis is zero");
    EXPECT_EQ(errorInWorld("<object/>"), ":2: <object>: file is missing");
}

TEST_F(SceneXml, ListsWhatHasNoEffectOnce) {
    readWorld("<font size='1'/><font/><tracing odd='1' name='t'/>\n"
              "<transformation><light/></transformation><user input='i'>text</user>");
    EXPECT_EQ(report_.ignored(),
              (std::vector<std::string>{"element <font> in <world>", "attribute odd of <tracing>",
                                        "element <light> in <transformation>",
                                        "attribute input of <user>", "text in <user>"}));
}

TEST_F(SceneXml, RefusesWhatIsNotWellFormed) {
    EXPECT_EQ(error("<world>\n<user></world>\n").rfind(":2: ", 0), 0u);
    EXPECT_EQ(error("").rfind(":1: ", 0), 0u);
    EXPECT_EQ(error("<!-- nothing -->\n"), ":1: holds no XML element");
    EXPECT_EQ(error("no xml"), ":1: holds no XML element");
    EXPECT_EQ(error("<scene/>"), ":1: <scene>: the root element must be <world>");
    EXPECT_EQ(error("<world/>\n\n<world/>"), ":3: <world>: a second root element");
    EXPECT_EQ(error("<world/>\n\r\n text"), ":3: text outside of the root element");
    EXPECT_EQ(error("text\n<world/>"), ":1: text outside of the root element");
    EXPECT_EQ(error("<world>\n<user\nposition='0 0 0' position='1 1 1'/></world>"),
              ":2: <user>: attribute 'position' appears twice");
    EXPECT_EQ(error("<world>\n<object file='d\xfcster.obj'/></world>"), ":2: is not valid UTF-8");
    EXPECT_EQ(error(std::string("\xff\xfe<\0w\0", 6)),
              ":1: is UTF-16; only ASCII and UTF-8 text can be read");
}

TEST_F(SceneXml, RefusesASecondOfWhatThereIsOnce) {
    for (const std::string name : {"tracing", "camera", "user", "tonemapping"}) {
        std::string element = "<" + name + "/>";
        EXPECT_EQ(errorInWorld(element + "\n" + element),
                  ":3: <" + name + ">: there may be one only");
    }
}

TEST_F(SceneXml, RefusesBottomlessNesting) {
    std::string text = "<world>";
    for (int i = 0; i < 200000; ++i) text += "<transformation>";
    for (int i = 0; i < 200000; ++i) text += "</transformation>";
    EXPECT_EQ(error(text + "</world>"), ":1: <transformation>: elements are nested too deeply");
}

/// Wherever a file breaks off, it is refused with a line that it has.
TEST_F(SceneXml, RefusesEveryTruncation) {
    const std::string text = "<?xml version=\"1.0\"?>\n<!-- a -->\n<world background='1 1 1'>\n"
                             "<object file='a.obj'/>\n<user position='0 0 1'></user>\n</world>";
    EXPECT_EQ(error(text), "");
    for (size_t length = 0; length < text.size(); ++length) {
        const std::string cut = text.substr(0, length), what = error(cut);
        ASSERT_EQ(what.rfind(':', 0), 0u) << length << " bytes: " << what;
        const size_t line = std::stoul(what.substr(1));
        EXPECT_LE(line, 1u + (size_t) std::count(cut.begin(), cut.end(), '\n')) << what;
        EXPECT_GE(line, 1u) << what;
    }
}

/// What is listed as honoured is read: nonsense in it is noticed. (A folder may have any name.)
TEST_F(SceneXml, HonouredAttributesAreRead) {
    for (const auto& [element, attribute] : honouredSceneAttributes()) {
        if (element == "directory" || element == "object") continue;
        const std::string nonsense = std::string(attribute) + "='?'";
        std::string text = element == "world"
                               ? "<world " + nonsense + "/>"
                               : "<world><" + std::string(element) + " " + nonsense + "/></world>";
        if (element == "key") {
            const bool timed = attribute == "time" || attribute == "frame";
            const std::string animated =
                attribute == "aperture" ? "camera"
                : attribute == "scale" || attribute == "rotation" || attribute == "translation"
                    ? "transformation"
                    : "user";
            text = "<world><" + animated + "><animation><key " + (timed ? "" : "time='0' ") +
                   nonsense + "/></animation></" + animated + "></world>";
        }
        EXPECT_NE(error(text).find(nonsense), std::string::npos) << text;
        EXPECT_TRUE(report_.ignored().empty());
    }
}

/// It grows with the square of a scene's scale, beyond what float holds; with its digits.
TEST_F(SceneXml, FluxIsOfAnySize) {
    EXPECT_EQ(readWorld("<light flux='1e50'/>").light->flux, roundedFlux(1e50));
    EXPECT_EQ(readWorld("<light flux='1e-60'/>").light->flux, roundedFlux(1e-60));
    EXPECT_EQ(readWorld("<light flux='0.1'/>").light->flux, (double) 0.1f);
    EXPECT_EQ(errorInWorld("<light flux='1e400'/>"), ":2: <light>: flux='1e400' is not finite");
}

TEST_F(SceneXml, BackgroundIsBounded) {
    const std::string file = folder_.write("a.scene", "<world background='1 3e38 0'/>");
    const SceneFile scene = readSceneFile(file, report_);
    EXPECT_EQ(scene.background, glm::vec3(1, kMostRadiance, 0));
    ASSERT_EQ(report_.warnings().size(), 1u);
    EXPECT_EQ(report_.warnings()[0].text,
              file + ":1: background is above 7.92282e+28, and taken for it");
}

struct BadAttribute {
    const char *element, *attribute, *value;
};

void PrintTo(const BadAttribute& bad, std::ostream* out) {
    *out << bad.element << ' ' << bad.attribute << "='" << bad.value << "'";
}

class AttributeOutOfRange : public SceneXml, public testing::WithParamInterface<BadAttribute> {};

TEST_P(AttributeOutOfRange, IsNamedWithItsLine) {
    const auto& [element, attribute, value] = GetParam();
    const std::string what =
        errorInWorld("\n<" + std::string(element) + " " + attribute + "='" + value + "'/>");
    EXPECT_EQ(what.rfind(":3: <" + std::string(element) + ">: ", 0), 0u) << what;
    EXPECT_NE(what.find(attribute), std::string::npos) << what;
}

INSTANTIATE_TEST_SUITE_P(
    All, AttributeOutOfRange,
    testing::Values(
        BadAttribute{"tracing", "block_size", "0"}, BadAttribute{"tracing", "block_size", "65"},
        BadAttribute{"tracing", "block_size", "1000000"},
        BadAttribute{"tracing", "block_size", "2.5"}, BadAttribute{"tracing", "block_size", ""},
        BadAttribute{"tracing", "buckets", "0"}, BadAttribute{"tracing", "buckets", "-1"},
        BadAttribute{"tracing", "buckets", "257"},
        BadAttribute{"tracing", "buckets", "99999999999999999999"},
        BadAttribute{"tracing", "indirect_bounces", "-1"},
        BadAttribute{"tracing", "indirect_bounces", "1024"},
        BadAttribute{"tracing", "faces", "Cubemap "}, BadAttribute{"camera", "aperture", "0"},
        BadAttribute{"camera", "aperture", "nan"}, BadAttribute{"user", "position", "inf 0 0"},
        BadAttribute{"user", "position", "1e39 0 0"}, BadAttribute{"user", "lookat", ""},
        BadAttribute{"light", "flux", "-inf"}, BadAttribute{"light", "flux", "1 2"},
        BadAttribute{"light", "aperture", "361"}, BadAttribute{"light", "spotlight_exponent", "-1"},
        BadAttribute{"tonemapping", "key", "1e9"}, BadAttribute{"tonemapping", "white", "0,0,0"},
        BadAttribute{"transformation", "rotation", "90,0,1"},
        BadAttribute{"transformation", "translation", "1;2;3"},
        BadAttribute{"object", "file", " "}));

} // namespace
} // namespace dirt
