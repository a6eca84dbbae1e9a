# idiophone_module(<Module> SOURCES ... [PUBLIC ...] [PRIVATE ...] [PRECOMPILE <header>...]
#     [UNITY] [ALONE <file>...])
# One static library for a module. UNITY compiles its files in groups, see idiophone_unity_build.
function(idiophone_module module)
    cmake_parse_arguments(arg "UNITY" "" "SOURCES;PUBLIC;PRIVATE;PRECOMPILE;ALONE" ${ARGN})
    string(TOLOWER ${module} lower)
    set(target idiophone_${lower})
    add_library(${target} STATIC ${arg_SOURCES})
    add_library(Idiophone::${module} ALIAS ${target})
    target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/Source>")
    target_link_libraries(${target}
        PUBLIC ${arg_PUBLIC}
        PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:idiophone_warnings>)
    idiophone_precompile(${target} ${arg_PRECOMPILE})
    if(arg_UNITY)
        idiophone_unity_build(${target} ${arg_ALONE})
    endif()
    set_target_properties(${target} PROPERTIES COMPILE_WARNING_AS_ERROR ${IDIOPHONE_WARNINGS_AS_ERRORS})
endfunction()

# idiophone_unity_build(<target> [<file>...]): compiles up to eight files of the target as one, so
# that headers and templates are compiled once for all of them. The given files are compiled alone,
# because they use private names of other files.
function(idiophone_unity_build target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
