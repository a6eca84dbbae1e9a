# Highway 1.2 for the WebAssembly module, where 1.0 has no doubles, and for MinGW. Its headers suffice
# where the instruction set is fixed.
idiophone_debian_source(highway PACKAGE highway VERSION 1.2.0-2 SUITE trixie FOLDER hwy)
FetchContent_Declare(highway
    GIT_REPOSITORY https://github.com/google/highway.git
    GIT_TAG 1.2.0
    GIT_SHALLOW ON
    SOURCE_SUBDIR none) # populated, not added: its own build makes a library
FetchContent_MakeAvailable(highway)
