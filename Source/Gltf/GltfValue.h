// SPDX-License-Identifier: Apache-2.0
// Reads the JSON of a glTF extension and knows where in the file it is. Internal to Gltf.
#pragma once

#include "Gltf/TinyGltf.h"
#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
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
    GltfValue(const tinygltf::Value* value, std::string place)
        : value_(value), place_(std::move(place)) {}

    /// Returns the extension of a thing in the file, which may lack it.
    static GltfValue extension(const tinygltf::ExtensionMap& extensions,
                               const char* name,
                               const std::string& owner = {}) {
        const auto found = extensions.find(name);
        return {found == extensions.end() ? nullptr : &found->second,
                owner.empty() ? name : owner + "." + name};
    }

    bool exists() const { return value_ != nullptr; }
    const std::string& place() const { return place_; }

    /// Throws Fault if this exists and is no object.
    GltfValue operator[](const char* key) const {
        if (exists() && !value_->IsObject())
            fail("is not an object");
        return {exists() && value_->Has(key) ? &value_->Get(key) : nullptr, place_ + "." + key};
    }

    /// Returns the number of elements, 0 if this is missing. Throws Fault if it is no list.
    std::size_t size() const {
        if (exists() && !value_->IsArray())
            fail("is not a list");
        return exists() ? value_->ArrayLen() : 0;
    }

    GltfValue operator[](std::size_t index) const {
        return {&value_->Get(static_cast<int>(index)), place_ + "[" + std::to_string(index) + "]"};
    }

    /// Returns the number, or `fallback` if this is missing.
    double number(double fallback, double least, double most) const {
        return exists() ? number(least, most) : fallback;
    }

    /// Bounds are inclusive.
    double number(double least = std::numeric_limits<double>::lowest(),
                  double most = std::numeric_limits<double>::max()) const {
        const double number = exists() && value_->IsNumber() ? value_->GetNumberAsDouble() : NAN;
        if (std::isnan(number))
            fail("is not a number");
        if (!(number >= least && number <= most))
            fail("is " + numberText(number) + ", which is out of range");
        return number;
    }

    std::optional<double> optionalNumber(double least, double most) const {
        return exists() ? std::optional(number(least, most)) : std::nullopt;
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
        const double number = exists() && value_->IsNumber() ? value_->GetNumberAsDouble() : -1;
        if (!(number >= 0 && number < static_cast<double>(count) && number == std::floor(number)))
            fail(exists() ? "names something that does not exist" : "is missing");
        return static_cast<std::size_t>(number);
    }

    std::optional<std::size_t> optionalIndex(std::size_t count) const {
        return exists() ? std::optional(index(count)) : std::nullopt;
    }

    bool flag(bool fallback) const {
        return exists() && value_->IsBool() ? value_->Get<bool>() : fallback;
    }

    /// Returns the text, or an empty one.
    std::string text() const {
        return exists() && value_->IsString() ? value_->Get<std::string>() : std::string{};
    }

    [[noreturn]] void fail(const std::string& fault) const {
        throw Fault{oneLine(place_, 200) + " " + fault};
    }

private:
    const tinygltf::Value* value_;
    std::string place_;
};

} // namespace idiophone
