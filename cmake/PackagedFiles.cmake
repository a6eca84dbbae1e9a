# Makes the files that CPack is about to pack the same on every machine: without symbols of the plugins, which
# CMake does not strip because they are in bundles, and with the permissions and the time of the sources.
file(GLOB_RECURSE plugins "${CPACK_TEMPORARY_DIRECTORY}/*.so")
execute_process(COMMAND strip --strip-unneeded ${plugins} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND chmod -R u=rwX,go=rX "${CPACK_TEMPORARY_DIRECTORY}" COMMAND_ERROR_IS_FATAL ANY)
if(DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND find "${CPACK_TEMPORARY_DIRECTORY}" -exec touch --no-dereference
            "--date=@$ENV{SOURCE_DATE_EPOCH}" {} +
        COMMAND_ERROR_IS_FATAL ANY)
endif()
