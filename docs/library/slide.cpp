// Something scrapes or rolls to and fro over a modal object, for two seconds. A physics engine says
// where it touches, how fast it is and how hard it presses; both ears get what the whole object
// radiates to them.
//
//     slide scrape|roll OBJECT.modal SOUND.f32        (32-bit float, stereo, 48 kHz)
#include "Mesh/ShapeMesh.h"
#include "Mesh/SurfaceQuery.h"
#include "Object/ModalObjectFile.h"
#include "Synth/ContactForce.h"
#include "Synth/Synthesiser.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>

using namespace idiophone;

/// Where a contact in space touches the object, between the vertices that carry shapes. Its force
/// goes into the surface and drags it along x, the way that the contact moves.
ForcePoint
touch(const SurfaceQuery& surface, const Eigen::Vector3d& contactMetres, double speedAlongX) {
    constexpr float friction = 0.3f;
    const SurfacePoint place = surface.nearestPoint(contactMetres);
    ForcePoint touched;
    touched.direction = {std::copysign(friction, static_cast<float>(speedAlongX)), 0, 0};
    for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        touched.point.shapeRows[i] = surface.mesh().faces(place.face, k);
        touched.point.weights[i] = static_cast<float>(place.barycentric(k));
        touched.point.normal[i] = static_cast<float>(place.normal(k));
        touched.direction[i] -= touched.point.normal[i];
    }
    return touched;
}

int main(int count, char** arguments) {
    const std::string kind = count == 4 ? arguments[1] : "";
    if (kind != "scrape" && kind != "roll")
        return std::cerr << "slide scrape|roll OBJECT.modal SOUND.f32\n", 1;
    auto object = readModalObject(arguments[2]);
    if (!object)
        return std::cerr << object.error().message << '\n', 1;
    const SurfaceQuery surface(shapeMesh(*object));

    constexpr float gain = 300; // what is scraped moves by less than a millimetre a second
    constexpr double rateHz = 48000, lastContact = 2, reachMetres = 0.08, swingsHz = 2;
    Synthesiser synthesiser({{std::make_shared<const ModalObject>(std::move(*object))}}, rateHz, 2);
    synthesiser.setSettings({.radiation = 1}); // from afar, left and right
    const auto profile = std::make_shared<const SurfaceProfile>(Surface{}, rateHz, 1);
    ContactForce contact(profile, 1);
    contact.setSettings({.kind = kind == "roll" ? ContactKind::roll : ContactKind::scrape});

    std::ofstream sound(arguments[3], std::ios::binary);
    const double fastest = 2 * std::numbers::pi * swingsHz * reachMetres; // at the middle, m/s
    ForcePoint last = touch(surface, {0, 0.03, 0}, fastest);
    for (int cell = 1; cell <= 3 * rateHz / cellSamples; ++cell) {
        const double seconds = cell * cellSamples / rateHz; // at its end
        const double angle = 2 * std::numbers::pi * swingsHz * seconds;
        const double speed = fastest * std::cos(angle);
        const ForcePoint now = touch(surface, {reachMetres * std::sin(angle), 0.03, 0}, speed);

        std::array<float, cellSamples> left{}, right{}, newtons{};
        const CellOutput output(left, right);
        synthesiser.beginCell(output);
        if (contact.render(seconds < lastContact ? ContactMotion{speed, 2} : ContactMotion{},
                           newtons))
            synthesiser.applyForce(0, {.start = {{last}}, .end = {{now}}, .newtons = newtons},
                                   output);
        last = now;
        for (std::size_t k = 0; k < cellSamples; ++k)
            for (const float sample : {gain * left[k], gain * right[k]})
                sound.write(reinterpret_cast<const char*>(&sample), sizeof sample);
    }
    return sound ? 0 : 1;
}
