#include "app/cli/option_values.h"

#include "core/base/error.h"
#include "core/io/number.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

namespace dirt {

namespace {

/// Reads all of \p text as a number; false where it is anything else.
template <class Number>
bool parse(std::string_view text, Number& value) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
}

[[noreturn]] void refuse(const std::string& name, const std::string& text,
                         const std::string& expected) {
    throw InputError(name + ": '" + text + "' is not " + expected);
}

} // namespace

Option addInteger(Command command, const std::string& name, int64_t low, int64_t high,
                  const std::string& help, const std::function<void(int64_t)>& set) {
    const std::string expected =
        "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
    return command.addReader(name, "N", help, [=](const std::string& text) {
        int64_t value = 0;
        if (!parse(text, value) || value < low || value > high) refuse(name, text, expected);
        set(value);
    });
}

std::vector<int> readIntegers(const std::string& name, const std::string& text, size_t count,
                              int high, const std::string& typeName) {
    std::vector<int> values;
    std::string_view rest = text;
    for (bool more = true; more && values.size() < count;) {
        const size_t comma = rest.find(',');
        int value = 0;
        if (!parse(rest.substr(0, comma), value) || value < 0 || value > high) break;
        values.push_back(value);
        more = comma != rest.npos;
        rest = more ? rest.substr(comma + 1) : std::string_view();
    }
    if (values.size() != count || !rest.empty() || text.back() == ',')
        refuse(name, text, typeName + ", whole numbers from 0 to " + std::to_string(high));
    return values;
}

Option addIntegers(Command command, const std::string& name, size_t count, int high,
                   const std::string& typeName, const std::string& help,
                   const std::function<void(const std::vector<int>&)>& set) {
    return command.addReader(name, typeName, help, [=](const std::string& text) {
        set(readIntegers(name, text, count, high, typeName));
    });
}

Option addNumber(Command command, const std::string& name, float low, float high,
                 const std::string& help, const std::function<void(float)>& set) {
    const auto show = [](float bound) {
        char text[32];
        return std::string(text, std::to_chars(text, text + sizeof text, bound).ptr);
    };
    const std::string expected = "a number between " + show(low) + " and " + show(high);
    return command.addReader(name, "NUMBER", help, [=](const std::string& text) {
        float value = 0.0f;
        if (!parse(text, value) || !(value > low && value < high)) refuse(name, text, expected);
        set(value);
    });
}

Option addNumbers(Command command, const std::string& name, size_t count,
                  const std::string& typeName, const std::string& help,
                  const std::function<void(const std::vector<double>&)>& set) {
    constexpr const char* kCounts[] = {"no", "one", "two", "three", "four", "five", "six"};
    const std::string expected = std::string(kCounts[count]) + " numbers " + typeName;
    return command.addReader(name, typeName, help, [=](const std::string& text) {
        std::vector<double> values;
        std::string_view rest = text;
        for (bool more = true; more;) {
            const size_t comma = rest.find(',');
            double value = 0.0;
            if (!parse(rest.substr(0, comma), value) || !fitsFloat(value))
                refuse(name, text, expected);
            values.push_back(value);
            more = comma != rest.npos;
            if (more) rest.remove_prefix(comma + 1);
        }
        if (values.size() != count) refuse(name, text, expected);
        set(values);
    });
}

Option addVector(Command command, const std::string& name, const std::string& help,
                 const std::function<void(glm::dvec3)>& set) {
    return addNumbers(command, name, 3, "X,Y,Z", help, [set](const std::vector<double>& v) {
        set({v[0], v[1], v[2]});
    });
}

Option addChoice(Command command, const std::string& name, const std::vector<std::string>& words,
                 const std::string& help, const std::function<void(size_t)>& set) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : "|") + word;
    return command.addReader(name, list, help, [=](const std::string& text) {
        for (size_t i = 0; i < words.size(); ++i)
            if (text == words[i]) return set(i);
        refuse(name, text, "one of " + list);
    });
}

Option addSize(Command command, const std::string& name, int high, const std::string& help,
               const std::function<void(int width, int height)>& set) {
    const std::string expected =
        "a size WxH of 1x1 to " + std::to_string(high) + "x" + std::to_string(high) + " pixels";
    return command.addReader(name, "WxH", help, [=](const std::string& text) {
        const std::string_view all = text;
        const size_t cross = all.find_first_of("xX");
        int width = 0, height = 0;
        if (cross == all.npos || !parse(all.substr(0, cross), width) ||
            !parse(all.substr(cross + 1), height) || width < 1 || height < 1 || width > high ||
            height > high)
            refuse(name, text, expected);
        set(width, height);
    });
}

Option addRange(Command command, const std::string& name, int high, const std::string& help,
                const std::function<void(int first, int last)>& set) {
    const std::string expected = "a range A:B, from 0 to " + std::to_string(high);
    return command.addReader(name, "A:B", help, [=](const std::string& text) {
        const std::string_view all = text;
        const size_t colon = all.find(':');
        int first = 0, last = 0;
        if (colon == all.npos || !parse(all.substr(0, colon), first) ||
            !parse(all.substr(colon + 1), last) || first < 0 || last < first || last > high)
            refuse(name, text, expected);
        set(first, last);
    });
}

Option addBytes(Command command, const std::string& name, const std::string& help,
                const std::function<void(uint64_t)>& set) {
    return command.addReader(name, "SIZE", help, [=](const std::string& text) {
        constexpr std::string_view kUnits = "KMGT";
        std::string_view number = text;
        if (number.ends_with('B') || number.ends_with('b')) number.remove_suffix(1);
        double unit = 1.0;
        const size_t place =
            number.empty() ? kUnits.npos : kUnits.find((char) std::toupper(number.back()));
        if (place != kUnits.npos) {
            unit = std::pow(1000.0, (double) (place + 1));
            number.remove_suffix(1);
        }
        double value = 0.0;
        if (!parse(number, value) || !(value * unit >= 1e6 && value * unit <= 1e18))
            refuse(name, text, "a size of at least 1M, as in 12G or 800M");
        set((uint64_t) (value * unit));
    });
}

} // namespace dirt
