# Checks a TypeScript program that imports the package: cmake -DTOOLS= -DPACKAGE= -DPROGRAM= -DNODE= -DFOLDER=
# -P check_types.cmake
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}/node_modules")
file(CREATE_LINK "${PACKAGE}" "${FOLDER}/node_modules/idiophone" SYMBOLIC)
file(COPY "${PROGRAM}" DESTINATION "${FOLDER}")
cmake_path(GET PROGRAM FILENAME program)
execute_process(
    COMMAND "${NODE}" "${TOOLS}/node_modules/typescript/bin/tsc" --noEmit --strict --noUncheckedIndexedAccess
            --target es2022 --module nodenext --skipLibCheck false "${program}"
    WORKING_DIRECTORY "${FOLDER}"
    COMMAND_ERROR_IS_FATAL ANY)
