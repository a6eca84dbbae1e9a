# idiophone_debian_source(<FetchContent name> PACKAGE p VERSION v SUITE s [FOLDER f | ORIGINAL])
# On Debian 12 and 13 this unpacks a pinned source package once into build/dependencies and points
# FetchContent at it. Elsewhere FetchContent fetches the upstream tag. ORIGINAL leaves out Debian's changes,
# which the mirror does not serve for every package.
#
# idiophone_debian_binary(<variable> PACKAGE p VERSION v SUITE s)
# For packages whose source is not served. On Debian 12 and 13 this unpacks the binary package and sets the
# variable to its folder. Elsewhere it sets the variable to nothing.
include(FetchContent)

set(IDIOPHONE_DEPENDENCIES "${PROJECT_SOURCE_DIR}/build/dependencies" CACHE PATH
    "Where unpacked source packages are kept, shared by all presets")

set(is_debian OFF)
if(EXISTS /usr/share/keyrings/debian-archive-keyring.gpg)
    cmake_host_system_information(RESULT codename QUERY DISTRIB_VERSION_CODENAME)
    if(codename MATCHES "^(bookworm|trixie)$")
        set(is_debian ON)
    endif()
endif()
option(IDIOPHONE_DEBIAN_SOURCES "Take pinned dependencies from Debian's packages, not from upstream repositories" ${is_debian})

# Unpacks a package into the folder unless the folder exists. Further arguments go to debian-source.sh.
function(idiophone_unpack_debian folder package version suite)
    file(MAKE_DIRECTORY "${IDIOPHONE_DEPENDENCIES}")
    file(LOCK "${IDIOPHONE_DEPENDENCIES}/lock" GUARD FUNCTION) # two presets may be configured at once
    if(EXISTS "${folder}")
        return()
    endif()
    message(STATUS "Fetching Debian package ${package} ${version}")
    execute_process(
        COMMAND "${PROJECT_SOURCE_DIR}/cmake/debian-source.sh" ${package} ${version} ${suite}
                "${IDIOPHONE_DEPENDENCIES}" ${ARGN}
        RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
    if(failed)
        message(FATAL_ERROR "Debian package ${package} ${version} could not be fetched; "
                            "-DIDIOPHONE_DEBIAN_SOURCES=OFF takes the upstream repository "
                            "instead.\n${log}")
    endif()
endfunction()

function(idiophone_debian_source name)
    cmake_parse_arguments(arg "ORIGINAL" "PACKAGE;VERSION;SUITE;FOLDER" "" ${ARGN})
    string(TOUPPER ${name} upper)
    if(NOT IDIOPHONE_DEBIAN_SOURCES OR FETCHCONTENT_SOURCE_DIR_${upper})
        return()
    endif()
    string(REGEX REPLACE "^[0-9]+:|-[^-]*$" "" upstream_version "${arg_VERSION}")
    if(arg_ORIGINAL)
        set(arg_FOLDER --original)
    endif()
    set(folder "${IDIOPHONE_DEPENDENCIES}/${arg_PACKAGE}-${upstream_version}")
    idiophone_unpack_debian("${folder}" ${arg_PACKAGE} ${arg_VERSION} ${arg_SUITE} ${arg_FOLDER})
    set(FETCHCONTENT_SOURCE_DIR_${upper} "${folder}" CACHE PATH "Unpacked source of ${name}" FORCE)
endfunction()

function(idiophone_debian_binary variable)
    cmake_parse_arguments(arg "" "PACKAGE;VERSION;SUITE" "" ${ARGN})
    set(${variable} "" PARENT_SCOPE)
    string(TOUPPER ${variable} upper)
    if(IDIOPHONE_DEBIAN_SOURCES AND NOT FETCHCONTENT_SOURCE_DIR_${upper})
        set(folder "${IDIOPHONE_DEPENDENCIES}/${arg_PACKAGE}-${arg_VERSION}")
        idiophone_unpack_debian("${folder}" ${arg_PACKAGE} ${arg_VERSION} ${arg_SUITE} --binary)
        set(${variable} "${folder}" PARENT_SCOPE)
    endif()
endfunction()
