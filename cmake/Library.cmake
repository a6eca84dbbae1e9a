# Installs the modules that other programs use as a CMake package (docs/library.md), and the C interface
# (docs/c-interface.md) for pkg-config too.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/Idiophone")
set(headers "${CMAKE_INSTALL_INCLUDEDIR}/idiophone")

# install_modules(<export> TARGETS ... HEADERS ...): installs static libraries and the headers that a
# program includes, directly or indirectly.
function(install_modules export)
    cmake_parse_arguments(arg "" "" "TARGETS;HEADERS" ${ARGN})
    install(TARGETS ${arg_TARGETS} EXPORT ${export}
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
        INCLUDES DESTINATION "${headers}")
    install(EXPORT ${export} NAMESPACE Idiophone:: DESTINATION "${package}" COMPONENT development)
    set_property(GLOBAL APPEND PROPERTY IDIOPHONE_INSTALLED_HEADERS ${arg_HEADERS})
    foreach(header ${arg_HEADERS})
        get_filename_component(module "${header}" DIRECTORY)
        install(FILES "Source/${header}.h" DESTINATION "${headers}/${module}" COMPONENT development)
    endforeach()
endfunction()

foreach(module Object Synth Mesh Gltf World Geometry Analysis)
    string(TOLOWER ${module} lower)
    set_target_properties(idiophone_${lower} PROPERTIES EXPORT_NAME ${module})
    target_compile_features(idiophone_${lower} PUBLIC cxx_std_20)
endforeach()

# The C interface.
set_target_properties(idiophone_c PROPERTIES EXPORT_NAME C)
install(TARGETS idiophone_c EXPORT IdiophoneTargets
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT development
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development
    PUBLIC_HEADER DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development
    INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
file(RELATIVE_PATH from_pkgconfig "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/idiophone.pc.in" idiophone.pc @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/idiophone.pc"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)

# Loads objects, strikes them and presses on them.
install_modules(IdiophoneTargets
    TARGETS idiophone_object idiophone_synth
    HEADERS
        Object/DampingLaw Object/Material Object/MaterialFile Object/MaterialText Object/ModalObject Object/ModalObjectBytes Object/ModalObjectFile
        Object/OrthotropicElasticity Object/RadiationTable Object/Result Object/WorkControl
        Synth/BowedPoint Synth/CellOutput Synth/ContactForce Synth/ContactWidth Synth/ForceCell Synth/HeardForce Synth/LiveConditions
        Synth/ModalPole Synth/PointModes Synth/Reson Synth/SlotStatus Synth/SoundingGroups Synth/Strike Synth/StrikePoints Synth/Surface Synth/SurfaceProfile
        Synth/Synthesiser Synth/SynthesiserSlot Synth/SynthesisSettings Synth/TubeOpening)
# Bodies in space, glTF files, and objects from meshes. A component of its own, because it needs Eigen.
install_modules(IdiophoneAnalysisTargets
    TARGETS idiophone_mesh idiophone_gltf idiophone_world idiophone_geometry idiophone_analysis idiophone_tetgen
    HEADERS
        Mesh/Mesh Mesh/ShapeMesh Mesh/SurfaceQuery
        World/HeadModel World/HeadResponses World/World
        Gltf/ObjectBytes Gltf/ObjectFile
        Geometry/LengthUnit Geometry/MeshReader Geometry/MeshRepair Geometry/MeshWriter
        Geometry/MetricMesh Geometry/ParametricMesh Geometry/PointCarrier
        Analysis/AnalysedBand Analysis/AnalysisMethod Analysis/Clamp Analysis/DampedSinusoid
        Analysis/MaterialFit Analysis/MeasuredObject Analysis/ModalAnalysis Analysis/Radiation
        Analysis/RecordedMaterial Analysis/RecordingFit Analysis/RecordingRest)
find_file(expected_header tl/expected.hpp HINTS "${expected_SOURCE_DIR}/include" REQUIRED)
install(FILES "${expected_header}" DESTINATION "${headers}/tl" COMPONENT development)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/IdiophoneConfig.cmake.in"
    IdiophoneConfig.cmake INSTALL_DESTINATION "${package}")
write_basic_package_version_file(IdiophoneConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
        "${CMAKE_CURRENT_BINARY_DIR}/IdiophoneConfig.cmake"
        "${CMAKE_CURRENT_BINARY_DIR}/IdiophoneConfigVersion.cmake"
    DESTINATION "${package}" COMPONENT development)
