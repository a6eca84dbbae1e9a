# tl::expected 1.x: results that are a value or an error (C++23's std::expected).
if(TARGET idiophone_expected)
    return()
endif()
find_path(EXPECTED_INCLUDE_DIR tl/expected.hpp)
add_library(idiophone_expected INTERFACE)
if(EXPECTED_INCLUDE_DIR)
    target_include_directories(idiophone_expected SYSTEM INTERFACE "${EXPECTED_INCLUDE_DIR}")
else()
    set(EXPECTED_BUILD_TESTS OFF)
    FetchContent_Declare(expected
        GIT_REPOSITORY https://github.com/TartanLlama/expected.git
        GIT_TAG v1.1.0
        GIT_SHALLOW ON
        SYSTEM)
    FetchContent_MakeAvailable(expected)
    target_link_libraries(idiophone_expected INTERFACE tl::expected)
endif()
