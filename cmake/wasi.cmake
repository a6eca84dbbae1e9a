# The toolchain of the preset `web`: clang and the WASI libraries of Debian 12.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CMAKE_PREFIX_PATH /usr)

set(llvm /usr/lib/llvm-16)
foreach(language C CXX)
    set(CMAKE_${language}_COMPILER_TARGET wasm32-wasi)
endforeach()
set(CMAKE_C_COMPILER ${llvm}/bin/clang)
set(CMAKE_CXX_COMPILER ${llvm}/bin/clang++)
set(CMAKE_AR ${llvm}/bin/llvm-ar)
set(CMAKE_RANLIB ${llvm}/bin/llvm-ranlib)

# /usr/include comes last, for libraries without compiled parts: its C library is not that of WASI.
set(CMAKE_C_FLAGS_INIT
    "-nostdlibinc -isystem /usr/include/wasm32-wasi -idirafter /usr/include -Wno-unused-command-line-argument")
set(CMAKE_CXX_FLAGS_INIT
    "-nostdlibinc -nostdinc++ -isystem ${llvm}/include/wasm32-wasi/c++/v1 -isystem /usr/include/wasm32-wasi -idirafter /usr/include -fwasm-exceptions -Wno-unused-command-line-argument")
set(CMAKE_EXE_LINKER_FLAGS_INIT
    "-nodefaultlibs -nostartfiles -fuse-ld=${llvm}/bin/wasm-ld -mexec-model=reactor /usr/lib/wasm32-wasi/crt1-reactor.o -L${llvm}/lib/wasm32-wasi -L/usr/lib/wasm32-wasi")
set(CMAKE_CXX_STANDARD_LIBRARIES
    "-lc++ -lc++abi -lc ${llvm}/lib/clang/16/lib/wasi/libclang_rt.builtins-wasm32.a")
