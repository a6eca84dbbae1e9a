# Steinberg's validator (VST 3 SDK 3.7.10): the reference check of our VST3, built for tests only.
# Defines the target steinberg_validator, part of "all", and STEINBERG_VALIDATOR, its path.
if(TARGET steinberg_validator)
    return()
endif()
include(ExternalProject)

if(IDIOPHONE_DEBIAN_SOURCES)
    # The mirror serves this package's archives without its description, so they are unpacked here.
    # apt has checked them against the signed index.
    set(version 3.7.10.14+~4.13.3)
    set(folder "${IDIOPHONE_DEPENDENCIES}/vst3sdk-${version}")
    file(MAKE_DIRECTORY "${IDIOPHONE_DEPENDENCIES}")
    file(LOCK "${IDIOPHONE_DEPENDENCIES}/lock" GUARD FILE) # two presets may be configured at once
    if(NOT EXISTS "${folder}")
        message(STATUS "Fetching Debian source package vst3sdk ${version}-4")
        execute_process(
            COMMAND "${PROJECT_SOURCE_DIR}/cmake/debian-source.sh" vst3sdk ${version}-4 trixie
                    "${IDIOPHONE_DEPENDENCIES}" --archives
            OUTPUT_VARIABLE log ERROR_VARIABLE log)
        file(REMOVE_RECURSE "${folder}.partial")
        foreach(part "" -base -cmake -pluginterfaces -public-sdk)
            set(archive "${IDIOPHONE_DEPENDENCIES}/vst3sdk_${version}.orig${part}.tar.gz")
            string(REGEX REPLACE "^-" "" subfolder "${part}")
            string(REPLACE public-sdk public.sdk subfolder "${subfolder}")
            file(MAKE_DIRECTORY "${folder}.partial/${subfolder}")
            execute_process(
                COMMAND tar --extract --file "${archive}" --strip-components 1
                        --directory "${folder}.partial/${subfolder}"
                RESULT_VARIABLE failed ERROR_VARIABLE tar_log)
            if(failed)
                message(FATAL_ERROR
                    "Debian source package vst3sdk ${version}-4 could not be fetched (${archive}); "
                    "-DIDIOPHONE_DEBIAN_SOURCES=OFF takes the upstream repository instead.\n"
                    "${log}${tar_log}")
            endif()
        endforeach()
        file(RENAME "${folder}.partial" "${folder}")
        file(GLOB archives "${IDIOPHONE_DEPENDENCIES}/vst3sdk_${version}*")
        file(REMOVE ${archives})
    endif()
    set(vst3sdk_source SOURCE_DIR "${folder}")
else()
    set(vst3sdk_source
        GIT_REPOSITORY https://github.com/steinbergmedia/vst3sdk.git
        GIT_TAG v3.7.10_build_14
        GIT_SHALLOW ON
        GIT_SUBMODULES base cmake pluginterfaces public.sdk)
endif()

set(vst3sdk_build "${PROJECT_BINARY_DIR}/steinberg_validator")
if(WIN32)
    set(STEINBERG_VALIDATOR "${vst3sdk_build}/bin/validator.exe")
else()
    set(STEINBERG_VALIDATOR "${vst3sdk_build}/bin/Release/validator")
endif()
ExternalProject_Add(steinberg_validator
    ${vst3sdk_source}
    UPDATE_COMMAND ""
    BINARY_DIR "${vst3sdk_build}"
    CMAKE_ARGS
        -DCMAKE_BUILD_TYPE=Release
        -DSMTG_ENABLE_VST3_PLUGIN_EXAMPLES=OFF
        -DSMTG_ENABLE_VST3_HOSTING_EXAMPLES=OFF
        -DSMTG_ENABLE_VSTGUI_SUPPORT=OFF
        -DSMTG_CREATE_PLUGIN_LINK=0
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --config Release --target validator
    BUILD_BYPRODUCTS "${STEINBERG_VALIDATOR}"
    INSTALL_COMMAND ""
    LOG_CONFIGURE ON LOG_BUILD ON LOG_OUTPUT_ON_FAILURE ON)
