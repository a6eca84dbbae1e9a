# Google Benchmark 1.7: times the contestants of `idiophone-bench` in many short windows.
if(TARGET benchmark::benchmark)
    return()
endif()
set(BENCHMARK_ENABLE_TESTING OFF)
set(BENCHMARK_ENABLE_INSTALL OFF)
FetchContent_Declare(benchmark
    GIT_REPOSITORY https://github.com/google/benchmark.git
    GIT_TAG v1.7.1
    GIT_SHALLOW ON
    FIND_PACKAGE_ARGS 1.7)
FetchContent_MakeAvailable(benchmark)
