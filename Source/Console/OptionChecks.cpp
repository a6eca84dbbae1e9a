#include "Console/OptionChecks.h"

#include "Geometry/LengthUnit.h"
#include "Object/FileBeside.h"
#include "Object/FileBytes.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace idiophone {
namespace {

bool isWritten(const CLI::Option& option) {
    return option.get_type_name() == writtenFile;
}

/// Returns the given options, including those in option groups.
std::vector<const CLI::Option*> givenOptions(const CLI::App& command) {
    std::vector<const CLI::Option*> given;
    for (const auto* option :
         command.get_options([](const auto* each) { return each->count() > 0; }))
        given.push_back(option);
    for (const auto* group :
         command.get_subcommands([](const CLI::App* each) { return each->get_name().empty(); }))
        std::ranges::copy(givenOptions(*group), std::back_inserter(given));
    return given;
}

/// Returns a unique path for a place, whether the file exists or not.
std::filesystem::path normal(const std::string& file) {
    std::error_code fault;
    auto place = std::filesystem::weakly_canonical(std::filesystem::absolute(file, fault), fault);
    return fault ? std::filesystem::path(file).lexically_normal() : place;
}

bool areSame(const std::filesystem::path& one, const std::filesystem::path& other) {
    std::error_code fault;
    return std::filesystem::is_regular_file(one, fault) &&
           std::filesystem::equivalent(one, other, fault);
}

/// Recordings are given as FILE@PLACE.
bool names(const std::string& given, const std::filesystem::path& file) {
    return areSame(file, given) || areSame(file, given.substr(0, given.rfind('@')));
}

} // namespace

CLI::Validator unitOfLength() {
    return CLI::Validator(
        [](std::string& given) -> std::string {
            return lengthUnitNamed(given) ? "" : "'" + given + "' is none of m, cm, mm, in and ft";
        },
        "");
}

CLI::Validator numberBetween(double lowest, double highest) {
    std::ostringstream range;
    range << lowest << " to " << highest;
    return CLI::Validator(
        [lowest, highest, text = range.str()](std::string& given) -> std::string {
            double number = 0;
            if (CLI::detail::lexical_cast(given, number) && number >= lowest && number <= highest)
                return {};
            return "'" + given + "' is not a number from " + text;
        },
        range.str());
}

Result<void> checkWritable(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto there = std::filesystem::status(file, ignored);
    if (std::filesystem::is_directory(there))
        return failure(nameOf(file) + ": it is a directory");
    if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
        return {}; // a device or a pipe, which is written directly
    const auto trial = makeFileBeside(behindLinks(file));
    if (!trial)
        return failure(nameOf(file) + ": the file cannot be written");
    std::filesystem::remove(*trial, ignored);
    return {};
}

Result<void> makeDirectory(const std::filesystem::path& directory) {
    std::error_code fault;
    std::filesystem::create_directories(directory, fault);
    if (!std::filesystem::is_directory(directory, fault))
        return failure(nameOf(directory) + ": the directory cannot be created");
    return {};
}

Result<void> checkWrittenFiles(const CLI::App& command) {
    const auto options = givenOptions(command);
    for (const auto* written : options) {
        if (!isWritten(*written))
            continue;
        const auto& file = written->results().front();
        for (const auto* other : options) {
            if (written == other)
                continue;
            const bool areNew =
                isWritten(*other) && normal(file) == normal(other->results().front());
            if (areNew || std::ranges::any_of(other->results(), [&](const auto& given) {
                    return names(given, file);
                }))
                return failure(file + ": " + written->get_name() + " would replace the file that " +
                               other->get_name() + " names");
        }
        if (auto writable = checkWritable(file); !writable)
            return writable;
    }
    return {};
}

} // namespace idiophone
