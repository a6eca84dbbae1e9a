# Google Benchmark 1.7: times the contestants of `idiophone-bench` in many short windows.
if(TARGET benchmark::benchmark)
    return()
endif()
set(BENCHMARK_ENABLE_TESTING OFF)
set(BENCHMARK_ENABLE_INSTALL OFF)
set(BENCHMARK_ENABLE_WERROR OFF)
# The preset `clang` disables the system's library, whose interface has strings of libstdc++.
if(CMAKE_DISABLE_FIND_PACKAGE_benchmark)
    idiophone_debian_source(benchmark PACKAGE benchmark VERSION 1.7.1-1 SUITE bookworm)
    set(GIT_VERSION 1.7.1) # Debian's source does not ask git
endif()
FetchContent_Declare(benchmark
    GIT_REPOSITORY https://github.com/google/benchmark.git
    GIT_TAG v1.7.1
    GIT_SHALLOW ON
    FIND_PACKAGE_ARGS 1.7)
FetchContent_MakeAvailable(benchmark)
