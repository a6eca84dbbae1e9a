# The toolchain of the preset `fuzz`: clang, which contains libFuzzer.
find_program(CLANG_C NAMES clang-20 clang-19 clang-18 clang-17 clang-16 clang)
find_program(CLANG_CXX NAMES clang++-20 clang++-19 clang++-18 clang++-17 clang++-16 clang++)
set(CMAKE_C_COMPILER "${CLANG_C}")
set(CMAKE_CXX_COMPILER "${CLANG_CXX}")
