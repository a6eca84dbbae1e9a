# The warnings of Idiophone's own targets. Dependencies keep their own.
add_library(idiophone_warnings INTERFACE)
if(MSVC)
    target_compile_options(idiophone_warnings INTERFACE /W4 /permissive- /utf-8
        /wd4068  # pragmas of other compilers
        /wd4127  # conditions that are constant for some arguments of a template
        /wd4324  # padding, which alignas asks for
        /wd4459  # names that the C library has too, such as signal; gcc and clang watch the others
        /wd4702) # unreachable code, also in the headers of libraries, which /external does not silence
    # It would warn of std::getenv and others of the standard library.
    target_compile_definitions(idiophone_warnings INTERFACE _CRT_SECURE_NO_WARNINGS)
else()
    target_compile_options(idiophone_warnings INTERFACE
        -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
    # gcc 12 to 14 warn of overlaps and of accesses beyond the end inside their own library.
    foreach(false_warning restrict array-bounds stringop-overflow stringop-overread)
        target_compile_options(idiophone_warnings INTERFACE
            $<$<CXX_COMPILER_ID:GNU>:-Wno-${false_warning}>)
    endforeach()
endif()
