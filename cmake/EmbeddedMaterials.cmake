# Resources/Materials/materials.json inside the program: its text for Object, which reads it, and the
# materials' names for Parameters, whose material choice has them. So a material is one entry there.
set(material_file "${PROJECT_SOURCE_DIR}/Resources/Materials/materials.json")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${material_file}")
file(READ "${material_file}" material_text)

string(JSON material_count LENGTH "${material_text}" materials)
math(EXPR last_material "${material_count} - 1")
set(material_names "")
foreach(i RANGE ${last_material})
    string(JSON name GET "${material_text}" materials ${i} name)
    string(APPEND material_names "    R\"json(${name})json\",\n")
endforeach()

# A literal for each line, as compilers bound the length of one.
string(REPLACE "\n" ")json\" \"\\n\"\nR\"json(" material_lines "${material_text}")

set(embedded_material_text "${PROJECT_BINARY_DIR}/EmbeddedMaterials.cpp")
file(CONFIGURE OUTPUT "${embedded_material_text}" @ONLY CONTENT
"#include \"Object/EmbeddedMaterials.h\"

std::string_view idiophone::embeddedMaterials() noexcept {
    return R\"json(@material_lines@)json\";
}
")
set(embedded_material_names "${PROJECT_BINARY_DIR}/EmbeddedMaterialNames.cpp")
file(CONFIGURE OUTPUT "${embedded_material_names}" @ONLY CONTENT
"#include \"Parameters/MaterialNames.h\"

#include <array>

std::span<const std::string_view> idiophone::libraryMaterialNames() noexcept {
    static constexpr std::array<std::string_view, @material_count@> names{
@material_names@    };
    return names;
}
")
