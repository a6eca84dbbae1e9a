# idiophone_module(<Module> SOURCES ... [PUBLIC ...] [PRIVATE ...] [PRECOMPILE <header>...]): one static
# library a module.
function(idiophone_module module)
    cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE;PRECOMPILE" ${ARGN})
    string(TOLOWER ${module} lower)
    set(target idiophone_${lower})
    add_library(${target} STATIC ${arg_SOURCES})
    add_library(Idiophone::${module} ALIAS ${target})
    target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/Source>")
    target_link_libraries(${target}
        PUBLIC ${arg_PUBLIC}
        PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:idiophone_warnings>)
    idiophone_precompile(${target} ${arg_PRECOMPILE})
    set_target_properties(${target} PROPERTIES COMPILE_WARNING_AS_ERROR ${IDIOPHONE_WARNINGS_AS_ERRORS})
endfunction()
