# The places to which `cmake --install` copies files, and the packages that CPack makes of them (docs/packages.md).
include(GNUInstallDirs)
include(SourceDate)

# Installs a bundle, which is a directory. Its files keep their permissions.
function(install_bundle target destination component)
    get_target_property(bundle ${target} JUCE_PLUGIN_ARTEFACT_FILE)
    install(DIRECTORY "${bundle}" DESTINATION "${destination}" COMPONENT ${component}
        USE_SOURCE_PERMISSIONS)
endfunction()

# Installs the CLAPs, where they are built: a file each, on macOS a bundle.
function(install_claps destination)
    if(IDIOPHONE_CLAP)
        install(TARGETS Idiophone_CLAP IdiophoneResonator_CLAP
            LIBRARY DESTINATION "${destination}" COMPONENT plugin)
    endif()
endfunction()

# Has macOS's installer write the bundles to these paths. Else it replaces other bundles of the same
# identifier, such as those in a build folder.
function(keep_in_place component) # PATH...
    set(entries "")
    foreach(path ${ARGN})
        string(APPEND entries "    <dict>
        <key>RootRelativeBundlePath</key><string>${path}</string>
        <key>BundleHasStrictIdentifier</key><true/>
        <key>BundleIsRelocatable</key><false/>
        <key>BundleIsVersionChecked</key><false/>
        <key>BundleOverwriteAction</key><string>upgrade</string>
    </dict>\n")
    endforeach()
    set(list "${CMAKE_CURRENT_BINARY_DIR}/${component}.plist")
    file(CONFIGURE OUTPUT "${list}" CONTENT "<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<plist version=\"1.0\">
<array>
${entries}</array>
</plist>
" @ONLY)
    string(TOUPPER "CPACK_COMPONENT_${component}_PLIST" variable)
    set(${variable} "${list}" PARENT_SCOPE)
endfunction()

# The branches for macOS and Windows have not been run yet.
if(APPLE)
    set(audio "Library/Audio/Plug-Ins")
    foreach(plugin Idiophone IdiophoneResonator)
        install_bundle(${plugin}_VST3 "${audio}/VST3" plugin)
        install_bundle(${plugin}_AU "${audio}/Components" plugin)
        install_bundle(${plugin}_LV2 "${audio}/LV2" plugin)
    endforeach()
    install_claps("${audio}/CLAP")
    install(TARGETS Idiophone_Standalone BUNDLE DESTINATION Applications COMPONENT standalone)
    install(TARGETS idiophone_console RUNTIME DESTINATION usr/local/bin COMPONENT console)
    keep_in_place(standalone Applications/Idiophone.app)
    foreach(name "Idiophone" "Idiophone Resonator")
        list(APPEND bundles "${audio}/VST3/${name}.vst3" "${audio}/Components/${name}.component")
        if(IDIOPHONE_CLAP)
            list(APPEND bundles "${audio}/CLAP/${name}.clap")
        endif()
    endforeach()
    keep_in_place(plugin ${bundles})
    foreach(component plugin standalone console)
        install(FILES LICENSE THIRD-PARTY DESTINATION usr/local/share/doc/idiophone
            COMPONENT ${component})
    endforeach()
elseif(WIN32)
    foreach(plugin Idiophone IdiophoneResonator)
        install_bundle(${plugin}_VST3 "VST3" plugin)
        install_bundle(${plugin}_LV2 "LV2" plugin)
    endforeach()
    install_claps(CLAP)
    install(TARGETS Idiophone_Standalone RUNTIME DESTINATION . COMPONENT standalone)
    install(TARGETS idiophone_console RUNTIME DESTINATION console COMPONENT console)
    foreach(component plugin standalone console)
        install(FILES LICENSE THIRD-PARTY DESTINATION . COMPONENT ${component})
    endforeach()
else()
    # Hosts look here, not in the folder of the architecture.
    foreach(plugin Idiophone IdiophoneResonator)
        install_bundle(${plugin}_VST3 lib/vst3 plugin)
        install_bundle(${plugin}_LV2 lib/lv2 plugin)
    endforeach()
    install_claps(lib/clap)
    install(PROGRAMS "$<TARGET_FILE:Idiophone_Standalone>" DESTINATION "${CMAKE_INSTALL_BINDIR}"
        RENAME idiophone-standalone COMPONENT standalone)
    install(TARGETS idiophone_console RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT console)
    # The first entry of the changelog is this version's. Without a date, that of the sources counts.
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/CHANGELOG.md")
    file(STRINGS CHANGELOG.md release REGEX "^## " LIMIT_COUNT 1)
    if(NOT release MATCHES "^## ([0-9.]+) \\((unreleased|[0-9-]+)\\)$"
            OR NOT CMAKE_MATCH_1 STREQUAL PROJECT_VERSION)
        message(FATAL_ERROR "CHANGELOG.md begins with '${release}', not with "
                            "'## ${PROJECT_VERSION} (unreleased)' or a date in its place.")
    endif()
    set(release_date "${CMAKE_MATCH_2}")
    if(release_date STREQUAL "unreleased")
        string(TIMESTAMP release_date "%Y-%m-%d" UTC)
    endif()
    set(desktop "${PROJECT_SOURCE_DIR}/Resources/Desktop/org.idiophone.Idiophone")
    configure_file("${desktop}.metainfo.xml.in" org.idiophone.Idiophone.metainfo.xml @ONLY)
    install(FILES "${desktop}.desktop"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/applications" COMPONENT standalone)
    install(FILES "${desktop}.svg"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps" COMPONENT standalone)
    install(FILES "${CMAKE_CURRENT_BINARY_DIR}/org.idiophone.Idiophone.metainfo.xml"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/metainfo" COMPONENT standalone)
    set(documents "${CMAKE_INSTALL_DATADIR}/doc/idiophone")
    install(FILES README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md
        DESTINATION "${documents}" COMPONENT console)
    install(DIRECTORY docs DESTINATION "${documents}" COMPONENT console
        PATTERN "*.py" EXCLUDE PATTERN "*.sh" EXCLUDE)
    # Files that the pages link to.
    install(FILES LICENSE LICENSE-APACHE THIRD-PARTY DESTINATION "${documents}" COMPONENT console)
    install(DIRECTORY Presets examples DESTINATION "${documents}" COMPONENT console
        PATTERN "__pycache__" EXCLUDE)
    install(DIRECTORY Resources/Mallets Resources/Materials Resources/Pictures
        DESTINATION "${documents}/Resources" COMPONENT console)
    if(IDIOPHONE_PORTABLE)
        install(FILES Resources/Tarball/README.txt DESTINATION . COMPONENT console)
        install(PROGRAMS Resources/Tarball/install.sh DESTINATION . COMPONENT console)
    endif()
    install(FILES Resources/Songs/TheEntertainer.mid DESTINATION "${documents}/examples"
        COMPONENT console)
endif()

set(CPACK_PACKAGE_NAME idiophone)
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_COMPONENTS_ALL plugin standalone console) # without files of dependencies
set(CPACK_PACKAGE_VENDOR Idiophone)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Physical-modelling instrument: meshes become playable objects")
set(CPACK_PACKAGE_CONTACT "Idiophone <team@idiophone.org>")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_CURRENT_LIST_DIR}/SourceDate.cmake")
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/PackagedFiles.cmake")
    set(CPACK_STRIP_PROGRAM "${CMAKE_STRIP}")
endif()
if(APPLE)
    # The library is left out: under the prefix / it would go where macOS lets nobody write. Nothing is
    # stripped, which would break signatures (.ci/package_macos).
    set(CPACK_GENERATOR productbuild)
    set(CPACK_PACKAGING_INSTALL_PREFIX /)
    set(CPACK_SYSTEM_NAME macOS)
    configure_file(LICENSE LICENSE.txt COPYONLY) # the installer wants the ending
    set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_CURRENT_BINARY_DIR}/LICENSE.txt")
elseif(WIN32)
    list(APPEND CPACK_COMPONENTS_ALL development)
    set(CPACK_GENERATOR NSIS)
    set(CPACK_NSIS_DISPLAY_NAME Idiophone)
    set(CPACK_NSIS_ENABLE_UNINSTALL_BEFORE_INSTALL ON)
    set(CPACK_NSIS_EXTRA_INSTALL_COMMANDS
        "CreateDirectory '$COMMONFILES64\\VST3'\nCopyFiles /SILENT '$INSTDIR\\VST3\\*' '$COMMONFILES64\\VST3'")
    set(CPACK_NSIS_EXTRA_UNINSTALL_COMMANDS "RMDir /r '$COMMONFILES64\\VST3\\Idiophone.vst3'\nRMDir /r '$COMMONFILES64\\VST3\\Idiophone Resonator.vst3'")
    if(IDIOPHONE_CLAP)
        string(APPEND CPACK_NSIS_EXTRA_INSTALL_COMMANDS
            "\nCreateDirectory '$COMMONFILES64\\CLAP'\nCopyFiles /SILENT '$INSTDIR\\CLAP\\*' '$COMMONFILES64\\CLAP'")
        string(APPEND CPACK_NSIS_EXTRA_UNINSTALL_COMMANDS
            "\nDelete '$COMMONFILES64\\CLAP\\Idiophone.clap'\nDelete '$COMMONFILES64\\CLAP\\Idiophone Resonator.clap'")
    endif()
elseif(IDIOPHONE_PORTABLE)
    set(CPACK_GENERATOR External) # Tarball.cmake
    set(CPACK_STRIP_FILES ON)
    set(CPACK_MONOLITHIC_INSTALL ON)
    set(CPACK_INSTALL_CMAKE_PROJECTS "")
    foreach(component plugin standalone console)
        list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR}" Idiophone ${component} /)
    endforeach()
    set(CPACK_PACKAGE_FILE_NAME "idiophone-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR}")
    set(CPACK_EXTERNAL_ENABLE_STAGING ON)
    set(CPACK_EXTERNAL_PACKAGE_SCRIPT "${CMAKE_CURRENT_LIST_DIR}/Tarball.cmake")
else()
    list(APPEND CPACK_COMPONENTS_ALL development)
    set(CPACK_STRIP_FILES ON)
    include(DebianPackages)
endif()
include(CPack)
