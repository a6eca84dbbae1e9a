# Google Highway 1.0: SIMD with run-time dispatch.
if(TARGET hwy::hwy)
    return()
endif()
set(HWY_ENABLE_TESTS OFF)
set(HWY_ENABLE_EXAMPLES OFF)
set(HWY_ENABLE_INSTALL ON) # programs on Idiophone::Synth link to it, too
FetchContent_Declare(hwy
    GIT_REPOSITORY https://github.com/google/highway.git
    GIT_TAG 1.0.3
    GIT_SHALLOW ON
    FIND_PACKAGE_ARGS 1.0.3)
FetchContent_MakeAvailable(hwy)
if(NOT TARGET hwy::hwy)
    add_library(hwy::hwy ALIAS hwy)
endif()
