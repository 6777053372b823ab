#pragma once

#include "core/io/load_report.h"
#include "core/io/memory_budget.h"

#include <cfloat>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <pugixml.hpp>

namespace dirt {

/// An XML document whose elements know their line. Stricter than pugixml, which lets invalid
/// UTF-8, duplicate attributes and a second root pass.
class XmlFile {
public:
    /// Throws InputError with the line where the file is not well-formed.
    explicit XmlFile(const std::filesystem::path& file, const MemoryBudget& budget = {});

    const std::filesystem::path& file() const { return file_; }
    pugi::xml_node root() const { return document_.document_element(); }
    /// Line on which the element begins.
    size_t line(pugi::xml_node node) const;
    /// Throws InputError at the element's line.
    [[noreturn]] void fail(pugi::xml_node node, const std::string& message) const;

private:
    size_t lineOfOffset(ptrdiff_t offset) const;
    size_t lineOfText(pugi::xml_node node) const;
    void checkUtf8() const;
    void checkTree(pugi::xml_node parent, int depth) const;

    std::filesystem::path file_;
    MemoryClaim memory_;
    std::string text_;
    std::vector<ptrdiff_t> breaks_; ///< of lines, in text_
    pugi::xml_document document_;
};

/// Reports an element, or text, that has no effect.
void ignoreNode(pugi::xml_node node, LoadReport& report);

/// Typed access to one element's attributes. Getters return nothing where the attribute is absent
/// and throw InputError at the element's line where it is malformed.
class XmlAttributes {
public:
    XmlAttributes(const XmlFile& xml, pugi::xml_node node) : xml_(xml), node_(node) {}

    std::optional<std::string> text(const char* name) const;
    /// true, on, 1 or false, off, 0, in any case.
    std::optional<bool> boolean(const char* name) const;
    /// An integer in [lowest, highest].
    std::optional<int> integer(const char* name, int lowest, int highest) const;
    /// A finite number in [lowest, highest].
    std::optional<float> number(const char* name, double lowest, double highest) const;
    /// The same in double.
    std::optional<double> real(const char* name, double lowest, double highest) const;
    /// The same of any number that double holds, from \p lowest on.
    std::optional<double> wideReal(const char* name, double lowest) const;
    /// Three or four finite numbers, split at commas or blanks.
    std::optional<glm::dvec3> vector3(const char* name) const;
    std::optional<glm::dvec4> vector4(const char* name) const;
    /// Three numbers that are not negative.
    std::optional<glm::vec3> colour(const char* name) const;

    /// Reports every attribute that is not \p known, and not `name`, as ignored.
    void ignoreOthers(const std::function<bool(std::string_view)>& known, LoadReport& report) const;

private:
    [[noreturn]] void fail(const char* name, const std::string& message) const;
    /// Of magnitudes up to \p largest.
    bool numbers(const char* name, double* values, int count, double largest = FLT_MAX) const;

    const XmlFile& xml_;
    pugi::xml_node node_;
};

} // namespace dirt
