# libigl 2.0, header only: mesh files, adjacency, nearest points, rays.
if(TARGET idiophone_libigl)
    return()
endif()
idiophone_debian_source(libigl PACKAGE slic3r-prusa VERSION 2.5.0+dfsg-4 SUITE bookworm
    FOLDER src/libigl)
FetchContent_Declare(libigl
    GIT_REPOSITORY https://github.com/libigl/libigl.git
    GIT_TAG v2.0.0
    GIT_SHALLOW ON
    SOURCE_SUBDIR none) # populated, not added: its own build fetches more than the headers need
FetchContent_MakeAvailable(libigl)
find_path(LIBIGL_INCLUDE_DIR igl/read_triangle_mesh.h
    PATHS "${libigl_SOURCE_DIR}/include" "${libigl_SOURCE_DIR}/src/libigl"
    NO_DEFAULT_PATH REQUIRED)
add_library(idiophone_libigl INTERFACE)
target_include_directories(idiophone_libigl SYSTEM INTERFACE "${LIBIGL_INCLUDE_DIR}")
target_link_libraries(idiophone_libigl INTERFACE Eigen3::Eigen)
