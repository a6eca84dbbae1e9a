# Boost.Lockfree, header only: the queues between threads.
if(TARGET Boost::headers)
    return()
endif()
find_package(Boost 1.66 REQUIRED)
