# TetGen 1.5.0: closed surfaces to tetrahedra (AGPL, like Idiophone). It is built here because the
# assertions of Debian's package end the process. Ours throw (Source/Analysis/TetGenWatch.h).
if(TARGET idiophone_tetgen)
    return()
endif()
idiophone_debian_source(tetgen PACKAGE tetgen VERSION 1.5.0-5 SUITE bookworm)
# The repository has no tags. 1.5.1 is without assertions, so nothing could stop it.
FetchContent_Declare(tetgen
    GIT_REPOSITORY https://github.com/libigl/tetgen.git
    GIT_TAG 3c3b022727629c22f3685b0e45e11f7c9f9598e2
    SOURCE_SUBDIR none) # populated, not added: its own build does not use our assertions
FetchContent_MakeAvailable(tetgen)
add_library(idiophone_tetgen STATIC
    "${tetgen_SOURCE_DIR}/tetgen.cxx" "${tetgen_SOURCE_DIR}/predicates.cxx")
target_compile_definitions(idiophone_tetgen PRIVATE TETLIBRARY)
target_include_directories(idiophone_tetgen BEFORE
    PRIVATE "${CMAKE_CURRENT_LIST_DIR}/tetgen" "${PROJECT_SOURCE_DIR}/Source")
target_include_directories(idiophone_tetgen SYSTEM INTERFACE
    "$<BUILD_INTERFACE:${tetgen_SOURCE_DIR}>")
if(MSVC)
    target_compile_options(idiophone_tetgen PRIVATE /w /fp:strict)
else()
    # Its exact predicates depend on every rounding, so no multiplication may be fused with an addition.
    target_compile_options(idiophone_tetgen PRIVATE -w -ffp-contract=off)
endif()
# Shewchuk's sums read one number beyond the end of an expansion.
if(IDIOPHONE_SANITIZE MATCHES address)
    set_source_files_properties("${tetgen_SOURCE_DIR}/predicates.cxx" PROPERTIES
        COMPILE_OPTIONS -fno-sanitize=address)
endif()
set_target_properties(idiophone_tetgen PROPERTIES POSITION_INDEPENDENT_CODE ON)
