# Makes the files that CPack is about to pack the same on every machine: with fixed permissions, the time of the
# sources, and without symbols. CMake itself strips only what is installed as a target, not JUCE's bundles.
file(GLOB_RECURSE programs "${CPACK_TEMPORARY_DIRECTORY}/*.so" "${CPACK_TEMPORARY_DIRECTORY}/idiophone-standalone")
execute_process(COMMAND "${CPACK_STRIP_PROGRAM}" --strip-unneeded ${programs} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND chmod -R u=rwX,go=rX "${CPACK_TEMPORARY_DIRECTORY}" COMMAND_ERROR_IS_FATAL ANY)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND find "${CPACK_TEMPORARY_DIRECTORY}" -exec touch --no-dereference
            "--date=@$ENV{SOURCE_DATE_EPOCH}" {} +
        COMMAND_ERROR_IS_FATAL ANY)
endif()
if(CPACK_DEBIAN_PACKAGE_ARCHITECTURE)
    set(ENV{DEB_HOST_ARCH} "${CPACK_DEBIAN_PACKAGE_ARCHITECTURE}") # for dpkg-shlibdeps
endif()
