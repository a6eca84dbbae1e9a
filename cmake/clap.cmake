# clap-juce-extensions of June 2026 with its submodules CLAP 1.2.7 and clap-helpers (all MIT): the
# CLAP format of plugins made with JUCE.
if(TARGET clap_juce_extensions)
    return()
endif()
set(CLAP_JUCE_EXTENSIONS_BUILD_EXAMPLES OFF)
FetchContent_Declare(clap_juce_extensions
    GIT_REPOSITORY https://github.com/free-audio/clap-juce-extensions.git
    GIT_TAG 51a9359315298de632cf44e9d7524940868441e6
    SYSTEM)
FetchContent_MakeAvailable(clap_juce_extensions)
