// The template scenes: they explain what there is, and render as they are.

#include "core/io/image.h"
#include "core/io/scene_file.h"
#include "tests/cli/program.h"

#include <cctype>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

namespace dirt::test {
namespace {

class Template : public testing::TestWithParam<const char*> {
protected:
    std::filesystem::path file() const {
        return std::filesystem::path(DIRT_SOURCE_DIR) / "scenes" /
               ("template_" + std::string(GetParam()) + ".scene");
    }
};

/// All comments that stand right before an element of that name, anywhere below \p parent.
std::string commentsBefore(pugi::xml_node parent, std::string_view element) {
    std::string text;
    for (const pugi::xml_node node : parent.children()) {
        if (element == node.name() && node.previous_sibling().type() == pugi::node_comment)
            text += node.previous_sibling().value();
        text += commentsBefore(node, element);
    }
    return text;
}

bool hasWord(const std::string& text, std::string_view word) {
    const auto isPart = [&](size_t i) {
        return i < text.size() && (std::isalnum((unsigned char) text[i]) || text[i] == '_');
    };
    for (size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
        if ((at == 0 || !isPart(at - 1)) && !isPart(at + word.size())) return true;
    return false;
}

TEST_P(Template, ExplainsEveryAttributeThatCounts) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_file(file().c_str(), pugi::parse_default | pugi::parse_comments));
    for (const auto& [element, attribute] : honouredSceneAttributes())
        EXPECT_TRUE(hasWord(commentsBefore(document, element), attribute))
            << attribute << " of <" << element << ">";
}

TEST_P(Template, ShowsNothingWithoutEffect) {
    LoadReport report;
    readSceneFile(file(), report);
    EXPECT_TRUE(report.ignored().empty()) << report.ignored().front();
}

TEST_P(Template, RendersAsItIs) {
    const TemporaryFolder folder;
    const std::string scene = folder.write(file().filename().string(), readFile(file()));
    ASSERT_EQ(dirt({"generate", "cornell", "-o", folder / "generated"}).status, 0);
    const Outcome run = dirt({"render", scene, "--size", "48x32", "--spp", "2", "--strict",
                              "--json", "-o", folder / "a.exr"});
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out)["view"], GetParam());
    const Image image = readImage(folder / "a.exr");
    int lit = 0;
    for (const glm::vec3& pixel : image.pixels) lit += pixel.x > 0.05f;
    EXPECT_GT(lit, 48 * 32 / 2) << "the room fills the middle of the picture";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Template, testing::Values("full", "single"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace
} // namespace dirt::test
