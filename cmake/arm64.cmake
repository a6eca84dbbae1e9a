# The toolchain of the preset `arm64`: Debian's cross compiler, with the arm64 packages of the same libraries.
# qemu runs what is built, also the tests.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CGAL_DIR "/usr/lib/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu/cmake/CGAL") # headers, for one processor at a time
set(ENV{PKG_CONFIG_LIBDIR} /usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig)
set(IDIOPHONE_DEBIAN_ARCHITECTURE :arm64) # of packages with compiled parts
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64)
# Else gcc says that versions before 10.1 passed std::pair<double, double> otherwise.
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi)
