#include "Analysis/PreviewAnalysis.h"
#include "Geometry/LengthUnit.h"
#include "Geometry/MeshReader.h"
#include <catch2/catch_test_macros.hpp>
#include <iostream>
#include <chrono>
#include <cmath>
using namespace idiophone;
TEST_CASE("measure", "[.measure]") {
    for (std::string f : {"ball","bar","box","ring","plate","hoop","teapot","frog_legs","extruder_idler","Prusa"}) {
        auto mesh = readMesh("/tmp/boot/s7/wa/m/" + f + (f == "Prusa" ? ".stl" : ".obj"));
        if (!mesh) { std::cout << mesh.error().message << "\n"; continue; }
        mesh->vertices *= guessLengthUnit(*mesh).unit.metresPerUnit;
        auto t0 = std::chrono::steady_clock::now();
        std::string steps;
        auto o = analysePreview(*mesh, {.name=f,.source=f,.material=*findMaterial("Steel")}, {.progress=[&](double, std::string_view s){
            const auto t = std::chrono::duration<double>(std::chrono::steady_clock::now()-t0).count();
            if (steps.find(s) == steps.npos) { steps += std::string(s)+"@"+std::to_string(t).substr(0,4)+" "; } }, .cancelled=nullptr});
        const auto t = std::chrono::duration<double>(std::chrono::steady_clock::now()-t0).count();
        std::cout << f << " faces " << mesh->faceCount() << ": " << t << " s ";
        if (o) std::cout << o->method << " V " << o->vertexCount() << " M " << o->modeCount() << " band " << o->bandHz << " lowest " << std::sqrt(o->eigenvalues[0])/6.2832;
        else std::cout << o.error().message;
        std::cout << " | " << steps << std::endl;
    }
}
