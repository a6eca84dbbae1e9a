# CLI11 2.1: the console's command line.
if(TARGET CLI11::CLI11)
    return()
endif()
FetchContent_Declare(CLI11
    GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git
    GIT_TAG v2.1.2
    GIT_SHALLOW ON
    FIND_PACKAGE_ARGS 2.1)
FetchContent_MakeAvailable(CLI11)
