# nlohmann-json 3.11: presets, headers of modal objects, --json.
if(TARGET nlohmann_json::nlohmann_json)
    return()
endif()
FetchContent_Declare(nlohmann_json
    GIT_REPOSITORY https://github.com/nlohmann/json.git
    GIT_TAG v3.11.2
    GIT_SHALLOW ON
    SYSTEM
    FIND_PACKAGE_ARGS 3.11)
FetchContent_MakeAvailable(nlohmann_json)
