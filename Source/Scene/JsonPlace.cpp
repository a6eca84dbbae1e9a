#include "Scene/JsonPlace.h"

#include "Object/OneLine.h"

#include <algorithm>
#include <sstream>

namespace idiophone {

void JsonPlace::fail(const std::string& predicate) const {
    throw Fault{name() + " " + predicate};
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
    return JsonPlace(value[key], path.empty() ? key : path + "." + key);
}

std::vector<JsonPlace> JsonPlace::list(std::size_t most) const {
    if (!value.is_array() || value.size() > most)
        fail("is not a list of at most " + std::to_string(most));
    std::vector<JsonPlace> places;
    for (std::size_t k = 0; k < value.size(); ++k)
        places.emplace_back(value[k], path + "[" + std::to_string(k) + "]");
    return places;
}

double JsonPlace::number(double lowest, double highest) const {
    if (!value.is_number())
        fail("is not a number");
    const double number = value;
    if (!(number >= lowest && number <= highest)) {
        std::ostringstream range;
        range << "is not between " << lowest << " and " << highest;
        fail(range.str());
    }
    return number;
}

int JsonPlace::integer(int lowest, int highest) const {
    if (!value.is_number_integer())
        fail("is not a whole number");
    return static_cast<int>(number(lowest, highest));
}

bool JsonPlace::truth() const {
    if (!value.is_boolean())
        fail("is neither true nor false");
    return value;
}

std::string JsonPlace::text() const {
    if (!value.is_string() || value.get_ref<const std::string&>().empty())
        fail("is not a text");
    return value;
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
