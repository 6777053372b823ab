#include "core/io/json_value.h"

#include "core/io/load_report.h"
#include "core/io/number.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace dirt {

namespace {

using Json = nlohmann::json;

std::optional<uint64_t> wholeNumber(const Json& value, uint64_t highest) {
    // 3.0 is a whole number, too: JSON knows one kind of number.
    double number = 0.0;
    if (value.is_number_unsigned())
        return value.get<uint64_t>() <= highest ? std::optional(value.get<uint64_t>())
                                                : std::nullopt;
    if (value.is_number_float()) number = value.get<double>();
    if (!value.is_number_float() || !(number >= 0.0 && number <= (double) highest) ||
        number >= 0x1p53 || number != (double) (uint64_t) number)
        return std::nullopt;
    return (uint64_t) number;
}

std::string range(uint64_t highest) {
    return " is not a whole number from 0 to " + std::to_string(highest);
}

/// Leaves nothing in \p value, leaves first, so that no destructor meets children; but for what is
/// nested deeper than any file that means something, and than the stack would bear.
void empty(Json& value, int depth = 0) {
    constexpr int kDeepest = 512;
    if (!value.is_structured() || depth > kDeepest) return;
    for (Json& child : value) empty(child, depth + 1);
    value.clear();
}

} // namespace

void JsonValue::fail(const std::string& message) const {
    failAt(*file_, 0, (place_.empty() ? "the root" : place_) + " " + message);
}

bool JsonValue::isObject() const {
    return value_->is_object();
}

bool JsonValue::has(const char* name) const {
    return value_->contains(name);
}

std::optional<JsonValue> JsonValue::member(const char* name) const {
    if (!isObject()) fail("is not an object");
    const auto found = value_->find(name);
    if (found == value_->end()) return std::nullopt;
    return JsonValue(*this, *found, (place_.empty() ? "" : place_ + ".") + name);
}

JsonValue JsonValue::required(const char* name) const {
    const auto value = member(name);
    if (!value) fail("has no " + std::string(name));
    return *value;
}

std::optional<JsonValue> JsonValue::object(const char* name) const {
    auto value = member(name);
    if (value && !value->isObject()) value->fail("is not an object");
    return value;
}

std::vector<JsonValue> JsonValue::objects(const char* name) const {
    std::vector<JsonValue> list;
    const auto value = member(name);
    if (!value) return list;
    if (!value->value_->is_array()) value->fail("is not an array");
    for (size_t i = 0; i < value->value_->size(); ++i) {
        list.push_back(
            JsonValue(*value, (*value->value_)[i], value->place_ + "[" + std::to_string(i) + "]"));
        if (!list.back().isObject()) list.back().fail("is not an object");
    }
    return list;
}

const JsonValue& JsonValue::at(const std::vector<JsonValue>& list, uint64_t index,
                               const JsonValue& from, const char* name) {
    if (index >= list.size())
        from.fail("refers to " + std::string(name) + "[" + std::to_string(index) +
                  "], of which there are " + std::to_string(list.size()));
    return list[index];
}

std::optional<uint64_t> JsonValue::integer(const char* name, uint64_t highest) const {
    const auto value = member(name);
    if (!value) return std::nullopt;
    const auto number = wholeNumber(*value->value_, highest);
    if (!number) value->fail("is" + range(highest).substr(3));
    return number;
}

uint64_t JsonValue::requiredInteger(const char* name, uint64_t highest) const {
    required(name);
    return *integer(name, highest);
}

std::optional<double> JsonValue::number(const char* name, double lowest, double highest) const {
    const auto value = member(name);
    if (!value) return std::nullopt;
    if (!value->value_->is_number()) value->fail("is not a number");
    const double number = value->value_->get<double>();
    if (!(number >= lowest && number <= highest)) value->fail("is out of range");
    return number;
}

std::optional<bool> JsonValue::boolean(const char* name) const {
    const auto value = member(name);
    if (!value) return std::nullopt;
    if (!value->value_->is_boolean()) value->fail("is neither true nor false");
    return value->value_->get<bool>();
}

std::optional<std::string> JsonValue::text(const char* name) const {
    const auto value = member(name);
    if (!value) return std::nullopt;
    if (!value->value_->is_string()) value->fail("is not a string");
    return value->value_->get<std::string>();
}

std::optional<std::vector<double>> JsonValue::numbers(const char* name, size_t count) const {
    const auto value = member(name);
    if (!value) return std::nullopt;
    std::vector<double> list;
    if (value->value_->is_array())
        for (const Json& element : *value->value_) {
            if (!element.is_number() || !fitsFloat(element.get<double>())) break;
            list.push_back(element.get<double>());
        }
    if (list.size() != count || list.size() != value->value_->size())
        value->fail("is not a list of " + std::to_string(count) + " finite numbers");
    return list;
}

std::vector<uint64_t> JsonValue::integers(const char* name, uint64_t highest) const {
    const auto value = member(name);
    if (!value) return {};
    if (!value->value_->is_array()) value->fail("is not an array");
    std::vector<uint64_t> list;
    for (const Json& element : *value->value_) {
        const auto number = wholeNumber(element, highest);
        if (!number) value->fail("holds what" + range(highest));
        list.push_back(*number);
    }
    return list;
}

std::vector<std::string> JsonValue::names() const {
    std::vector<std::string> list;
    if (isObject())
        for (const auto& [name, value] : value_->items()) list.push_back(name);
    return list;
}

uint64_t jsonBytes(std::string_view text) {
    // A value takes 16 bytes, and more while its array grows; a member is a node of a tree, with
    // its name; an object or an array lies by itself; and objects in lists become JsonValues.
    constexpr uint64_t kElement = 40, kMember = 128, kArray = 64, kObject = 256;
    const auto count = [text](char c) {
        return (uint64_t) std::count(text.begin(), text.end(), c);
    };
    return text.size() + kElement * count(',') + kMember * count(':') + kArray * count('[') +
           kObject * count('{');
}

void JsonDeleter::operator()(nlohmann::json* document) const {
    empty(*document);
    delete document;
}

Json parseJson(const std::filesystem::path& file, std::string_view text, bool hasLines) {
    try {
        return Json::parse(text.begin(), text.end());
    } catch (const Json::parse_error& error) {
        const size_t before = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
        const auto breaks = std::count(text.begin(), text.begin() + (ptrdiff_t) before, '\n');
        failAt(file, hasLines ? (size_t) breaks + 1 : 0, "is no well-formed JSON");
    } catch (const Json::exception&) {
        failAt(file, 0, "is no JSON that can be read: a number is too large");
    }
}

} // namespace dirt
