# CLI11 2.4.1: the console's command line. It is compiled once. As a header-only library it would be
# compiled again in every file that uses it.
if(TARGET idiophone_cli11)
    return()
endif()
idiophone_debian_binary(cli11 PACKAGE libcli11-dev VERSION 2.4.1+ds-2 SUITE trixie)
if(cli11)
    set(cli11_headers "${cli11}/usr/include")
else()
    FetchContent_Declare(cli11
        GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git
        GIT_TAG v2.4.1
        GIT_SHALLOW ON
        SOURCE_SUBDIR none) # populated, not added: its own build knows headers with or without their code, not both
    FetchContent_MakeAvailable(cli11)
    set(cli11_headers "${cli11_SOURCE_DIR}/include")
endif()
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/cli11.cpp" @ONLY CONTENT
"#include <CLI/impl/App_inl.hpp>
#include <CLI/impl/Argv_inl.hpp>
#include <CLI/impl/Config_inl.hpp>
#include <CLI/impl/Encoding_inl.hpp>
#include <CLI/impl/Formatter_inl.hpp>
#include <CLI/impl/Option_inl.hpp>
#include <CLI/impl/Split_inl.hpp>
#include <CLI/impl/StringTools_inl.hpp>
#include <CLI/impl/Validators_inl.hpp>
")
add_library(idiophone_cli11 STATIC "${PROJECT_BINARY_DIR}/cli11.cpp")
target_compile_definitions(idiophone_cli11 PUBLIC CLI11_COMPILE)
target_include_directories(idiophone_cli11 SYSTEM PUBLIC "${cli11_headers}")
