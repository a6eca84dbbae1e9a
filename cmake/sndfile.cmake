# libsndfile 1.2: WAV, FLAC and AIFF files. Elsewhere than on Debian its CMake package names the
# libraries of FLAC, too.
if(TARGET idiophone_sndfile)
    return()
endif()
find_package(SndFile CONFIG QUIET)
add_library(idiophone_sndfile INTERFACE)
if(SndFile_FOUND)
    target_link_libraries(idiophone_sndfile INTERFACE SndFile::sndfile)
else()
    find_path(SNDFILE_INCLUDE_DIR sndfile.h)
    find_library(SNDFILE_LIBRARY sndfile)
    if(NOT SNDFILE_INCLUDE_DIR OR NOT SNDFILE_LIBRARY)
        message(FATAL_ERROR "libsndfile is not found. Install libsndfile1-dev, or the package libsndfile of "
                            "Homebrew or vcpkg.")
    endif()
    target_include_directories(idiophone_sndfile SYSTEM INTERFACE "${SNDFILE_INCLUDE_DIR}")
    target_link_libraries(idiophone_sndfile INTERFACE "${SNDFILE_LIBRARY}")
endif()
