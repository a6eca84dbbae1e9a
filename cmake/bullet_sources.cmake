# Bullet from its sources, where no library of it in double precision exists, and for programs that run on
# other distributions. One file for each of its libraries includes all of that library's files.
idiophone_debian_source(bullet PACKAGE bullet VERSION 3.24+dfsg-2 SUITE bookworm FOLDER src)
FetchContent_Declare(bullet
    GIT_REPOSITORY https://github.com/bulletphysics/bullet3.git
    GIT_TAG 3.24
    GIT_SHALLOW ON
    SOURCE_SUBDIR none) # populated, not added: its own build also makes what is left out here
FetchContent_MakeAvailable(bullet)
set(bullet_files "")
foreach(library LinearMath BulletCollision BulletDynamics)
    file(STRINGS "${bullet_SOURCE_DIR}/src/bt${library}All.cpp" includes REGEX "^#include")
    # Threads, robots and vehicles take a third of the time, and scenes need none of them.
    list(FILTER includes EXCLUDE REGEX
        "Mt[.]cpp|Batched|Featherstone|MLCP|NNCG|Vehicle|Character|Gimpact|SoftBody")
    list(JOIN includes "\n" includes)
    set(file "${CMAKE_CURRENT_BINARY_DIR}/${library}.cpp")
    file(CONFIGURE OUTPUT "${file}" CONTENT "${includes}\n" @ONLY)
    list(APPEND bullet_files "${file}")
endforeach()
add_library(idiophone_bullet STATIC ${bullet_files})
target_include_directories(idiophone_bullet SYSTEM PUBLIC "${bullet_SOURCE_DIR}/src")
target_compile_definitions(idiophone_bullet PUBLIC BT_USE_DOUBLE_PRECISION)
target_compile_options(idiophone_bullet PRIVATE -w)
