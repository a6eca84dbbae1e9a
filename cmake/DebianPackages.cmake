# The packages for Debian: idiophone (the programs), idiophone-dev (the library) and, with IDIOPHONE_PYTHON,
# python3-idiophone.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${CPACK_PACKAGE_CONTACT}")
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "${PROJECT_HOMEPAGE_URL}")
set(CPACK_DEBIAN_PACKAGE_SECTION sound)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Empty unless the compiler is for another processor; CPack then takes this machine's.
string(REPLACE ":" "" CPACK_DEBIAN_PACKAGE_ARCHITECTURE "${IDIOPHONE_DEBIAN_ARCHITECTURE}")

string(TIMESTAMP source_time "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT changelog CONTENT
"idiophone (@PROJECT_VERSION@) stable; urgency=medium

  * CHANGELOG.md lists the changes.

 -- @CPACK_PACKAGE_CONTACT@  @source_time@
" @ONLY)
execute_process(COMMAND gzip --best --no-name --force "${CMAKE_CURRENT_BINARY_DIR}/changelog"
    COMMAND_ERROR_IS_FATAL ANY)

# debian_package(<package> <group> <component>...): a package of components. The first one gets the files that
# Debian wants of each package.
function(debian_package package group component)
    foreach(each ${component} ${ARGN})
        string(TOUPPER ${each} upper)
        set(CPACK_COMPONENT_${upper}_GROUP ${group} PARENT_SCOPE)
    endforeach()
    string(TOUPPER ${group} upper)
    set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
    set(documents "${CMAKE_INSTALL_DATADIR}/doc/${package}")
    install(FILES LICENSE DESTINATION "${documents}" RENAME copyright COMPONENT ${component})
    install(FILES LICENSE-APACHE THIRD-PARTY "${CMAKE_CURRENT_BINARY_DIR}/changelog.gz"
        DESTINATION "${documents}" COMPONENT ${component})
endfunction()

debian_package(idiophone program console plugin standalone)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS libasound2-plugins)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"Idiophone computes from physics how struck objects vibrate, and plays them
in real time. This package has the plugins (VST3, LV2), the standalone and
the console program.")

debian_package(idiophone-dev development development)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"Games and research programs make modal objects from meshes with the
library, and play them. This package has the interface for C and that for
C++, which is a CMake package.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS libeigen3-dev) # for the component Analysis
if(NOT hwy_SOURCE_DIR) # else Highway is in the package itself
    set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libhwy-dev)
endif()
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_BINARY_DIR}/triggers")

if(IDIOPHONE_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
    debian_package(python3-idiophone python python)
    find_package(Python 3.9 REQUIRED COMPONENTS Interpreter)
    math(EXPR next "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
        "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_DESCRIPTION
"With this package, Python programs analyse meshes, fit recordings and play
modal objects, with NumPy arrays.")
endif()
