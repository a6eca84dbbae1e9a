# Google Highway 1.0: SIMD with run-time dispatch.
if(TARGET hwy::hwy)
    return()
endif()
if(IDIOPHONE_WEB OR MINGW)
    include(highway_headers)
    add_library(hwy::hwy INTERFACE IMPORTED)
    target_include_directories(hwy::hwy INTERFACE "${highway_SOURCE_DIR}")
    target_compile_definitions(hwy::hwy INTERFACE HWY_COMPILE_ONLY_STATIC)
    return()
endif()
if(IDIOPHONE_PORTABLE)
    idiophone_debian_source(hwy PACKAGE highway VERSION 1.0.3-3+deb12u1 SUITE bookworm)
else()
    set(system_highway FIND_PACKAGE_ARGS 1.0.3)
endif()
set(HWY_ENABLE_TESTS OFF)
set(HWY_ENABLE_EXAMPLES OFF)
set(HWY_ENABLE_CONTRIB OFF)
# Programs that link Idiophone::Synth link Highway too, so a fetched copy is installed.
set(HWY_ENABLE_INSTALL ON)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
FetchContent_Declare(hwy
    GIT_REPOSITORY https://github.com/google/highway.git
    GIT_TAG 1.0.4 # the first that installs a CMake package
    GIT_SHALLOW ON
    SYSTEM
    ${system_highway})
FetchContent_MakeAvailable(hwy)
unset(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME)
if(NOT TARGET hwy::hwy)
    add_library(hwy::hwy ALIAS hwy)
endif()
