# tl::expected 1.x: results that are a value or an error (C++23's std::expected).
if(TARGET idiophone_expected)
    return()
endif()
find_path(EXPECTED_INCLUDE_DIR tl/expected.hpp)
if(NOT EXPECTED_INCLUDE_DIR)
    FetchContent_Declare(expected
        GIT_REPOSITORY https://github.com/TartanLlama/expected.git
        GIT_TAG v1.1.0
        GIT_SHALLOW ON
        SOURCE_SUBDIR none) # populated, not added: its own build makes packages
    FetchContent_MakeAvailable(expected)
    set(EXPECTED_INCLUDE_DIR "${expected_SOURCE_DIR}/include")
endif()
add_library(idiophone_expected INTERFACE)
target_include_directories(idiophone_expected SYSTEM INTERFACE "${EXPECTED_INCLUDE_DIR}")
