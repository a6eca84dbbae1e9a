#include "Plugin/PresetText.h"

#include "Object/UntrustedJson.h"

#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using nlohmann::json; // where something is looked up: sorted
using nlohmann::ordered_json;
using Members = ordered_json::object_t;

/// As in all JSON here, the last of those with one key counts.
void keepOneOfEach(Members& members) {
    std::map<std::string_view, std::size_t> places;
    for (std::size_t k = 0; k < members.size(); ++k) {
        auto& [key, value] = members.begin()[static_cast<std::ptrdiff_t>(k)];
        const auto [place, isNew] = places.try_emplace(key, k);
        if (isNew)
            continue;
        members.begin()[static_cast<std::ptrdiff_t>(place->second)].second = std::move(value);
        value = ordered_json(ordered_json::value_t::discarded);
    }
    if (places.size() == members.size())
        return;
    Members kept;
    for (auto& [key, value] : members)
        if (!value.is_discarded())
            kept.emplace_back(key, std::move(value));
    members.swap(kept);
}

/// Nlohmann's parser looks at all members of an object before it adds one, which takes quadratic
/// time.
class InOrder : public nlohmann::json_sax<ordered_json> {
public:
    ordered_json root;

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; } // none in text
    bool start_object(std::size_t) override { return open(ordered_json::object()); }
    bool key(string_t& name) override {
        nextKey = std::move(name);
        return true;
    }
    bool end_object() override {
        keepOneOfEach(opened.back()->get_ref<Members&>());
        opened.pop_back();
        return true;
    }
    bool start_array(std::size_t) override { return open(ordered_json::array()); }
    bool end_array() override {
        opened.pop_back();
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const ordered_json::exception&) override {
        return false;
    }

private:
    bool add(ordered_json value) {
        place(std::move(value));
        return true;
    }
    bool open(ordered_json value) {
        opened.push_back(&place(std::move(value)));
        return true;
    }
    ordered_json& place(ordered_json value) {
        if (opened.empty())
            return root = std::move(value);
        auto& parent = *opened.back();
        if (parent.is_object())
            return parent.get_ref<Members&>().emplace_back(nextKey, std::move(value)).second;
        parent.push_back(std::move(value));
        return parent.back();
    }

    std::vector<ordered_json*> opened; ///< each in the one before it, which does not grow meanwhile
    std::string nextKey;
};

/// Null where it is none, or too deep to be written again.
ordered_json readInOrder(std::string_view text) {
    InOrder reader;
    if (parseUntrusted(text).is_discarded() || !json::sax_parse(text, &reader))
        return {};
    return std::move(reader.root);
}

std::string textOf(const ordered_json& root) {
    const auto dumped = [&](int indent) {
        return root.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
    };
    auto text = dumped(4);
    return text.size() <= largestPresetBytes ? text : dumped(-1);
}

/// Gives `now` the members that `before` has, and that are not in what this version knows of it.
void keepUnknown(const ordered_json& before, const json& known, ordered_json& now) {
    auto& members = now.get_ref<Members&>();
    std::map<std::string, std::size_t> places; // of those that it has itself
    for (const auto& [key, value] : members)
        places.emplace(key, places.size());
    for (const auto& [key, value] : before.items()) {
        const auto same = known.find(key);
        const auto place = places.find(key);
        if (place == places.end()) {
            if (same == known.end())
                members.emplace_back(key, value);
        } else if (same != known.end() && value.is_object() && same->is_object()) {
            auto& own = members.begin()[static_cast<std::ptrdiff_t>(place->second)].second;
            if (own.is_object())
                keepUnknown(value, *same, own);
        }
    }
}

} // namespace

Result<std::string> renamedPreset(std::string_view text, const std::string& name) {
    auto root = readInOrder(text);
    if (!root.is_object() || !root.contains("name"))
        return failure("it cannot be read, and so not renamed.");
    root["name"] = name;
    auto renamed = textOf(root);
    if (renamed.size() > largestPresetBytes)
        return failure("with that name it is too large for a preset.");
    return renamed;
}

std::string presetInPlaceOf(std::string_view before, const Preset& preset) {
    auto text = encodePreset(preset);
    const auto known = parsePreset(before, "");
    if (!known)
        return text;
    auto root = readInOrder(text);
    if (!root.is_object())
        return text;
    keepUnknown(readInOrder(before), json::parse(encodePreset(*known)), root);
    auto both = textOf(root);
    return both.size() <= largestPresetBytes ? both : text;
}

} // namespace idiophone
