# Boost.Lockfree, header only: the queues between threads.
if(TARGET Boost::headers)
    return()
endif()
find_package(Boost 1.66 REQUIRED)
# Boost's hash derives from std::unary_function, which libc++ leaves out of C++17 unless told otherwise.
if(Boost_VERSION VERSION_LESS 1.81)
    target_compile_definitions(Boost::headers INTERFACE _LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION)
endif()
