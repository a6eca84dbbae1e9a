# idiophone_embed_files(<variable> <function> <file>...): sets the variable to the source file that
# defines `std::span<const EmbeddedFile> idiophone::<function>()`, which returns the files.
if(IDIOPHONE_WEB)
    # The compiler makes no programs for this machine, so CMake writes the source. For text files only.
    function(idiophone_embed_files variable function)
        list(SORT ARGN COMPARE STRING)
        set(entries "")
        foreach(file ${ARGN})
            file(READ "${file}" text)
            cmake_path(GET file FILENAME name)
            string(APPEND entries "        {\"${name}\", R\"text(${text})text\"},\n")
        endforeach()
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
        set(source "${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp")
        file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT
"#include \"Object/EmbeddedFiles.h\"

#include <array>

namespace idiophone {

std::span<const EmbeddedFile> @function@();

std::span<const EmbeddedFile> @function@() {
    static constexpr auto files = std::to_array<EmbeddedFile>({
@entries@    });
    return files;
}

} // namespace idiophone
")
        set_source_files_properties("${source}" PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
        set(${variable} "${source}" PARENT_SCOPE)
    endfunction()
    return()
endif()

add_executable(idiophone_embed_files "${CMAKE_CURRENT_LIST_DIR}/embed_files.cpp")
if(MSVC)
    target_sources(idiophone_embed_files PRIVATE "${PROJECT_SOURCE_DIR}/Source/Console/utf8.manifest")
endif()

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
