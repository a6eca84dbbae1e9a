#include "Console/SofaTable.h"

#include "Console/Command.h"
#include "Object/TextFile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <mysofa.h>
#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#endif

namespace idiophone {
namespace {

constexpr char isTable = 'T', isSentence = 'S'; // first byte of the output
constexpr double longestDelaySeconds = 0.01;    // ten times that of a head
constexpr double longestResponseSeconds = 0.04; // only the beginning is used

struct CloseSofa {
    void operator()(MYSOFA_EASY* file) const { mysofa_close(file); }
};

struct FreeSofa {
    void operator()(MYSOFA_HRTF* file) const { mysofa_free(file); }
};

std::string reasonOf(int error) {
    if (error == MYSOFA_NO_MEMORY)
        return "there is not enough memory to read it";
    return "it is damaged, or it is not a SOFA file of two ears in free field "
           "(SimpleFreeFieldHRIR)";
}

/// Writes each response after its delay in samples, which a file may store separately.
HeadMeasurement tabulate(MYSOFA_EASY& file, std::size_t filterLength, double rateHz) {
    const auto longestDelay = static_cast<std::size_t>(longestDelaySeconds * rateHz);
    const auto kept =
        std::min(filterLength, static_cast<std::size_t>(longestResponseSeconds * rateHz));
    HeadMeasurement table{
        .sampleRateHz = rateHz, .lengthSamples = kept + longestDelay, .responses = {}};
    table.responses.resize(HeadResponses::directionCount * 2 * table.lengthSamples);
    std::array<std::vector<float>, 2> ears{std::vector<float>(filterLength),
                                           std::vector<float>(filterLength)};
    auto place = table.responses.begin();
    for (std::size_t index = 0; index < HeadResponses::directionCount; ++index) {
        const Eigen::Vector3f to = HeadResponses::direction(index).cast<float>();
        std::array<float, 2> delays{};
        mysofa_getfilter_float(&file, to.x(), to.y(), to.z(), ears[0].data(), ears[1].data(),
                               &delays[0], &delays[1]);
        for (std::size_t ear = 0; ear < 2; ++ear) {
            const auto longest = static_cast<float>(longestDelay);
            // NaN becomes no delay.
            const auto delay = delays[ear] > 0 ? std::lround(std::min(delays[ear], longest)) : 0;
            std::ranges::copy_n(ears[ear].begin(), static_cast<std::ptrdiff_t>(kept),
                                place + delay);
            place += static_cast<std::ptrdiff_t>(table.lengthSamples);
        }
    }
    return table;
}

Result<std::shared_ptr<const HeadResponses>> readSofa(const std::string& file, int sampleRateHz) {
    int error = MYSOFA_INVALID_FORMAT, filterLength = 0;
    const std::unique_ptr<MYSOFA_HRTF, FreeSofa> asMeasured(mysofa_load(file.c_str(), &error));
    if (asMeasured == nullptr || asMeasured->DataSamplingRate.elements == 0)
        return failure(reasonOf(error));
    const std::unique_ptr<MYSOFA_EASY, CloseSofa> atRate(
        mysofa_open_no_norm(file.c_str(), static_cast<float>(sampleRateHz), &filterLength, &error));
    if (atRate == nullptr || filterLength <= 0)
        return failure(reasonOf(error));
    auto table = tabulate(*atRate, static_cast<std::size_t>(filterLength), sampleRateHz);
    table.measuredRateHz = static_cast<double>(asMeasured->DataSamplingRate.values[0]);
    return HeadResponses::make(table);
}

std::string encode(const Result<std::shared_ptr<const HeadResponses>>& read) {
    if (!read)
        return isSentence + read.error().message;
    const auto samples = (*read)->allSamples();
    return isTable +
           std::string(reinterpret_cast<const char*>(samples.data()), samples.size_bytes());
}

// Sanitizers need more memory than the limit. gcc reports them by macros, clang by features.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isSanitized = true;
#elif defined(__has_feature)
constexpr bool isSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool isSanitized = false;
#endif

/// Limits memory and time, because damaged files may ask for any amount. macOS has no limit of
/// memory.
void limitResources() {
#if defined(__unix__) || defined(__APPLE__)
    const auto limit = [](auto resource, rlim_t most) {
        const rlimit both{most, most};
        setrlimit(resource, &both);
    };
    limit(RLIMIT_CPU, sofaPatienceSeconds);
    limit(RLIMIT_CORE, 0);
#if defined(__linux__)
    if (!isSanitized)
        limit(RLIMIT_AS, rlim_t{1} << 31);
#endif
#endif
}

} // namespace

Result<std::shared_ptr<const HeadResponses>> decodeSofaTable(std::string_view bytes) {
    if (bytes.starts_with(isSentence))
        return failure(std::string(bytes.substr(1)));
    if (!bytes.starts_with(isTable))
        return failure("reading it gave no responses");
    std::vector<float> samples((bytes.size() - 1) / sizeof(float));
    std::memcpy(samples.data(), bytes.data() + 1, samples.size() * sizeof(float));
    return HeadResponses::of(std::move(samples));
}

void addSofaTable(CLI::App& program, Action& chosen) {
    struct Options {
        std::string file, table;
        int sampleRateHz = 0;
    };
    auto* command = program.add_subcommand("sofa-table", "Reads a SOFA file for another process");
    command->group(""); // hides the command from the list
    auto options = std::make_shared<Options>();
    command->add_option("FILE", options->file)->required();
    command->add_option("RATE", options->sampleRateHz)
        ->required()
        ->check(CLI::Range(1000, 1000000));
    command->add_option("TABLE", options->table)->required();
    command->final_callback([options, &chosen] {
        chosen = [options] {
            limitResources();
            return writeTextFile(options->table,
                                 encode(readSofa(options->file, options->sampleRateHz)));
        };
    });
}

} // namespace idiophone
