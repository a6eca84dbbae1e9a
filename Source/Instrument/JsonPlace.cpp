#include "Instrument/JsonPlace.h"

#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

void JsonPlace::fail(const std::string& predicate) const {
    throw Fault{name() + " " + predicate};
}

void JsonPlace::expectFormat(const std::string& kind, int newest) const {
    if (!value.is_object() || !value.contains("format") || value["format"] != "idiophone-" + kind)
        fail("is not an Idiophone " + kind);
    const int version = at("version").integer(1, 1'000'000'000);
    if (version > newest)
        fail("was made by a newer Idiophone (" + kind + " version " + std::to_string(version) +
             ")");
}

void JsonPlace::allow(std::initializer_list<std::string_view> members) const {
    if (!value.is_object())
        fail("is not a JSON object");
    for (const auto& [key, ignored] : value.items())
        if (std::ranges::find(members, key) == members.end())
            fail("has no " + inQuotes(key));
}

JsonPlace JsonPlace::at(const char* key) const {
    if (!value.is_object() || !value.contains(key))
        fail("lacks '" + std::string(key) + "'");
    return member(key);
}

JsonPlace JsonPlace::member(const std::string& key) const {
    return JsonPlace(value[key], (path.empty() ? "" : path + ".") + oneLine(key));
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
    if (!value.is_object())
        fail("is not a JSON object");
    std::vector<std::pair<std::string, JsonPlace>> all;
    for (const auto& [key, ignored] : value.items())
        all.emplace_back(key, member(key));
    return all;
}

std::vector<JsonPlace> JsonPlace::list(std::size_t most) const {
    if (!value.is_array())
        fail("is not a list");
    if (value.size() > most)
        fail("is a list of more than " + std::to_string(most));
    std::vector<JsonPlace> places;
    places.reserve(value.size());
    for (std::size_t k = 0; k < value.size(); ++k)
        places.emplace_back(value[k], path + "[" + std::to_string(k) + "]");
    return places;
}

double JsonPlace::number(double lowest, double highest) const {
    if (!value.is_number())
        fail("is not a number");
    const double number = value;
    if (!(number >= lowest && number <= highest))
        fail("is not between " + numberText(lowest, 10) + " and " + numberText(highest, 10));
    return number;
}

double JsonPlace::wholeNumber(double lowest, double highest) const {
    if (!value.is_number() || value.get<double>() != std::floor(value.get<double>()))
        fail("is not a whole number");
    return number(lowest, highest);
}

int JsonPlace::integer(int lowest, int highest) const {
    return static_cast<int>(wholeNumber(lowest, highest));
}

bool JsonPlace::truth() const {
    if (!value.is_boolean())
        fail("is neither true nor false");
    return value;
}

std::string JsonPlace::text() const {
    const auto text = textOrEmpty();
    if (text.empty())
        fail("is empty");
    return text;
}

std::string JsonPlace::textOrEmpty() const {
    if (!value.is_string())
        fail("is not a text");
    if (value.get_ref<const std::string&>().size() > longestTextBytes)
        fail("is longer than " + std::to_string(longestTextBytes) + " bytes");
    return value;
}

std::string JsonPlace::textCutTo(std::size_t maximumBytes) const {
    if (!value.is_string())
        fail("is not a text");
    const auto& text = value.get_ref<const std::string&>();
    auto size = std::min(text.size(), maximumBytes);
    while (size > 0 && size < text.size() &&
           (static_cast<unsigned char>(text[size]) & 0xc0) == 0x80)
        --size;
    return text.substr(0, size);
}

Eigen::Vector3d JsonPlace::vector(double reach) const {
    if (!value.is_array() || value.size() != 3)
        fail("is not a list of three numbers [x, y, z]");
    Eigen::Vector3d result;
    const auto coordinates = list(3);
    for (int axis = 0; axis < 3; ++axis)
        result(axis) = coordinates[static_cast<std::size_t>(axis)].number(-reach, reach);
    return result;
}

} // namespace idiophone
