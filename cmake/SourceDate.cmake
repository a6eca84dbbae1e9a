# Sets SOURCE_DATE_EPOCH to the time of the commit, unless it is set, so that one commit gives one package.
# For CMake and for CPack.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
    execute_process(COMMAND git log -1 --format=%ct
        WORKING_DIRECTORY "${CMAKE_CURRENT_LIST_DIR}"
        OUTPUT_VARIABLE seconds OUTPUT_STRIP_TRAILING_WHITESPACE
        RESULT_VARIABLE failed ERROR_QUIET)
    if(NOT failed)
        set(ENV{SOURCE_DATE_EPOCH} ${seconds})
    endif()
endif()
