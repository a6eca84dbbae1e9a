#include "Console/BenchTimer.h"

#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <chrono>
#include <limits>
#include <numeric>
#include <string>

namespace idiophone {
namespace {

class LeastOfRuns : public benchmark::BenchmarkReporter {
public:
    explicit LeastOfRuns(std::size_t contestants)
        : least(contestants, std::numeric_limits<double>::infinity()) {}

    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration)
                continue;
            double& here = least[std::stoul(run.run_name.function_name)];
            here = std::min(here, run.cpu_accumulated_time / static_cast<double>(run.iterations));
        }
    }

    std::vector<double> least;
};

std::vector<double> runAll(std::span<const Contestant> contestants,
                           const std::function<void(benchmark::internal::Benchmark&)>& prepare) {
    std::array arguments{std::string("idiophone"),
                         std::string("--benchmark_enable_random_interleaving=true")};
    std::array<char*, 2> pointers{arguments[0].data(), arguments[1].data()};
    int count = static_cast<int>(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    for (std::size_t k = 0; k < contestants.size(); ++k)
        prepare(*benchmark::RegisterBenchmark(std::to_string(k).c_str(),
                                              [&call = contestants[k]](benchmark::State& state) {
                                                  for ([[maybe_unused]] auto _ : state)
                                                      call();
                                              }));
    LeastOfRuns reporter(contestants.size());
    benchmark::RunSpecifiedBenchmarks(&reporter, ".");
    benchmark::ClearRegisteredBenchmarks();
    return reporter.least;
}

} // namespace

std::vector<double> leastSeconds(std::span<const Contestant> contestants,
                                 const TimingWindows& windows) {
    for (const Contestant& call : contestants)
        call();
    return runAll(contestants, [&](benchmark::internal::Benchmark& registered) {
        registered.MinTime(windows.seconds)->Repetitions(windows.count);
    });
}

void callInTurn(std::span<const Contestant> contestants, int times) {
    runAll(contestants, [&](benchmark::internal::Benchmark& registered) {
        registered.Iterations(1)->Repetitions(times);
    });
}

void LeastStepTimes::replay(std::size_t count, const std::function<void(std::size_t step)>& run) {
    using Clock = std::chrono::steady_clock;
    least.resize(count, std::numeric_limits<double>::infinity());
    for (std::size_t step = 0; step < count; ++step) {
        const auto start = Clock::now();
        run(step);
        const std::chrono::duration<double> taken = Clock::now() - start;
        least[step] = std::min(least[step], taken.count());
    }
}

double LeastStepTimes::sum(std::size_t from, std::size_t until) const {
    const auto begin = least.begin();
    return std::accumulate(begin + static_cast<std::ptrdiff_t>(from),
                           begin + static_cast<std::ptrdiff_t>(until), 0.0);
}

} // namespace idiophone
