# idiophone_debian_source(<FetchContent name> PACKAGE p VERSION v SUITE s [FOLDER f])
# On Debian, unpacks a pinned source package once into build/dependencies and points FetchContent
# at it; elsewhere does nothing, so that FetchContent fetches the upstream tag.
include(FetchContent)

set(IDIOPHONE_DEPENDENCIES "${CMAKE_SOURCE_DIR}/build/dependencies" CACHE PATH
    "Where unpacked source packages are kept, shared by all presets")

set(is_debian OFF)
if(EXISTS /etc/debian_version AND EXISTS /usr/share/keyrings/debian-archive-keyring.gpg)
    set(is_debian ON)
endif()
option(IDIOPHONE_DEBIAN_SOURCES "Take JUCE, libigl and Catch2 from Debian's source packages" ${is_debian})

function(idiophone_debian_source name)
    cmake_parse_arguments(arg "" "PACKAGE;VERSION;SUITE;FOLDER" "" ${ARGN})
    string(TOUPPER ${name} upper)
    if(NOT IDIOPHONE_DEBIAN_SOURCES OR FETCHCONTENT_SOURCE_DIR_${upper})
        return()
    endif()
    string(REGEX REPLACE "-[^-]*$" "" upstream_version "${arg_VERSION}")
    set(folder "${IDIOPHONE_DEPENDENCIES}/${arg_PACKAGE}-${upstream_version}")
    if(NOT EXISTS "${folder}")
        message(STATUS "Fetching Debian source package ${arg_PACKAGE} ${arg_VERSION}")
        file(MAKE_DIRECTORY "${IDIOPHONE_DEPENDENCIES}")
        execute_process(
            COMMAND "${CMAKE_SOURCE_DIR}/cmake/debian-source.sh" ${arg_PACKAGE} ${arg_VERSION}
                    ${arg_SUITE} "${IDIOPHONE_DEPENDENCIES}" ${arg_FOLDER}
            RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
        if(failed)
            message(FATAL_ERROR "Debian source package ${arg_PACKAGE} ${arg_VERSION} could not be "
                                "fetched; -DIDIOPHONE_DEBIAN_SOURCES=OFF takes the upstream "
                                "repository instead.\n${log}")
        endif()
    endif()
    set(FETCHCONTENT_SOURCE_DIR_${upper} "${folder}" CACHE PATH "Unpacked source of ${name}" FORCE)
endfunction()
