// SPDX-License-Identifier: Apache-2.0
// Reads the JSON of a glTF extension and knows where in the file it is. Internal to Gltf.
#pragma once

#include "Gltf/GltfDocument.h"
#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

namespace idiophone {

class GltfValue {
public:
    /// The end of a sentence that begins with the file's name. Public functions turn it into a
    /// Result.
    struct Fault {
        std::string sentence;
    };

    /// `value` may be null: then the member is missing.
    GltfValue(const nlohmann::json* value, std::string place)
        : value_(value), place_(std::move(place)) {}

    /// Returns an extension of the whole file, or of a node, which may lack it.
    static GltfValue extension(const GltfDocument& document, const char* name) {
        return GltfValue(&document.json(), "")["extensions"].named(name, name);
    }
    static GltfValue
    extensionOfNode(const GltfDocument& document, std::size_t node, const char* name) {
        const auto place = "nodes[" + std::to_string(node) + "]";
        return GltfValue(&document.json(), "")["nodes"][node]["extensions"].named(
            name, place + "." + name);
    }

    bool exists() const { return value_ != nullptr; }
    const std::string& place() const { return place_; }

    /// Throws Fault if this exists and is no object.
    GltfValue operator[](const char* key) const { return named(key, place_ + "." + key); }

    /// Returns the number of elements, 0 if this is missing. Throws Fault if it is no list.
    std::size_t size() const {
        if (exists() && !value_->is_array())
            fail("is not a list");
        return exists() ? value_->size() : 0;
    }

    GltfValue operator[](std::size_t index) const {
        return {&value_->at(index), place_ + "[" + std::to_string(index) + "]"};
    }

    /// Returns the number, or `fallback` if this is missing.
    double number(double fallback, double minimum, double maximum) const {
        return exists() ? number(minimum, maximum) : fallback;
    }

    /// Bounds are inclusive.
    double number(double minimum = std::numeric_limits<double>::lowest(),
                  double maximum = std::numeric_limits<double>::max()) const {
        const double number = asNumber();
        if (std::isnan(number))
            fail("is not a number");
        if (!(number >= minimum && number <= maximum))
            fail("is " + numberText(number) + ", which is out of range");
        return number;
    }

    std::optional<double> optionalNumber(double minimum, double maximum) const {
        return exists() ? std::optional(number(minimum, maximum)) : std::nullopt;
    }

    template <std::size_t count>
    std::array<double, count> numbers(const std::array<double, count>& fallback) const {
        if (!exists())
            return fallback;
        if (size() != count)
            fail("has not " + std::to_string(count) + " numbers");
        std::array<double, count> result;
        for (std::size_t i = 0; i < count; ++i)
            result[i] = (*this)[i].number();
        return result;
    }

    /// Returns an index into a list of `count` things.
    std::size_t index(std::size_t count) const {
        const double number = asNumber();
        if (!(number >= 0 && number < static_cast<double>(count) && number == std::floor(number)))
            fail(exists() ? "names something that does not exist" : "is missing");
        return static_cast<std::size_t>(number);
    }

    std::optional<std::size_t> optionalIndex(std::size_t count) const {
        return exists() ? std::optional(index(count)) : std::nullopt;
    }

    bool flag(bool fallback) const {
        return exists() && value_->is_boolean() ? value_->get<bool>() : fallback;
    }

    /// Returns the text, or an empty one.
    std::string text() const {
        return exists() && value_->is_string() ? value_->get<std::string>() : std::string{};
    }

    [[noreturn]] void fail(const std::string& fault) const {
        throw Fault{oneLine(place_, 200) + " " + fault};
    }

private:
    GltfValue named(const char* key, std::string place) const {
        if (exists() && !value_->is_object())
            fail("is not an object");
        return {exists() && value_->contains(key) ? &value_->at(key) : nullptr, std::move(place)};
    }

    double asNumber() const {
        return exists() && value_->is_number() ? value_->get<double>() : NAN;
    }

    const nlohmann::json* value_;
    std::string place_;
};

} // namespace idiophone
