# idiophone_precompile(<target> [<header>...]): parses the given headers and the common standard
# headers once for all files of the target, because parsing takes most of a build's time. Files still
# include what they use.
function(idiophone_precompile target)
    get_target_property(sources ${target} SOURCES)
    list(LENGTH sources count)
    if(count LESS 6)
        return() # it would cost more than it saves
    endif()
    set(files <filesystem>)
    if(IDIOPHONE_WEB)
        set(files)
    endif()
    target_precompile_headers(${target} PRIVATE
        ${ARGN}
        <algorithm> <array> <cmath> <cstddef> <cstdint> ${files} <functional> <limits> <map>
        <memory> <numbers> <optional> <span> <string> <string_view> <utility> <vector>)
endfunction()
