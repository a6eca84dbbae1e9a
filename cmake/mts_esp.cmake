# The client of MTS-ESP (0BSD): one plugin sets the tuning of a session.
if(TARGET idiophone_mts_esp)
    return()
endif()
idiophone_debian_binary(mts_esp
    PACKAGE libmts-esp-dev${IDIOPHONE_DEBIAN_ARCHITECTURE} VERSION 0.0~git20230110.9df9a9c-1 SUITE trixie)
if(mts_esp)
    # Parts are not position-independent, so a shared library that links it must not export its
    # symbols (--exclude-libs).
    add_library(idiophone_mts_esp INTERFACE)
    target_link_libraries(idiophone_mts_esp INTERFACE
        "${mts_esp}/usr/lib/libMTS.a" ${CMAKE_DL_LIBS})
    target_include_directories(idiophone_mts_esp SYSTEM INTERFACE "${mts_esp}/usr/include")
else()
    FetchContent_Declare(mts_esp
        GIT_REPOSITORY https://github.com/ODDSound/MTS-ESP.git
        GIT_TAG 9df9a9c4a1556f7206536913418f081abfba910b) # it has no build of its own
    FetchContent_MakeAvailable(mts_esp)
    add_library(idiophone_mts_esp STATIC "${mts_esp_SOURCE_DIR}/Client/libMTSClient.cpp")
    target_include_directories(idiophone_mts_esp SYSTEM INTERFACE "${mts_esp_SOURCE_DIR}/Client")
    target_link_libraries(idiophone_mts_esp PRIVATE ${CMAKE_DL_LIBS})
endif()
