# libebur128 1.2.6: loudness, for samples, the console's figures and the tests.
if(TARGET idiophone_ebur128)
    return()
endif()
if(IDIOPHONE_PORTABLE)
    idiophone_debian_source(ebur128 PACKAGE libebur128 VERSION 1.2.6-1 SUITE bookworm ORIGINAL)
else()
    find_path(EBUR128_INCLUDE_DIR ebur128.h)
    find_library(EBUR128_LIBRARY ebur128)
endif()
add_library(idiophone_ebur128 INTERFACE)
if(EBUR128_INCLUDE_DIR AND EBUR128_LIBRARY)
    target_include_directories(idiophone_ebur128 SYSTEM INTERFACE "${EBUR128_INCLUDE_DIR}")
    target_link_libraries(idiophone_ebur128 INTERFACE "${EBUR128_LIBRARY}")
else()
    FetchContent_Declare(ebur128
        GIT_REPOSITORY https://github.com/jiixyj/libebur128.git
        GIT_TAG v1.2.6
        GIT_SHALLOW ON)
    set(CMAKE_POLICY_DEFAULT_CMP0048 NEW)
    FetchContent_MakeAvailable(ebur128)
    target_include_directories(idiophone_ebur128 SYSTEM INTERFACE "${ebur128_SOURCE_DIR}/ebur128")
    target_link_libraries(idiophone_ebur128 INTERFACE ebur128)
endif()
