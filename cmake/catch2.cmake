# Catch2 3.7.1: the unit tests.
if(TARGET Catch2::Catch2WithMain)
    return()
endif()
idiophone_debian_source(Catch2 PACKAGE catch2 VERSION 3.7.1-0.5 SUITE trixie)
FetchContent_Declare(Catch2
    GIT_REPOSITORY https://github.com/catchorg/Catch2.git
    GIT_TAG v3.7.1
    GIT_SHALLOW ON
    SYSTEM)
FetchContent_MakeAvailable(Catch2)
set_target_properties(Catch2 PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0) # like its amalgamated file
set_property(DIRECTORY "${Catch2_SOURCE_DIR}" PROPERTY EXCLUDE_FROM_ALL TRUE) # is not installed
list(APPEND CMAKE_MODULE_PATH "${Catch2_SOURCE_DIR}/extras")
