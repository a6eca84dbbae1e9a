# CGAL 5.5.1, header only: remeshing, simplification of scans, exact predicates of triangles. The
# predicates use Boost's integers instead of GMP and MPFR. CGAL 6.0 remeshes some degenerate meshes for ever.
if(TARGET idiophone_cgal)
    return()
endif()
add_library(idiophone_cgal INTERFACE)
set(CGAL_DISABLE_GMP ON)
find_package(CGAL 5.5.1 EXACT QUIET)
if(TARGET CGAL::CGAL)
    target_link_libraries(idiophone_cgal INTERFACE CGAL::CGAL)
else()
    find_package(Boost 1.66 REQUIRED)
    idiophone_debian_binary(cgal PACKAGE libcgal-dev VERSION 5.5.1-2 SUITE bookworm)
    if(cgal)
        set(cgal_headers "${cgal}/usr/include")
    else()
        # The release archive, for the repository keeps the headers in a folder for each package.
        FetchContent_Declare(CGAL
            URL https://github.com/CGAL/cgal/releases/download/v5.5.1/CGAL-5.5.1-library.tar.xz
            SOURCE_SUBDIR none) # populated, not added: only the headers are needed
        FetchContent_MakeAvailable(CGAL)
        set(cgal_headers "${cgal_SOURCE_DIR}/include")
    endif()
    target_include_directories(idiophone_cgal SYSTEM INTERFACE "${cgal_headers}")
    target_compile_definitions(idiophone_cgal INTERFACE CGAL_DISABLE_GMP=1)
    # CGAL's interval arithmetic changes the rounding mode.
    target_compile_options(idiophone_cgal INTERFACE
        $<$<CXX_COMPILER_ID:GNU>:-frounding-math>
        $<$<CXX_COMPILER_ID:MSVC>:/fp:strict>)
    target_link_libraries(idiophone_cgal INTERFACE Boost::headers)
endif()
target_link_libraries(idiophone_cgal INTERFACE Eigen3::Eigen)
# CGAL 5.5 uses these without including them; Boost 1.90's other headers no longer bring them.
foreach(header boost/mpl/if.hpp boost/next_prior.hpp)
    target_compile_options(idiophone_cgal INTERFACE
        "$<IF:$<CXX_COMPILER_ID:MSVC>,/FI${header},SHELL:-include ${header}>")
endforeach()
# Its assertions check the whole mesh after every collapse of an edge: quadratic time.
target_compile_definitions(idiophone_cgal INTERFACE CGAL_NDEBUG CGAL_EIGEN3_ENABLED)
