# What every target of ours is compiled with; dependencies are left as they are.
add_library(idiophone_warnings INTERFACE)
if(MSVC)
    target_compile_options(idiophone_warnings INTERFACE /W4 /permissive- /utf-8
        /wd4068) # pragmas of other compilers
else()
    target_compile_options(idiophone_warnings INTERFACE
        -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
    # gcc 12 warns of overlaps inside its own std::string, and of reading and writing beyond it once its
    # headers are precompiled.
    set(is_gcc_12 $<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>)
    target_compile_options(idiophone_warnings INTERFACE
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
        $<${is_gcc_12}:-Wno-array-bounds>
        $<${is_gcc_12}:-Wno-stringop-overflow>
        $<${is_gcc_12}:-Wno-stringop-overread>)
endif()
