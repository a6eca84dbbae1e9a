#include "Analysis/ToneMap.h"
#include "Console/Command.h"
#include "Console/JsonText.h"
#include "Console/OptionChecks.h"
#include "Geometry/ColourMap.h"
#include "Geometry/MeshWriter.h"
#include "Gltf/ObjectFile.h"
#include "Mesh/ShapeMesh.h"
#include "Object/FileBytes.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>

namespace idiophone {
namespace {

struct ToneMapOptions {
    std::filesystem::path object;
    std::filesystem::path output;
    bool json = false;
};

struct Range {
    std::size_t lowest = 0, highest = 0; ///< rows
    std::size_t silent = 0;
};

/// Returns the range over the vertices that sound, or an error if none does.
Result<Range> rangeOf(const std::vector<double>& brightness, const ToneMapOptions& options) {
    Range range;
    double lowest = std::numeric_limits<double>::infinity(), highest = 0;
    for (std::size_t row = 0; row < brightness.size(); ++row) {
        const double hz = brightness[row];
        range.silent += hz > 0 ? 0 : 1;
        if (hz > 0 && hz < lowest) {
            lowest = hz;
            range.lowest = row;
        }
        if (hz > highest) {
            highest = hz;
            range.highest = row;
        }
    }
    if (highest == 0)
        return failure(nameOf(options.object) + ": none of its modes is audible");
    return range;
}

/// Equal steps of colour are equal ratios of frequency.
VertexFigures figuresOf(const std::vector<double>& brightness, const Range& range) {
    VertexFigures figures{.name = "brightness_hz", .values = brightness, .colours = {}};
    const double lowest = std::log(brightness[range.lowest]);
    const double span = std::log(brightness[range.highest]) - lowest;
    for (const double hz : brightness)
        figures.colours.push_back(viridis(hz > 0 && span > 0 ? (std::log(hz) - lowest) / span : 0));
    return figures;
}

void report(const ModalObject& object,
            const Mesh& mesh,
            const std::vector<double>& brightness,
            const Range& range,
            const ToneMapOptions& options) {
    const auto point = [&](std::size_t row) {
        const Eigen::RowVector3d place = mesh.vertices.row(static_cast<Eigen::Index>(row));
        return std::array{place.x(), place.y(), place.z()};
    };
    if (options.json) {
        const auto end = [&](std::size_t row) {
            return nlohmann::ordered_json{{"brightness_hz", brightness[row]},
                                          {"vertex", object.shapeVertices[row]},
                                          {"point_m", point(row)}};
        };
        std::cout << jsonText({{"map", nameOf(options.output)},
                               {"vertices", brightness.size()},
                               {"silent_vertices", range.silent},
                               {"darkest", end(range.lowest)},
                               {"brightest", end(range.highest)}});
        return;
    }
    const auto tell = [&](const char* what, std::size_t row) {
        const auto place = point(row);
        std::cout << std::setprecision(1) << what << brightness[row] << " Hz at vertex "
                  << object.shapeVertices[row] << std::setprecision(4) << " (" << place[0] << ", "
                  << place[1] << ", " << place[2] << " m)";
    };
    std::cout << std::fixed << nameOf(options.output) << ": " << brightness.size() << " vertices, ";
    tell("darkest ", range.lowest);
    tell(", brightest ", range.highest);
    std::cout << '\n' << std::flush;
}

Result<void> mapObject(const ToneMapOptions& options) {
    const auto object = readObject(options.object);
    if (!object)
        return tl::unexpected(object.error());
    if (options.output.extension() != ".ply")
        return failure(nameOf(options.output) + ": its extension is not .ply");
    const auto brightness = brightnessHz(*object, vertexNormals(*object));
    const auto range = rangeOf(brightness, options);
    if (!range)
        return tl::unexpected(range.error());
    const auto mesh = shapeMesh(*object);
    if (auto written = writeColouredMesh(mesh, figuresOf(brightness, *range), options.output);
        !written)
        return written;
    report(*object, mesh, brightness, *range, options);
    return {};
}

} // namespace

void addToneMap(CLI::App& program, Action& chosen) {
    const auto [command, options] = addCommand<ToneMapOptions>(
        program, chosen, "map",
        "Colours the surface of an object by the brightness of a strike there", mapObject);
    command->add_option("OBJECT", options->object, "A .modal or glTF file")->required();
    command->add_option("-o,--output", options->output, "The .ply file to write")
        ->type_name(writtenFile)
        ->required();
    command->add_flag("--json", options->json, "Writes the report as JSON");
}

} // namespace idiophone
