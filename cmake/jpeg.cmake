# libjpeg-turbo 2.1.5 as a static library: Debian and Ubuntu disagree about the name of the shared one, and
# Debian's static one cannot be part of a plugin. Debian's JUCE then links it in place of the system's.
include(ExternalProject)

idiophone_debian_source(jpeg PACKAGE libjpeg-turbo VERSION 1:2.1.5-2 SUITE bookworm)
set(jpeg_library "${PROJECT_BINARY_DIR}/jpeg/libjpeg.a")
ExternalProject_Add(jpeg
    SOURCE_DIR "${FETCHCONTENT_SOURCE_DIR_JPEG}"
    BINARY_DIR "${PROJECT_BINARY_DIR}/jpeg"
    CMAKE_ARGS
        -DCMAKE_BUILD_TYPE=Release
        -DCMAKE_POSITION_INDEPENDENT_CODE=ON
        -DENABLE_SHARED=OFF
        -DWITH_SIMD=OFF
        -DWITH_TURBOJPEG=OFF
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target jpeg-static
    BUILD_BYPRODUCTS "${jpeg_library}"
    INSTALL_COMMAND ""
    LOG_CONFIGURE ON LOG_BUILD ON LOG_OUTPUT_ON_FAILURE ON)
# pkg_check_modules keeps this entry.
set(pkgcfg_lib_JUCE_IMG_LINUX_DEPS_jpeg "${jpeg_library}" CACHE FILEPATH "libjpeg" FORCE)
