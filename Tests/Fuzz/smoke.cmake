# Makes a CTest of each target if a clang with libFuzzer exists: it runs the corpus, then new
# inputs for a moment, the same ones every time.
#
# The targets link the libraries of this build, with its sanitizers if any, and libFuzzer varies the
# seeds without coverage feedback. Every week those without JUCE run also as clang builds them in
# the preset `fuzz`, with sanitizers and feedback: that takes minutes to build, with JUCE far longer.
function(find_libfuzzer found)
    set(${found} OFF PARENT_SCOPE)
    include(clang)
    if(NOT CMAKE_SYSTEM_NAME STREQUAL "Linux" OR NOT CLANG_C OR NOT CLANG_CXX)
        return()
    endif()
    set(probe "${CMAKE_CURRENT_BINARY_DIR}/libfuzzer_probe")
    file(WRITE "${probe}.cpp"
        "extern \"C\" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }\n")
    execute_process(
        COMMAND "${CLANG_CXX}" -std=c++20 -fsanitize=fuzzer,address,undefined "${probe}.cpp" -o "${probe}"
        RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
    execute_process(COMMAND "${CLANG_CXX}" -print-runtime-dir
        OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    file(GLOB library "${runtime}/libclang_rt.fuzzer-${CMAKE_SYSTEM_PROCESSOR}.a"
                      "${runtime}/libclang_rt.fuzzer.a")
    if(NOT failed AND library)
        set(${found} "${library}" PARENT_SCOPE)
    endif()
endfunction()

find_libfuzzer(libfuzzer)
if(NOT libfuzzer)
    foreach(module ${modules} ${modules_with_juce})
        foreach(target ${targets_of_${module}})
            untested("Fuzz: ${target}" TOOL "a clang for Linux with libFuzzer"
                PACKAGES clang-16 libclang-rt-16-dev)
        endforeach()
    endforeach()
    return()
endif()

# smoke_test(<test> <target> <program> <seconds> [CONFIGURATIONS <configuration>])
function(smoke_test test target program seconds)
    file(GLOB seeds CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/corpus/${target}/*")
    list(JOIN seeds "," seeds)
    set(dictionary "${CMAKE_CURRENT_SOURCE_DIR}/dictionaries/${target}.dict")
    if(EXISTS "${dictionary}")
        set(dictionary "-dict=${dictionary}")
    else()
        set(dictionary)
    endif()
    add_test(NAME "Fuzz: ${test}" ${ARGN}
        COMMAND "${program}" -seed=1 -keep_seed=1 -max_total_time=${seconds}
                ${dictionary} "-seed_inputs=${seeds}"
                "-artifact_prefix=${CMAKE_CURRENT_BINARY_DIR}/${target}-")
endfunction()

foreach(module ${modules} ${modules_with_juce})
    foreach(target ${targets_of_${module}})
        fuzz_program(${module} ${target})
        # libFuzzer needs libstdc++, also if the preset `clang` builds the rest with libc++. Clang
        # itself would then take -lstdc++ for its own library.
        target_link_libraries(fuzz_${target} PRIVATE "${libfuzzer}" -Wl,-lstdc++)
        smoke_test(${target} ${target} "$<TARGET_FILE:fuzz_${target}>" 2)
    endforeach()
endforeach()

if(IDIOPHONE_SANITIZE)
    return() # the targets above have them already
endif()

# The builds of all presets share one fuzz build, which `./dev soak` uses; other builds have their
# own.
set(fuzz_build "${PROJECT_SOURCE_DIR}/build/fuzz")
cmake_path(GET PROJECT_BINARY_DIR PARENT_PATH builds)
if(NOT builds STREQUAL "${PROJECT_SOURCE_DIR}/build")
    set(fuzz_build "${PROJECT_BINARY_DIR}/fuzz")
endif()
set(fetched)
foreach(name bullet cli11 ebur128 juce libigl mts_esp mysofa tetgen tuning_library)
    string(TOUPPER ${name} upper)
    list(APPEND fetched "-DFETCHCONTENT_SOURCE_DIR_${upper}=${${name}_SOURCE_DIR}")
endforeach()
add_test(NAME "Fuzz: The preset fuzz is configured" CONFIGURATIONS Weekly
    COMMAND ${CMAKE_COMMAND} --preset fuzz --log-level=WARNING --no-warn-unused-cli
            -S "${PROJECT_SOURCE_DIR}" -B "${fuzz_build}"
            "-DIDIOPHONE_DEPENDENCIES=${IDIOPHONE_DEPENDENCIES}"
            "-DIDIOPHONE_DEBIAN_SOURCES=${IDIOPHONE_DEBIAN_SOURCES}"
            ${fetched}
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
add_test(NAME "Fuzz: The preset fuzz is built" CONFIGURATIONS Weekly
    COMMAND ${CMAKE_COMMAND} --build "${fuzz_build}" --target fuzz_targets_without_juce --parallel 2)
set_tests_properties("Fuzz: The preset fuzz is configured" PROPERTIES
    FIXTURES_SETUP fuzz_configuration)
set_tests_properties("Fuzz: The preset fuzz is built" PROPERTIES PROCESSORS 2
    FIXTURES_REQUIRED fuzz_configuration FIXTURES_SETUP fuzz_build)

foreach(module ${modules})
    foreach(target ${targets_of_${module}})
        smoke_test("${target}, with sanitizers" ${target} "${fuzz_build}/Tests/Fuzz/fuzz_${target}"
            10 CONFIGURATIONS Weekly)
        set_tests_properties("Fuzz: ${target}, with sanitizers" PROPERTIES FIXTURES_REQUIRED fuzz_build)
    endforeach()
endforeach()
