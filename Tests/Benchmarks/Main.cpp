// The program `idiophone-bench`: measures the engine in ratios of times taken side by side.
#include "Benchmarks/FactoryContent.h"
#include "Console/JsonText.h"
#include "Console/OptionChecks.h"
#include "Console/ProgressLine.h"
#include "Object/TextFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

namespace idiophone {
namespace {

struct Options {
    std::vector<std::string> names;
    std::filesystem::path song;
    std::filesystem::path output;
    int pluginReplays = BenchContent{}.pluginReplays;
    bool json = false;
    bool check = false;
};

void addOptions(CLI::App& program, Options& options) {
    std::vector<std::string> names;
    std::string description = "Benchmarks to run; none means all:";
    for (const NamedBenchmark& known : namedBenchmarks()) {
        names.emplace_back(known.name);
        description += std::string("\n") + known.name + ": " + known.description;
    }
    program.add_option("NAME", options.names, description)->check(CLI::IsMember(names));
    program.add_option("--song", options.song, "The MIDI file that `xylophone` plays");
    program.add_option("-o,--output", options.output, "The file to write");
    program.add_option("--replays", options.pluginReplays, "Replays of each preset by `plugin`")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    program.add_flag("--json", options.json, "Writes goals and raw figures as JSON");
    program.add_flag("--check", options.check, "Fails if a goal is missed");
}

/// Without names, runs all benchmarks; xylophone needs a song.
bool isWanted(const NamedBenchmark& known, const Options& options) {
    if (options.names.empty())
        return std::string_view(known.name) != "xylophone" || !options.song.empty();
    return std::ranges::find(options.names, known.name) != options.names.end();
}

Result<std::vector<BenchSection>> runWanted(const Options& options) {
    auto content = factoryBenchContent(options.song);
    if (!content)
        return tl::unexpected(content.error());
    content->pluginReplays = options.pluginReplays;
    std::vector<BenchSection> sections;
    ProgressLine progress("idiophone-bench");
    const auto all = namedBenchmarks();
    for (const NamedBenchmark& known : all) {
        if (!isWanted(known, options))
            continue;
        progress.show(static_cast<double>(&known - all.data()) / static_cast<double>(all.size()),
                      known.name);
        auto section = known.run(*content);
        if (!section)
            return tl::unexpected(section.error());
        sections.push_back(std::move(*section));
    }
    return sections;
}

Result<void> bench(const Options& options) {
    if (!options.output.empty())
        if (auto writable = checkWritable(options.output); !writable)
            return writable;
    const auto sections = runWanted(options);
    if (!sections)
        return tl::unexpected(sections.error());
    const std::string text =
        options.json ? jsonText(benchDocument(*sections)) : benchText(*sections);
    if (options.output.empty())
        std::cout << text;
    else if (auto written = writeTextFile(options.output, text); !written)
        return written;
    const auto isMissed = [](const BenchGoal& goal) { return !goal.met(); };
    for (const BenchSection& section : *sections)
        if (const auto missed = std::ranges::find_if(section.goals, isMissed);
            options.check && missed != section.goals.end())
            return failure("The goal is missed: " + missed->name);
    return {};
}

} // namespace
} // namespace idiophone

int main(int argc, char** argv) {
    const auto complain = [](const std::string& sentence) {
        std::cerr << "idiophone-bench: " << sentence << std::endl;
        return 1;
    };
    CLI::App program("Measures the engine in ratios of times taken side by side in this run",
                     "idiophone-bench");
    idiophone::Options options;
    idiophone::addOptions(program, options);
    try {
        program.parse(argc, argv);
        const auto outcome = idiophone::bench(options);
        return outcome ? 0 : complain(outcome.error().message);
    } catch (const CLI::Success& help) {
        return program.exit(help);
    } catch (const std::exception& exception) {
        return complain(exception.what());
    }
}
