# Prints why a test cannot run, and fails. CTest counts that as skipped unless the tool is required.
#   cmake -DTOOL=... -DPACKAGES=... -P untested.cmake
set(sentence "${TOOL} is not found")
if(PACKAGES)
    list(JOIN PACKAGES ", " packages)
    string(APPEND sentence "; in Debian: ${packages}")
endif()
message(FATAL_ERROR "${sentence}")
