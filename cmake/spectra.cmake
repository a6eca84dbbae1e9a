# Spectra 1.0.1: the shift-invert Lanczos eigensolver.
if(TARGET Spectra::Spectra)
    return()
endif()
FetchContent_Declare(Spectra
    GIT_REPOSITORY https://github.com/yixuan/spectra.git
    GIT_TAG v1.0.1
    GIT_SHALLOW ON
    FIND_PACKAGE_ARGS 1.0 NAMES spectra)
FetchContent_MakeAvailable(Spectra)
if(NOT TARGET Spectra::Spectra)
    add_library(Spectra::Spectra ALIAS Spectra)
endif()
