# Eigen 3.4: linear algebra.
if(TARGET Eigen3::Eigen)
    return()
endif()
set(EIGEN_BUILD_DOC OFF)
set(BUILD_TESTING OFF)
FetchContent_Declare(Eigen3
    GIT_REPOSITORY https://gitlab.com/libeigen/eigen.git
    GIT_TAG 3.4.0
    GIT_SHALLOW ON
    FIND_PACKAGE_ARGS 3.4)
FetchContent_MakeAvailable(Eigen3)
