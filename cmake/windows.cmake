# The toolchain of the preset `windows`: MinGW, for what needs no JUCE, because JUCE needs Microsoft's compiler.
# Wine runs what is built, also the tests.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
# /usr/include comes last, for libraries without compiled parts.
set(CMAKE_PREFIX_PATH /usr)
set(CGAL_DIR "/usr/lib/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu/cmake/CGAL")
set(CMAKE_C_FLAGS_INIT "-idirafter /usr/include")
# Without -fno-ipa-ra, gcc expects an inline function to spare the registers that its own copy spares, while the linker
# takes another file's copy, with other flags.
set(CMAKE_CXX_FLAGS_INIT "-idirafter /usr/include -fno-ipa-ra")
