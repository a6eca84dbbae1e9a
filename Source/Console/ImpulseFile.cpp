#include "Console/ImpulseFile.h"

#include "Object/ByteOrderMark.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Object/TextFile.h"
#include "Object/UntrustedJson.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

namespace idiophone {
namespace {

using nlohmann::json;

constexpr std::size_t faultsShown = 20;
constexpr double longestSeconds = 36000;
constexpr double longestContactSeconds = 1;
// The bound is generous: a lorry at motorway speed has 1e6 N s.
constexpr double largestImpulse = 1e6;
constexpr double maximumImpactMetres = 1e6;

// Inside this file an error in a line is an exception.
struct Fault {
    std::string sentence;
};

double number(const json& value, const std::string& what, double lowest, double highest) {
    if (!value.is_number())
        throw Fault{what + " is not a number"};
    const double result = value;
    if (!(result >= lowest && result <= highest)) {
        std::ostringstream range;
        range << what << " is not between " << lowest << " and " << highest;
        throw Fault{range.str()};
    }
    return result;
}

std::array<double, 3> vector(const json& value, const std::string& what, double reach) {
    if (!value.is_array() || value.size() != 3)
        throw Fault{what + " is not a list of three numbers [x, y, z]"};
    std::array<double, 3> result{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        result[axis] = number(value[axis], "a coordinate of " + what, -reach, reach);
    return result;
}

std::string objectName(const json& value) {
    if (!value.is_string() || value.get_ref<const std::string&>().empty())
        throw Fault{"'object' is not a string"};
    return value;
}

std::string bodyName(const json& value) {
    if (value.is_number_integer())
        return value.dump();
    if (!value.is_string())
        throw Fault{"'body' is neither a string nor an integer"};
    return value;
}

std::int64_t vertexNumber(const json& value) {
    if (!value.is_number_integer() || value < 0 || value > std::int64_t{1} << 31)
        throw Fault{"'vertex' is not a vertex number"};
    return value;
}

void parseMember(const std::string& key, const json& value, Impulse& impulse) {
    if (key == "time")
        impulse.seconds = number(value, "'time'", 0, longestSeconds);
    else if (key == "object")
        impulse.object = objectName(value);
    else if (key == "body")
        impulse.body = bodyName(value);
    else if (key == "vertex")
        impulse.vertex = vertexNumber(value);
    else if (key == "point")
        impulse.pointMetres = vector(value, "'point'", maximumImpactMetres);
    else if (key == "impulse")
        impulse.impulseNewtonSeconds = vector(value, "'impulse'", largestImpulse);
    else if (key == "contact_time")
        impulse.contactSeconds = number(value, "'contact_time'", 0, longestContactSeconds);
    else if (key == "size")
        impulse.sizeRatio = number(value, "'size'", 0.001, 1000);
    else
        throw Fault{"an impulse has no " + inQuotes(key)};
}

/// Returns why a line is not JSON. Some programs write NaN, for example.
Fault notJson(std::string_view text) {
    const auto at = firstByteNotJson(text);
    if (!at)
        return {"it is nested too deeply"};
    if (text.find_first_not_of(" \t\r", *at) == std::string_view::npos)
        return {"it is not JSON: it ends too early"};
    const auto isOfWord = [](char c) {
        return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
               c == '+' || c == '-' || c == '.' || c == '_';
    };
    std::size_t from = *at, to = from + 1;
    if (isOfWord(text[from])) {
        for (; from > 0 && isOfWord(text[from - 1]); --from) {
        }
        for (; to < text.size() && isOfWord(text[to]); ++to) {
        }
    }
    return {"it is not JSON: " + inQuotes(text.substr(from, to - from)) + " in column " +
            std::to_string(from + 1)};
}

Impulse parseLine(const std::string& text) {
    const auto root = parseUntrusted(text);
    if (root.is_discarded())
        throw notJson(text);
    if (!root.is_object())
        throw Fault{"it is not a JSON object"};
    for (const char* key : {"time", "object", "impulse"})
        if (!root.contains(key))
            throw Fault{"it has no '" + std::string(key) + "'"};
    if (root.contains("vertex") == root.contains("point"))
        throw Fault{"it needs either 'vertex' or 'point'"};
    Impulse impulse;
    for (const auto& [key, value] : root.items())
        parseMember(key, value, impulse);
    return impulse;
}

bool isBlankOrComment(const std::string& line) {
    const auto first = line.find_first_not_of(" \t\r");
    return first == std::string::npos || line[first] == '#';
}

} // namespace

void BadLines::add(int line, const std::string& sentence) {
    ++count;
    if (first.size() == faultsShown && line > first.rbegin()->first)
        return;
    first.emplace(line, sentence);
    if (first.size() > faultsShown)
        first.erase(std::prev(first.end()));
}

Error BadLines::error(const std::filesystem::path& file) const {
    std::string sentences;
    for (const auto& [line, sentence] : first)
        sentences += (sentences.empty() ? "" : "\n") + nameOf(file) + ": line " +
                     std::to_string(line) + ": " + sentence;
    if (count > first.size())
        sentences += "\nand " + std::to_string(count - first.size()) + " more bad lines.";
    return {sentences};
}

Result<std::vector<Impulse>> readImpulses(const std::filesystem::path& file) {
    const auto text = readTextFile(file);
    if (!text)
        return tl::unexpected(text.error());
    std::vector<Impulse> impulses;
    BadLines faults;
    std::istringstream lines{std::string(withoutByteOrderMark(*text))};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (isBlankOrComment(line))
            continue;
        try {
            impulses.push_back(parseLine(line));
            impulses.back().line = number;
        } catch (const Fault& fault) {
            faults.add(number, fault.sentence);
        }
    }
    if (!faults.empty())
        return tl::unexpected(faults.error(file));
    if (impulses.empty())
        return failure(nameOf(file) + ": it holds no impulses");
    std::ranges::stable_sort(impulses, {}, &Impulse::seconds);
    return impulses;
}

} // namespace idiophone
