# Surge's tuning-library 1.1.0 (MIT): Scala .scl and .kbm.
if(TARGET idiophone_tuning_library)
    return()
endif()
add_library(idiophone_tuning_library INTERFACE)
idiophone_debian_binary(tuning_library
    PACKAGE libtuning-library-dev VERSION 1.1.0+ds-4 SUITE trixie)
if(tuning_library)
    target_include_directories(idiophone_tuning_library SYSTEM INTERFACE
        "${tuning_library}/usr/include")
else()
    FetchContent_Declare(tuning_library
        GIT_REPOSITORY https://github.com/surge-synthesizer/tuning-library.git
        GIT_TAG release_1.1.0
        GIT_SHALLOW ON
        SOURCE_SUBDIR none) # populated, not added: its own build makes its tests
    FetchContent_MakeAvailable(tuning_library)
    target_include_directories(idiophone_tuning_library SYSTEM INTERFACE
        "${tuning_library_SOURCE_DIR}/include")
endif()
