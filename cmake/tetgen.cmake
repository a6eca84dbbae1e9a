# TetGen 1.5: closed surfaces to tetrahedra (AGPL, as we are).
if(TARGET idiophone_tetgen)
    return()
endif()
find_path(TETGEN_INCLUDE_DIR tetgen.h)
find_library(TETGEN_LIBRARY NAMES tet tetgen)
add_library(idiophone_tetgen INTERFACE)
if(TETGEN_INCLUDE_DIR AND TETGEN_LIBRARY)
    target_include_directories(idiophone_tetgen SYSTEM INTERFACE "${TETGEN_INCLUDE_DIR}")
    target_link_libraries(idiophone_tetgen INTERFACE "${TETGEN_LIBRARY}")
else()
    # 1.5.1, the last of the 1.5 line; the repository has no tags. 1.6 changed what
    # Analysis/TetGenMesher calls.
    FetchContent_Declare(tetgen
        GIT_REPOSITORY https://github.com/libigl/tetgen.git
        GIT_TAG a754f2485470f1ac51503e273d7e74a281c67807)
    FetchContent_MakeAvailable(tetgen)
    target_include_directories(idiophone_tetgen SYSTEM INTERFACE "${tetgen_SOURCE_DIR}")
    target_link_libraries(idiophone_tetgen INTERFACE tetgen)
endif()
