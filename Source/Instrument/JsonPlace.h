// JSON with the way to it, so that what is wrong with a value names its place in the file.
#pragma once

#include "Object/Result.h"
#include "Object/UntrustedJson.h"

#include <Eigen/Core>
#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace idiophone {

/// A value and where it stands ("bodies[2].velocity"). What is asked for and is not there throws
/// Fault, for the reader of a whole file to catch.
class JsonPlace {
public:
    /// Of texts that are not cut. Paths of files are no longer, and what looks for one or shows one
    /// may take its time for each byte.
    static constexpr std::size_t longestTextBytes = 4096;

    struct Fault {
        std::string sentence; ///< "bodies[2].velocity is not a list of three numbers"
    };

    /// `placed` outlives the place; the way is empty for the whole file.
    explicit JsonPlace(const nlohmann::json& placed, std::string way = {})
        : value(placed), path(std::move(way)) {}

    [[noreturn]] void fail(const std::string& predicate) const;

    /// An object with these members and no others.
    void allow(std::initializer_list<std::string_view> members) const;
    bool has(const char* key) const { return value.contains(key); }
    JsonPlace at(const char* key) const; ///< of an object

    /// Of an object, with their keys.
    std::vector<std::pair<std::string, JsonPlace>> members() const;

    /// Each has its way, many times the bytes of a number in the file: hence `most`.
    std::vector<JsonPlace> list(std::size_t most) const;
    double number(double lowest, double highest) const;
    double wholeNumber(double lowest, double highest) const;
    int integer(int lowest, int highest) const;
    bool truth() const;
    std::string text() const; ///< not empty
    std::string textOrEmpty() const;
    /// Of any length, and cut to so many bytes, between characters.
    std::string textCutTo(std::size_t mostBytes) const;
    Eigen::Vector3d vector(double reach) const;
    const nlohmann::json& json() const { return value; }

    /// What it is called in a sentence.
    std::string name() const { return path.empty() ? "it" : path; }

private:
    JsonPlace member(const std::string& key) const;

    const nlohmann::json& value;
    std::string path;
};

/// What `parse` makes of a whole text, whose place it is given; where that throws a fault or the
/// text is no JSON, a sentence that begins with the name.
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
