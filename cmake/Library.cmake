# Object and Synth as a CMake package: find_package(Idiophone) gives Idiophone::Synth. docs/library.md.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Idiophone")
set(headers "${CMAKE_INSTALL_INCLUDEDIR}/idiophone")
set_target_properties(idiophone_object PROPERTIES EXPORT_NAME Object)
set_target_properties(idiophone_synth PROPERTIES EXPORT_NAME Synth)
install(TARGETS idiophone_object idiophone_synth EXPORT IdiophoneTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
    INCLUDES DESTINATION "${headers}")
install(EXPORT IdiophoneTargets NAMESPACE Idiophone:: DESTINATION "${package}" COMPONENT development)

# What a program needs that loads objects, strikes them and presses on them, and what that includes.
foreach(header
        Object/DampingLaw Object/Material Object/ModalObject Object/ModalObjectFile
        Object/OrthotropicElasticity Object/RadiationTable Object/Result
        Synth/CellOutput Synth/ContactForce Synth/ForceCell Synth/ModalPole Synth/Reson
        Synth/SoundingGroups Synth/Strike Synth/Surface Synth/SurfaceProfile Synth/Synthesiser
        Synth/SynthesisSettings)
    get_filename_component(room "${header}" DIRECTORY)
    install(FILES "Source/${header}.h" DESTINATION "${headers}/${room}" COMPONENT development)
endforeach()
find_file(expected_header tl/expected.hpp HINTS "${expected_SOURCE_DIR}/include" REQUIRED)
install(FILES "${expected_header}" DESTINATION "${headers}/tl" COMPONENT development)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/IdiophoneConfig.cmake.in"
    IdiophoneConfig.cmake INSTALL_DESTINATION "${package}")
write_basic_package_version_file(IdiophoneConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
        "${CMAKE_CURRENT_BINARY_DIR}/IdiophoneConfig.cmake"
        "${CMAKE_CURRENT_BINARY_DIR}/IdiophoneConfigVersion.cmake"
    DESTINATION "${package}" COMPONENT development)
