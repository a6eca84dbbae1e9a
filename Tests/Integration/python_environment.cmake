# Makes the Python environment of Tests/Integration, unless it exists and matches requirements.txt.
# CTest runs it as a fixture, in script mode, with PYTHON, REQUIREMENTS and ENVIRONMENT.
cmake_minimum_required(VERSION 3.25)

file(SHA256 "${REQUIREMENTS}" wanted)
set(stamp "${ENVIRONMENT}/requirements.sha256")
if(EXISTS "${stamp}")
    file(READ "${stamp}" installed)
    if(installed STREQUAL wanted)
        message(STATUS "The Python environment is up to date")
        return()
    endif()
endif()

execute_process(COMMAND "${PYTHON}" -m venv --clear "${ENVIRONMENT}" COMMAND_ERROR_IS_FATAL ANY)
find_program(environment_python NAMES python3 python PATHS "${ENVIRONMENT}/bin"
    "${ENVIRONMENT}/Scripts" NO_DEFAULT_PATH REQUIRED)
execute_process(
    COMMAND "${environment_python}" -m pip install --quiet --disable-pip-version-check
            --only-binary :all: --requirement "${REQUIREMENTS}"
    COMMAND_ERROR_IS_FATAL ANY)
file(WRITE "${stamp}" "${wanted}")
