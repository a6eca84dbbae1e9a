#include "Analysis/TetGenMesher.h"

#include "Analysis/TetGenWatch.h"
#include "Object/WorkControl.h"

#define TETLIBRARY // without it, the header ends the process on an error
#include <tetgen.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>
#include <mutex>
#include <new>
#include <thread>

namespace idiophone {
namespace {

void copySurface(const Mesh& surface, tetgenio& input) {
    input.firstnumber = 0;
    input.numberofpoints = static_cast<int>(surface.vertexCount());
    input.pointlist = new REAL[3 * static_cast<std::size_t>(surface.vertexCount())];
    for (Eigen::Index v = 0; v < surface.vertexCount(); ++v)
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            input.pointlist[3 * v + axis] = surface.vertices(v, axis);
    const auto faces = static_cast<std::size_t>(surface.faceCount());
    input.facetlist = new tetgenio::facet[faces];
    for (std::size_t f = 0; f < faces; ++f)
        tetgenio::init(&input.facetlist[f]);
    input.numberoffacets = static_cast<int>(faces);
    for (std::size_t f = 0; f < faces; ++f) {
        auto& facet = input.facetlist[f];
        facet.polygonlist = new tetgenio::polygon[1];
        facet.numberofpolygons = 1;
        tetgenio::init(facet.polygonlist);
        facet.polygonlist->vertexlist = new int[3];
        facet.polygonlist->numberofvertices = 3;
        for (int k = 0; k < 3; ++k)
            facet.polygonlist->vertexlist[k] = surface.faces(f, k);
    }
}

void configure(const TetGenSettings& settings, tetgenbehavior& behavior) {
    behavior.plc = 1;
    behavior.quality = 1;
    behavior.minratio = settings.radiusEdgeRatio;
    behavior.nobisect = settings.keepSurface ? 1 : 0;
    behavior.regionattrib = 1;
    behavior.zeroindex = 1;
    behavior.nojettison = 1;
    behavior.quiet = 1;
    behavior.steinerleft = settings.maximumAddedPoints;
    if (settings.maximumVolumeM3 > 0) {
        behavior.fixedvolume = 1;
        behavior.maxvolume = settings.maximumVolumeM3;
    }
}

/// Repeats the steps of `tetrahedralize` for these switches.
void fill(tetgenmesh& mesh, tetgenio& output) {
    const tetgenbehavior& behavior = *mesh.b;
    std::clock_t ignored = 0;
    mesh.initializepools();
    mesh.transfernodes();
    exactinit(0, 0, 0, mesh.xmax - mesh.xmin, mesh.ymax - mesh.ymin, mesh.zmax - mesh.zmin);
    mesh.incrementaldelaunay(ignored);
    mesh.meshsurface();
    if (behavior.nobisect != 0)
        mesh.recoverboundary(ignored);
    else
        mesh.constraineddelaunay(ignored);
    mesh.carveholes();
    if (behavior.nobisect != 0) {
        if (mesh.subvertstack->objects > 0)
            mesh.suppresssteinerpoints();
        mesh.recoverdelaunay();
    }
    mesh.delaunayrefinement();
    mesh.optimizemesh();
    output.firstnumber = mesh.in->firstnumber;
    output.mesh_dim = mesh.in->mesh_dim;
    mesh.outnodes(&output);
    if (mesh.tetrahedrons->items > 0)
        mesh.outelements(&output);
}

/// `tetrahedralize` has its workspace on the stack, and terminatetetgen() frees it before it
/// throws. The destructor would then free it again. So here the workspace is not destroyed after an
/// exception; only its memory is released.
void fillOrThrow(tetgenio& input, tetgenbehavior& behavior, tetgenio& output) {
    auto workspace = std::make_unique<tetgenmesh>();
    workspace->b = &behavior;
    workspace->in = &input;
    try {
        fill(*workspace, output);
    } catch (int) {
        ::operator delete(static_cast<void*>(workspace.release()));
        throw;
    }
}

Result<LinearTetrahedra> resultOf(const tetgenio& output) {
    if (output.numberoftetrahedra < 1)
        return failure("The surface encloses nothing that could be filled with tetrahedra.");
    LinearTetrahedra result{.points = Eigen::MatrixXd(output.numberofpoints, 3),
                            .tetrahedra = Eigen::MatrixXi(output.numberoftetrahedra, 4),
                            .regions = Eigen::VectorXi::Zero(output.numberoftetrahedra)};
    for (Eigen::Index p = 0; p < result.points.rows(); ++p)
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            result.points(p, axis) = output.pointlist[3 * p + axis];
    const int attributes = output.numberoftetrahedronattributes;
    for (Eigen::Index t = 0; t < result.tetrahedra.rows(); ++t) {
        for (Eigen::Index k = 0; k < 4; ++k)
            result.tetrahedra(t, k) = output.tetrahedronlist[output.numberofcorners * t + k];
        if (attributes > 0)
            result.regions(t) =
                static_cast<int>(output.tetrahedronattributelist[attributes * t + attributes - 1]);
    }
    return result;
}

std::string sentence(int code) {
    switch (code) {
    case 1:
        return "Filling the solid needs more memory than this machine has.";
    case 3:
        return "The surface passes through itself, so that it encloses no clear volume.";
    case 4:
        return "The surface has details too small to be filled as a solid; simplify the mesh.";
    case 5:
        return "Two faces of the surface lie too close together to be told apart.";
    default:
        return "The surface could not be filled as a solid (TetGen error " + std::to_string(code) +
               ").";
    }
}

std::string sentence(TetGenStop stop) {
    switch (stop) {
    case TetGenStop::cancelled:
        return std::string(cancelledMessage);
    case TetGenStop::tooLong:
        return "Filling the solid takes too long; simplify the mesh.";
    default:
        return "The surface has triangles too thin to be filled as a solid; remesh it.";
    }
}

/// Ten times the number for a body of 200,000 elements; about half a minute.
constexpr std::int64_t maximumChecks = 30'000'000;

} // namespace

std::mutex& tetGenTurn() {
    static std::mutex turn;
    return turn;
}

Result<LinearTetrahedra> runTetGen(const Mesh& surface, const TetGenSettings& settings) {
    std::unique_lock turn(tetGenTurn(), std::defer_lock);
    // Try again until cancelled, because another call may take half a minute. The thread sanitizer
    // does not know std::timed_mutex.
    while (!turn.try_lock()) {
        if (settings.cancelled != nullptr && settings.cancelled->load())
            return failure(sentence(TetGenStop::cancelled));
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    TetGenWatch::current() = {.cancelled = settings.cancelled, .checksLeft = maximumChecks};
    try {
        tetgenio input, output;
        tetgenbehavior behavior;
        copySurface(surface, input);
        configure(settings, behavior);
        fillOrThrow(input, behavior, output);
        return resultOf(output);
    } catch (int code) {
        return failure(sentence(code));
    } catch (TetGenStop stop) {
        return failure(sentence(stop));
    }
}

} // namespace idiophone
