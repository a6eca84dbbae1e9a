#include "Benchmarks/Timer.h"

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
    std::array arguments{std::string("idiophone-bench"),
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

Replay replayOf(BenchScene& scene) {
    return {[&] { scene.restart(); },
            [&](std::size_t) { benchmark::DoNotOptimize(scene.nextCell()); }};
}

std::vector<CellTimes>
replayInTurn(std::span<const Replay> contestants, std::size_t cells, int times) {
    using Clock = std::chrono::steady_clock;
    std::vector<CellTimes> least(contestants.size());
    std::vector<Contestant> calls;
    for (std::size_t k = 0; k < contestants.size(); ++k) {
        least[k].seconds.resize(cells, std::numeric_limits<double>::infinity());
        calls.emplace_back([&replay = contestants[k], &seconds = least[k].seconds] {
            replay.restart();
            for (std::size_t cell = 0; cell < seconds.size(); ++cell) {
                const auto start = Clock::now();
                replay.render(cell);
                const std::chrono::duration<double> taken = Clock::now() - start;
                seconds[cell] = std::min(seconds[cell], taken.count());
            }
        });
    }
    runAll(calls, [&](benchmark::internal::Benchmark& registered) {
        registered.Iterations(1)->Repetitions(times);
    });
    return least;
}

double CellTimes::sum(std::size_t from, std::size_t until) const {
    const auto begin = seconds.begin();
    return std::accumulate(begin + static_cast<std::ptrdiff_t>(from),
                           begin + static_cast<std::ptrdiff_t>(until), 0.0);
}

} // namespace idiophone
