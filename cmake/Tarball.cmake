# Packs the staged files as a .tar.gz: sorted, and without the user and the clock of this machine.
set(archive "${CPACK_PACKAGE_DIRECTORY}/${CPACK_PACKAGE_FILE_NAME}.tar.gz")
execute_process(
    COMMAND tar --create --format gnu --sort name --owner 0 --group 0 --numeric-owner
            --directory "${CPACK_TOPLEVEL_DIRECTORY}" "${CPACK_PACKAGE_FILE_NAME}"
    COMMAND gzip --no-name
    OUTPUT_FILE "${archive}"
    COMMAND_ERROR_IS_FATAL ANY)
set(CPACK_EXTERNAL_BUILT_PACKAGES "${archive}")
