# idiophone_precompile(<target> [<header>...]): what most files of a target include is parsed once, as
# parsing is two thirds of the time that a build takes. Names the headers of libraries; those of the
# standard library that are everywhere come with them. Files still include what they use.
function(idiophone_precompile target)
    get_target_property(sources ${target} SOURCES)
    list(LENGTH sources count)
    if(count LESS 6)
        return() # it would cost more than it saves
    endif()
    target_precompile_headers(${target} PRIVATE
        ${ARGN}
        <algorithm> <array> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map>
        <memory> <numbers> <optional> <span> <string> <string_view> <utility> <vector>)
endfunction()
