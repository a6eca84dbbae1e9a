# Says why a test is not run, and fails: CTest takes that for skipped unless its tool should be here.
#   cmake -DTOOL=... -DPACKAGES=... -P untested.cmake
set(sentence "${TOOL} is not found")
if(PACKAGES)
    list(JOIN PACKAGES ", " packages)
    string(APPEND sentence "; in Debian: ${packages}")
endif()
message(FATAL_ERROR "${sentence}")
