# Embeds the lists of materials and mallets: the text for Object, which parses it, and the names for
# Parameters, which offers them as choices. To add a material or a mallet, add one entry to one file.
#
# idiophone_embed_list(<file> <key of the list> <function>): appends the source file that defines
# `function`, the text, to embedded_list_texts, and the source file that defines `functionNames` to
# embedded_list_names.
function(idiophone_embed_list file key function)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    file(READ "${file}" text)
    string(JSON count LENGTH "${text}" ${key})
    math(EXPR last "${count} - 1")
    set(names "")
    foreach(i RANGE ${last})
        string(JSON name GET "${text}" ${key} ${i} name)
        string(APPEND names "    R\"json(${name})json\",\n")
    endforeach()

    # One literal for each line, because compilers bound the length of a literal.
    string(REPLACE "\n" ")json\" \"\\n\"\nR\"json(" lines "${text}")

    set(text_source "${PROJECT_BINARY_DIR}/${function}.cpp")
    file(CONFIGURE OUTPUT "${text_source}" @ONLY CONTENT
"#include \"Object/EmbeddedLists.h\"

std::string_view idiophone::@function@() noexcept {
    return R\"json(@lines@)json\";
}
")
    set(names_source "${PROJECT_BINARY_DIR}/${function}Names.cpp")
    file(CONFIGURE OUTPUT "${names_source}" @ONLY CONTENT
"#include \"Parameters/EmbeddedNames.h\"

#include <array>

std::span<const std::string_view> idiophone::@function@Names() noexcept {
    static constexpr std::array<std::string_view, @count@> names{
@names@    };
    return names;
}
")
    set(embedded_list_texts ${embedded_list_texts} "${text_source}" PARENT_SCOPE)
    set(embedded_list_names ${embedded_list_names} "${names_source}" PARENT_SCOPE)
endfunction()

idiophone_embed_list("${PROJECT_SOURCE_DIR}/Resources/Materials/materials.json" materials embeddedMaterials)
idiophone_embed_list("${PROJECT_SOURCE_DIR}/Resources/Mallets/mallets.json" mallets embeddedMallets)
