# tinygltf 2.7: glTF files. A single header, compiled in Source/Gltf/TinyGltf.cpp.
if(TARGET idiophone_tinygltf)
    return()
endif()
find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h)
if(NOT TINYGLTF_INCLUDE_DIR)
    set(TINYGLTF_BUILD_LOADER_EXAMPLE OFF)
    set(TINYGLTF_HEADER_ONLY ON)
    set(TINYGLTF_INSTALL OFF)
    FetchContent_Declare(tinygltf
        GIT_REPOSITORY https://github.com/syoyo/tinygltf.git
        GIT_TAG v2.7.0
        GIT_SHALLOW ON)
    FetchContent_MakeAvailable(tinygltf)
    set(TINYGLTF_INCLUDE_DIR "${tinygltf_SOURCE_DIR}")
endif()
add_library(idiophone_tinygltf INTERFACE)
target_include_directories(idiophone_tinygltf SYSTEM INTERFACE "${TINYGLTF_INCLUDE_DIR}")
