// Collects the named groups of a mesh file while it is read. Internal to Geometry.
#pragma once

#include "Geometry/MeshFile.h"
#include "Geometry/MeshReader.h"
#include "Object/OneLine.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// Time and memory are bounded by the file: a line opens at most `maximumNames` groups.
class GroupNames {
public:
    static constexpr std::size_t maximumNames = 8;

    explicit GroupNames(std::vector<RawGroup>& groupsOfFile) : groups(groupsOfFile) {}

    /// Returns the numbers of the groups with the names of a line, which blanks separate.
    std::vector<std::size_t> numbersOf(TextScanner names) {
        std::vector<std::size_t> numbers;
        for (auto name = names.nextWord(); !name.empty() && numbers.size() < maximumNames;
             name = names.nextWord())
            add(name, numbers);
        return numbers;
    }
    /// Returns the number of the group whose name is the whole text; none for an empty text.
    std::vector<std::size_t> numberOf(std::string_view text) {
        std::vector<std::size_t> numbers;
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        if (const auto name = withoutBlankEnd(text); !name.empty())
            add(name, numbers);
        return numbers;
    }
    /// Adds a polygon to groups.
    void addTo(const std::vector<std::size_t>& numbers, std::size_t polygon) {
        for (const auto number : numbers)
            if (auto& polygons = groups[number].polygons;
                polygons.empty() || polygons.back() != polygon)
                polygons.push_back(polygon);
    }

private:
    void add(std::string_view text, std::vector<std::size_t>& numbers) {
        auto name = oneLine(text);
        const auto known = numberOfName.find(name);
        if (known != numberOfName.end())
            return numbers.push_back(known->second);
        if (groups.size() >= maximumMeshGroups)
            return;
        numbers.push_back(groups.size());
        numberOfName.emplace(name, groups.size());
        groups.push_back({.name = std::move(name), .polygons = {}});
    }

    std::vector<RawGroup>& groups;
    std::map<std::string, std::size_t> numberOfName;
};

} // namespace idiophone
