#include "core/io/xml.h"

#include "core/io/number.h"
#include "core/io/text_file.h"
#include "core/io/utf8.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace dirt {

namespace {

/// Deeper nesting is refused, so that walking the tree needs little stack.
constexpr int kMaxDepth = 256;

bool isSeparator(char c) {
    return isBlank(c) || c == ',' || c == '\n' || c == '\r';
}

/// Takes the next number's text off the front of \p list; empty where none is left.
std::string_view takeItem(std::string_view& list) {
    const auto begin = std::find_if_not(list.begin(), list.end(), isSeparator);
    const auto end = std::find_if(begin, list.end(), isSeparator);
    const std::string_view item(begin, end);
    list.remove_prefix((size_t) (end - list.begin()));
    return item;
}

} // namespace

XmlFile::XmlFile(const std::filesystem::path& file, const MemoryBudget& budget)
    : file_(file), memory_(budget), text_(readTextFile(file, memory_)) {
    // pugixml copies the text, and makes a node of what begins with '<' or an attribute has; and
    // what reads the nodes makes an object of some.
    constexpr uint64_t kNode = 256, kAttribute = 64;
    const auto count = [this](char c) {
        return (uint64_t) std::count(text_.begin(), text_.end(), c);
    };
    memory_.take(text_.size() + kNode * count('<') + kAttribute * count('=') +
                     sizeof(ptrdiff_t) * 2 * count('\n'),
                 file_, "its XML");
    for (size_t at = text_.find('\n'); at != text_.npos; at = text_.find('\n', at + 1))
        breaks_.push_back((ptrdiff_t) at);
    checkUtf8();
    // Fragments are allowed here so that text beside the root comes to light below.
    const auto result =
        document_.load_buffer(text_.data(), text_.size(),
                              pugi::parse_default | pugi::parse_fragment, pugi::encoding_utf8);
    if (!result) failAt(file_, lineOfOffset(result.offset), result.description());
    if (!root()) failAt(file_, 1, "holds no XML element");
    for (const pugi::xml_node child : document_.children()) {
        if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata)
            failAt(file_, lineOfText(child), "text outside of the root element");
        if (child.type() == pugi::node_element && child != root())
            fail(child, "a second root element");
    }
    checkTree(root(), 1);
}

void XmlFile::checkUtf8() const {
    for (size_t i = 0; i < text_.size();) {
        const size_t length = utf8Length(std::string_view(text_).substr(i, 4));
        if (length == 0) failAt(file_, lineOfOffset((ptrdiff_t) i), "is not valid UTF-8");
        i += length;
    }
}

void XmlFile::checkTree(pugi::xml_node parent, int depth) const {
    if (depth > kMaxDepth) fail(parent, "elements are nested too deeply");
    std::set<std::string_view> names;
    for (const pugi::xml_attribute attribute : parent.attributes())
        if (!names.insert(attribute.name()).second)
            fail(parent, "attribute " + inQuotes(attribute.name()) + " appears twice");
    for (const pugi::xml_node child : parent.children())
        if (child.type() == pugi::node_element) checkTree(child, depth + 1);
}

size_t XmlFile::lineOfOffset(ptrdiff_t offset) const {
    const auto before = std::lower_bound(breaks_.begin(), breaks_.end(), offset);
    return 1 + (size_t) (before - breaks_.begin());
}

size_t XmlFile::line(pugi::xml_node node) const {
    return lineOfOffset(node.offset_debug());
}

/// Text begins right after the tag before it, mostly with a line break.
size_t XmlFile::lineOfText(pugi::xml_node node) const {
    const std::string_view text = node.value();
    const size_t blanks = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    return line(node) + (size_t) std::count(text.begin(), text.begin() + (ptrdiff_t) blanks, '\n');
}

void XmlFile::fail(pugi::xml_node node, const std::string& message) const {
    failAt(file_, line(node), "<" + printable(node.name()) + ">: " + message);
}

void ignoreNode(pugi::xml_node node, LoadReport& report) {
    const std::string parent = node.parent().name();
    if (node.type() == pugi::node_element)
        report.ignore("element <" + std::string(node.name()) + "> in <" + parent + ">");
    else
        report.ignore("text in <" + parent + ">");
}

void XmlAttributes::fail(const char* name, const std::string& message) const {
    xml_.fail(node_,
              std::string(name) + "=" + inQuotes(node_.attribute(name).value()) + " " + message);
}

std::optional<std::string> XmlAttributes::text(const char* name) const {
    const pugi::xml_attribute attribute = node_.attribute(name);
    if (!attribute) return std::nullopt;
    return attribute.value();
}

std::optional<bool> XmlAttributes::boolean(const char* name) const {
    const auto value = text(name);
    if (!value) return std::nullopt;
    const std::string word = lowerCase(std::string(trimmed(*value)));
    if (word == "true" || word == "on" || word == "1") return true;
    if (word == "false" || word == "off" || word == "0") return false;
    fail(name, "is neither true nor false");
}

std::optional<int> XmlAttributes::integer(const char* name, int lowest, int highest) const {
    const auto value = text(name);
    if (!value) return std::nullopt;
    const auto parsed = parseInteger(trimmed(*value));
    if (!parsed || *parsed < lowest || *parsed > highest)
        fail(name,
             "is not an integer from " + std::to_string(lowest) + " to " + std::to_string(highest));
    return parsed;
}

bool XmlAttributes::numbers(const char* name, double* values, int count, double largest) const {
    const auto value = text(name);
    if (!value) return false;
    std::string_view list = *value;
    int found = 0;
    for (auto item = takeItem(list); !item.empty(); item = takeItem(list), ++found) {
        const auto parsed = parseNumber(item);
        if (!parsed) fail(name, "is malformed: " + inQuotes(item) + " is not a number");
        if (!(std::fabs(*parsed) <= largest))
            fail(name, largest > FLT_MAX ? "is not finite" : "is not finite in float32");
        if (found < count) values[found] = *parsed;
    }
    if (found != count)
        fail(name, "has " + std::to_string(found) + " numbers, not " + std::to_string(count));
    return true;
}

std::optional<double> XmlAttributes::real(const char* name, double lowest, double highest) const {
    double value = 0.0;
    if (!numbers(name, &value, 1)) return std::nullopt;
    if (value < lowest || value > highest) fail(name, "is out of range");
    return value;
}

std::optional<double> XmlAttributes::wideReal(const char* name, double lowest) const {
    double value = 0.0;
    if (!numbers(name, &value, 1, DBL_MAX)) return std::nullopt;
    if (value < lowest) fail(name, "is out of range");
    return value;
}

std::optional<float> XmlAttributes::number(const char* name, double lowest, double highest) const {
    const auto value = real(name, lowest, highest);
    if (!value) return std::nullopt;
    return (float) *value;
}

std::optional<glm::dvec3> XmlAttributes::vector3(const char* name) const {
    glm::dvec3 value(0.0);
    if (!numbers(name, &value.x, 3)) return std::nullopt;
    return value;
}

std::optional<glm::dvec4> XmlAttributes::vector4(const char* name) const {
    glm::dvec4 value(0.0);
    if (!numbers(name, &value.x, 4)) return std::nullopt;
    return value;
}

std::optional<glm::vec3> XmlAttributes::colour(const char* name) const {
    const auto value = vector3(name);
    if (!value) return std::nullopt;
    if (value->x < 0.0 || value->y < 0.0 || value->z < 0.0) fail(name, "is negative");
    return glm::vec3(*value);
}

void XmlAttributes::ignoreOthers(const std::function<bool(std::string_view)>& known,
                                 LoadReport& report) const {
    for (const pugi::xml_attribute attribute : node_.attributes()) {
        const std::string_view name = attribute.name();
        if (name != "name" && !known(name))
            report.ignore("attribute " + std::string(name) + " of <" + node_.name() + ">");
    }
}

} // namespace dirt
