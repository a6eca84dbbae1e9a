# Finds a clang, which contains libFuzzer: the toolchain of the preset `fuzz`, and for Tests/Fuzz/smoke.cmake.
# The preset `clang` names its compilers itself.
find_program(CLANG_C NAMES clang-20 clang-19 clang-18 clang-17 clang-16 clang)
find_program(CLANG_CXX NAMES clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++)
set(CMAKE_C_COMPILER "${CLANG_C}")
set(CMAKE_CXX_COMPILER "${CLANG_CXX}")
