# JUCE 8.0.6: the plugin formats, the window, MIDI and audio files.
if(TARGET juce::juce_core)
    return()
endif()
idiophone_debian_source(juce PACKAGE juce VERSION 8.0.6+ds-2 SUITE trixie)
FetchContent_Declare(juce
    GIT_REPOSITORY https://github.com/juce-framework/JUCE.git
    GIT_TAG 8.0.6
    GIT_SHALLOW ON)
set(IDIOPHONE_JUCEAIDE "" CACHE FILEPATH "JUCE's tool, if another build has made it; this one makes it otherwise")
if(EXISTS "${IDIOPHONE_JUCEAIDE}")
    set(JUCE_MODULES_ONLY ON)
endif()
FetchContent_MakeAvailable(juce)
if(EXISTS "${IDIOPHONE_JUCEAIDE}")
    add_executable(juce::juceaide IMPORTED GLOBAL)
    set_target_properties(juce::juceaide PROPERTIES IMPORTED_LOCATION "${IDIOPHONE_JUCEAIDE}")
    include("${juce_SOURCE_DIR}/extras/Build/CMake/JUCEUtils.cmake")
endif()
set_property(DIRECTORY "${juce_SOURCE_DIR}" PROPERTY EXCLUDE_FROM_ALL TRUE) # is not installed
