# Steinberg's validator (VST 3 SDK 3.7.10): the reference check of our VST3, built for tests only.
# Defines the target steinberg_validator, part of "all", and STEINBERG_VALIDATOR, the program's path.
if(TARGET steinberg_validator)
    return()
endif()
include(ExternalProject)

set(vst3sdk_hosting public.sdk/samples/vst-hosting)
set(vst3sdk_source)
if(IDIOPHONE_DEBIAN_SOURCES)
    # The mirror serves this package's archives without its description, so that each is unpacked
    # here; apt has checked them against the signed index.
    set(version 3.7.10.14+~4.13.3)
    set(folder "${IDIOPHONE_DEPENDENCIES}/vst3sdk-${version}")
    if(NOT EXISTS "${folder}")
        message(STATUS "Fetching Debian source package vst3sdk ${version}-4")
        file(MAKE_DIRECTORY "${IDIOPHONE_DEPENDENCIES}")
        execute_process(
            COMMAND "${CMAKE_SOURCE_DIR}/cmake/debian-source.sh" vst3sdk ${version}-4 trixie
                    "${IDIOPHONE_DEPENDENCIES}" --archives
            OUTPUT_VARIABLE log ERROR_VARIABLE log)
        file(REMOVE_RECURSE "${folder}.partial")
        foreach(part . base cmake pluginterfaces public.sdk)
            string(REPLACE . - suffix ".${part}")
            string(REGEX REPLACE "-+$" "" suffix "${suffix}")
            set(archive "${IDIOPHONE_DEPENDENCIES}/vst3sdk_${version}.orig${suffix}.tar.gz")
            file(MAKE_DIRECTORY "${folder}.partial/${part}")
            execute_process(
                COMMAND tar --extract --file "${archive}" --strip-components 1
                        --directory "${folder}.partial/${part}"
                RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE tar_log)
            if(failed)
                message(FATAL_ERROR "Debian source package vst3sdk ${version}-4 could not be fetched "
                                    "(${archive}); -DIDIOPHONE_DEBIAN_SOURCES=OFF takes the upstream "
                                    "repository instead.\n${log}${tar_log}")
            endif()
        endforeach()
        file(RENAME "${folder}.partial" "${folder}")
        file(GLOB archives "${IDIOPHONE_DEPENDENCIES}/vst3sdk_${version}*")
        file(REMOVE ${archives})
    endif()
    set(vst3sdk_source DOWNLOAD_COMMAND "" SOURCE_DIR "${folder}")
else()
    set(vst3sdk_source
        GIT_REPOSITORY https://github.com/steinbergmedia/vst3sdk.git
        GIT_TAG v3.7.10_build_14
        GIT_SHALLOW ON
        GIT_SUBMODULES base cmake pluginterfaces public.sdk)
endif()

set(vst3sdk_build "${CMAKE_BINARY_DIR}/steinberg_validator")
set(STEINBERG_VALIDATOR "${vst3sdk_build}/bin/Release/validator${CMAKE_EXECUTABLE_SUFFIX}")
