#include "Benchmarks/Benchmarks.h"

#include <array>

namespace idiophone {

Result<std::vector<std::shared_ptr<const ModalObject>>>
objectsNamed(const BenchContent& content, const std::string& beginning, std::size_t count) {
    std::vector<std::shared_ptr<const ModalObject>> found;
    for (const auto& object : content.factoryObjects)
        if (object->name.starts_with(beginning))
            found.push_back(object);
    if (found.size() < count)
        return failure("The benchmark needs " + std::to_string(count) +
                       " factory objects whose names start with '" + beginning + "'.");
    return found;
}

std::span<const NamedBenchmark> namedBenchmarks() {
    static constexpr std::array all{
        NamedBenchmark{"kernel", "Modal banks against the FMA peak and the paper's loop",
                       benchKernel},
        NamedBenchmark{"callback", "The worst 64-sample callback against the mean", benchCallback},
        NamedBenchmark{"crowd", "Steps of a callback with few and with many to do", benchCrowd},
        NamedBenchmark{"plugin", "The plugin's whole callback with every factory preset",
                       benchPlugin},
        NamedBenchmark{"force", "Continuous force against the free bank", benchForce},
        NamedBenchmark{"memory", "The gain matrix before and after compression", benchMemory},
        NamedBenchmark{"tau", "Modes over time at two truncation thresholds", benchTau},
        NamedBenchmark{"rings", "A hundred rings on a table: audio frames per second", benchRings},
        NamedBenchmark{"scale", "10, 100 and 1000 bodies under one budget", benchScale},
        NamedBenchmark{"scenes", "Motion of the factory scenes against real time", benchScenes},
        NamedBenchmark{"render", "A rendered scene on two cores against one", benchRender},
        NamedBenchmark{"analysis", "A ball, a cube and a scan on two cores against one",
                       benchAnalysis},
        NamedBenchmark{"xylophone", "A song as a share of one core", benchXylophone},
        NamedBenchmark{"compression", "Modes and level error of the factory objects",
                       benchCompression}};
    return all;
}

} // namespace idiophone
