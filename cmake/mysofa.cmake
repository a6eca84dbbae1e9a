# libmysofa 1.3: measured heads from SOFA files.
if(TARGET idiophone_mysofa)
    return()
endif()
find_path(MYSOFA_INCLUDE_DIR mysofa.h)
if(IDIOPHONE_PORTABLE)
    find_library(MYSOFA_LIBRARY libmysofa.a)
else()
    find_library(MYSOFA_LIBRARY mysofa)
endif()
add_library(idiophone_mysofa INTERFACE)
if(MYSOFA_INCLUDE_DIR AND MYSOFA_LIBRARY)
    target_include_directories(idiophone_mysofa SYSTEM INTERFACE "${MYSOFA_INCLUDE_DIR}")
    target_link_libraries(idiophone_mysofa INTERFACE "${MYSOFA_LIBRARY}" z)
else()
    set(BUILD_TESTS OFF)
    set(BUILD_SHARED_LIBS OFF)
    FetchContent_Declare(mysofa
        GIT_REPOSITORY https://github.com/hoene/libmysofa.git
        GIT_TAG v1.3.4
        GIT_SHALLOW ON)
    FetchContent_MakeAvailable(mysofa)
    # With MSVC its own build looks for zlib in a folder that it does not have.
    find_package(ZLIB REQUIRED)
    target_link_libraries(mysofa-static LINK_PRIVATE ZLIB::ZLIB)
    target_include_directories(idiophone_mysofa SYSTEM INTERFACE "${mysofa_BINARY_DIR}/src") # mysofa_export.h
    target_link_libraries(idiophone_mysofa INTERFACE mysofa-static)
endif()
