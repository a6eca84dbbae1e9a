# JUCE 8.0.6: the plugin formats, the window, MIDI and audio files.
if(TARGET juce::juce_core)
    return()
endif()
idiophone_debian_source(juce PACKAGE juce VERSION 8.0.6+ds-2 SUITE trixie)
FetchContent_Declare(juce
    GIT_REPOSITORY https://github.com/juce-framework/JUCE.git
    GIT_TAG 8.0.6
    GIT_SHALLOW ON)
# JUCE builds its tool juceaide while CMake configures, which takes a minute. Only bundles of macOS
# and resources of Windows need it.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set(JUCE_MODULES_ONLY ON)
    if(IDIOPHONE_PORTABLE AND IDIOPHONE_DEBIAN_SOURCES)
        include(jpeg)
    endif()
endif()
FetchContent_MakeAvailable(juce)
if(JUCE_MODULES_ONLY)
    include("${juce_SOURCE_DIR}/extras/Build/CMake/JUCEUtils.cmake")
endif()
set_property(DIRECTORY "${juce_SOURCE_DIR}" PROPERTY EXCLUDE_FROM_ALL TRUE) # is not installed
