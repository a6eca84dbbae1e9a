#include "Console/BenchFactoryContent.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/OptionChecks.h"
#include "Console/OutputCheck.h"
#include "Console/ProgressLine.h"
#include "Object/TextFile.h"

#include <algorithm>
#include <iostream>

namespace idiophone {
namespace {

struct Options {
    std::vector<std::string> names;
    std::filesystem::path song;
    std::filesystem::path output;
    bool json = false;
};

std::vector<std::string> benchmarkNames() {
    std::vector<std::string> names;
    for (const NamedBenchmark& known : namedBenchmarks())
        names.emplace_back(known.name);
    return names;
}

std::string describeBenchmarks() {
    std::string text = "Benchmarks; none means all:";
    for (const NamedBenchmark& known : namedBenchmarks())
        text += std::string("\n") + known.name + ": " + known.description;
    return text;
}

/// Without names, runs all benchmarks; xylophone needs a song.
bool isWanted(const NamedBenchmark& known, const Options& options) {
    if (options.names.empty())
        return std::string_view(known.name) != "xylophone" || !options.song.empty();
    return std::ranges::find(options.names, known.name) != options.names.end();
}

Result<std::vector<BenchSection>> runWanted(const Options& options) {
    const auto content = factoryBenchContent(options.song);
    if (!content)
        return tl::unexpected(content.error());
    std::vector<const NamedBenchmark*> wanted;
    for (const NamedBenchmark& known : namedBenchmarks())
        if (isWanted(known, options))
            wanted.push_back(&known);
    std::vector<BenchSection> sections;
    ProgressLine progress("bench");
    for (const NamedBenchmark* known : wanted) {
        progress.show(static_cast<double>(sections.size()) / static_cast<double>(wanted.size()),
                      known->name);
        auto section = known->run(*content);
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
    if (!options.output.empty())
        return writeTextFile(options.output, text);
    std::cout << text;
    if (!options.json && options.names.empty() && options.song.empty())
        std::cout << "xylophone: left out, as no song was given (--song FILE.mid)\n";
    return {};
}

} // namespace

void addBench(CLI::App& program, Action& chosen) {
    auto* command = program.add_subcommand(
        "bench", "Measures the engine in ratios of times taken side by side in this run");
    auto options = std::make_shared<Options>();
    command->add_option("NAME", options->names, describeBenchmarks())
        ->check(CLI::IsMember(benchmarkNames()));
    command->add_option("--song", options->song,
                        "The MIDI file that the benchmark xylophone plays");
    command->add_option("-o,--output", options->output, "A file to write to")
        ->type_name(writtenFile);
    command->add_flag("--json", options->json, "Goals and raw figures as JSON");
    command->final_callback([options, &chosen] { chosen = [options] { return bench(*options); }; });
}

} // namespace idiophone
