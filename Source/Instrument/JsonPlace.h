// Reads JSON with the path to each value, so that an error names the value's place in the file.
#pragma once

#include "Object/Result.h"
#include "Object/UntrustedJson.h"

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace idiophone {

/// A value and its path ("bodies[2].velocity"). A missing or wrong value throws Fault, which the
/// reader of a whole file catches.
class JsonPlace {
public:
    /// Maximum length of texts that are not cut. No file path is longer, and code that finds or
    /// shows a path may take time for each byte.
    static constexpr std::size_t longestTextBytes = 4096;

    struct Fault {
        std::string sentence; ///< "bodies[2].velocity is not a list of three numbers"
    };

    /// `placed` must outlive this object; the path of the whole file is empty.
    explicit JsonPlace(const nlohmann::json& placed, std::string pathTo = {})
        : value(placed), path(std::move(pathTo)) {}

    [[noreturn]] void fail(const std::string& predicate) const;

    /// Fails unless the value is an Idiophone file of that kind, such as "preset", and its version
    /// is at most `newest`.
    void expectFormat(const std::string& kind, int newest) const;
    /// Fails unless the value is an object with these members only.
    void allow(std::initializer_list<std::string_view> members) const;
    bool has(const char* key) const { return value.contains(key); }
    JsonPlace at(const char* key) const; ///< fails unless the value is an object with this member

    /// Returns the members of an object with their keys.
    std::vector<std::pair<std::string, JsonPlace>> members() const;

    /// Returns the entries, at most `most`. The limit is needed because an entry's path takes many
    /// times the bytes of a number in the file.
    std::vector<JsonPlace> list(std::size_t most) const;
    double number(double lowest, double highest) const;
    double wholeNumber(double lowest, double highest) const;
    int integer(int lowest, int highest) const;
    bool truth() const;
    std::string text() const; ///< not empty
    std::string textOrEmpty() const;
    /// Returns a text of any length, cut between characters to at most `maximumBytes`.
    std::string textCutTo(std::size_t maximumBytes) const;
    Eigen::Vector3d vector(double reach) const;
    const nlohmann::json& json() const { return value; }

    /// Returns the value's name in a sentence.
    std::string name() const { return path.empty() ? "it" : path; }

private:
    JsonPlace member(const std::string& key) const;

    const nlohmann::json& value;
    std::string path;
};

/// Reads a member by a function of JsonPlace, or one that takes a JsonPlace first. Without the
/// member the value stays.
template <class Value, class Function, class... Arguments>
void read(const JsonPlace& place,
          const char* key,
          Value& value,
          Function function,
          const Arguments&... arguments) {
    if (place.has(key))
        value = static_cast<Value>(std::invoke(function, place.at(key), arguments...));
}

/// Returns `parse` of the whole text's root. If that throws a fault, or the text is not JSON,
/// returns an error that begins with the name.
template <class Parse>
auto parsedJson(std::string_view text, std::string_view name, const Parse& parse)
    -> Result<std::invoke_result_t<Parse, JsonPlace>> {
    const auto refuse = [&](const std::string& sentence) {
        return failure(std::string(name) + ": " + sentence);
    };
    try {
        const auto root = parseUntrusted(text);
        if (root.is_discarded())
            return refuse("it is not JSON" + placeOfJsonFault(text));
        return parse(JsonPlace(root));
    } catch (const JsonPlace::Fault& fault) {
        return refuse(fault.sentence);
    } catch (const nlohmann::json::exception&) {
        return refuse("it is damaged");
    }
}

} // namespace idiophone
