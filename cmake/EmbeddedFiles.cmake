# idiophone_embed_files(<variable> <function> <file>...): sets the variable to the source file that
# defines `std::span<const EmbeddedFile> idiophone::<function>()`, which returns the files.
if(IDIOPHONE_WEB)
    # The build cannot run a program that it compiles. CMake writes the source, which takes longer.
    function(idiophone_embed_files variable function)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
        set(table "")
        foreach(file ${ARGN})
            cmake_path(GET file FILENAME name)
            file(READ "${file}" bytes HEX)
            string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
            string(APPEND table "        {R\"name(${name})name\", \"${bytes}\"sv},\n")
        endforeach()
        set(source "${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp")
        file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT
"#include \"Object/EmbeddedFiles.h\"

using namespace std::literals;

namespace idiophone {

std::span<const EmbeddedFile> @function@() {
    static const EmbeddedFile files[] = {
@table@    };
    return files;
}

} // namespace idiophone
")
        set_source_files_properties("${source}" PROPERTIES
            SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS -Wno-overlength-strings)
        set(${variable} "${source}" PARENT_SCOPE)
    endfunction()
    return()
endif()
add_executable(idiophone_embed_files "${CMAKE_CURRENT_LIST_DIR}/embed_files.cpp")

function(idiophone_embed_files variable function)
    set(source "${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp")
    list(JOIN ARGN "\n" lines)
    file(CONFIGURE OUTPUT "${source}.list" CONTENT "${lines}\n" @ONLY)
    add_custom_command(OUTPUT "${source}"
        COMMAND idiophone_embed_files ${function} "${source}.list" "${source}"
        DEPENDS idiophone_embed_files "${source}.list" ${ARGN}
        VERBATIM)
    # One literal gains nothing from them.
    set_source_files_properties("${source}" PROPERTIES
        SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
    if(NOT MSVC)
        set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
    endif()
    set(${variable} "${source}" PARENT_SCOPE)
endfunction()
