#include "Python/Binding.h"
#include "World/World.h"

#include <Eigen/Geometry>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

namespace idiophone::python {
namespace {

Eigen::Vector3d vectorOf(const Numbers3& numbers) {
    return Eigen::Vector3d(numbers.data());
}

class PythonWorld {
public:
    using Body = std::variant<PythonObject, std::pair<PythonObject, double>>;

    PythonWorld(const std::vector<Body>& bodies,
                double sampleRateHz,
                bool hasListener,
                std::size_t events) {
        std::vector<SynthesiserSlot> slots;
        for (const auto& body : bodies) {
            const auto* sized = std::get_if<std::pair<PythonObject, double>>(&body);
            slots.push_back(
                {.object = sized ? sized->first.object : std::get<PythonObject>(body).object,
                 .sizeRatio = sized ? sized->second : 1});
        }
        WorldSettings settings{.sampleRateHz = sampleRateHz, .eventCapacity = events};
        if (!hasListener) {
            settings.listener.reset();
            settings.synthesis.radiation = 0;
        }
        world = valueOf(World::make(std::move(slots), settings));
    }

    /// Raises an exception if the world did not do what it was told.
    static void check(WorldAnswer answer, const char* invalid) {
        if (answer == WorldAnswer::busy)
            throw nb::buffer_error(
                "too many calls wait: render first, or give the world more events");
        if (answer == WorldAnswer::invalid)
            throw nb::value_error(invalid);
    }

    void place(std::size_t body,
               const Numbers3& position,
               const std::optional<std::array<double, 4>>& rotation) {
        WorldPose pose{.originMetres = vectorOf(position)};
        if (rotation)
            pose.axes = Eigen::Quaterniond(rotation->data()).toRotationMatrix();
        check(world->place(body, pose), "the body does not exist, or its pose is out of range");
    }

    void listen(const Numbers3& position, const Numbers3& towards, const Numbers3& up) {
        check(world->placeListener({.positionMetres = vectorOf(position),
                                    .towardsMetres = vectorOf(towards),
                                    .up = vectorOf(up)}),
              "the world has no listener, or a number is not finite");
    }

    void strike(std::size_t body,
                const Numbers3& impulse,
                const std::optional<Numbers3>& point,
                const std::optional<std::int64_t>& vertex,
                const std::optional<double>& time,
                double contactTime) {
        check(world->strike({.body = body,
                             .seconds = time.value_or(0),
                             .vertex = vertex,
                             .pointMetres = vectorOf(point.value_or(Numbers3{})),
                             .impulseNewtonSeconds = vectorOf(impulse),
                             .contactSeconds = contactTime}),
              "the body or the vertex does not exist, or a number is out of range");
    }

    std::size_t beginTouch() {
        const auto touch = world->beginTouch();
        if (!touch)
            throw nb::buffer_error("all touches are in use");
        return *touch;
    }
    void touch(std::size_t number,
               std::size_t body,
               const Numbers3& point,
               double force,
               const Numbers3& slide,
               double roll,
               const std::optional<std::size_t>& other) {
        check(world->touch(number, {.body = body,
                                    .other = other,
                                    .pointMetres = vectorOf(point),
                                    .forceNewtons = force,
                                    .slideMetresPerSecond = vectorOf(slide),
                                    .rollMetresPerSecond = roll}),
              "the touch or the body does not exist, or a number is not finite");
    }
    void endTouch(std::size_t number) {
        check(world->endTouch(number), "the touch does not exist");
    }

    void setQuality(const std::optional<double>& budget,
                    const std::optional<double>& tau,
                    const std::optional<double>& slope,
                    const std::optional<double>& compression) {
        auto wanted = world->synthesis();
        wanted.modeBudget = budget.value_or(wanted.modeBudget);
        wanted.tau = tau.value_or(wanted.tau);
        wanted.qualitySlope = slope.value_or(wanted.qualitySlope);
        wanted.compression = compression.value_or(wanted.compression);
        check(world->setSynthesis(wanted), "a number is out of range");
    }
    void setMaterial(std::size_t body, const std::optional<Material>& material) {
        check(world->setMaterial(body,
                                 material ? std::optional(liveMaterial(*material)) : std::nullopt),
              "the body does not exist, or a figure is out of range");
    }
    void setDamping(std::size_t body, double rate) {
        check(world->setDamping(body, rate), "the body does not exist, or the rate is negative");
    }
    void setGain(double gain) { check(world->setGain(gain), "the gain is out of range"); }

    /// Returns [frames, 2] samples.
    auto render(std::size_t frames) {
        auto* samples = new float[2 * frames];
        const nb::capsule owner(samples,
                                [](void* data) noexcept { delete[] static_cast<float*>(data); });
        {
            const nb::gil_scoped_release unlocked;
            std::array<float, 256> left, right;
            for (std::size_t done = 0; done < frames;) {
                const std::size_t count = std::min(frames - done, left.size());
                world->render(std::span(left).first(count), std::span(right).first(count));
                for (std::size_t k = 0; k < count; ++k, ++done) {
                    samples[2 * done] = left[k];
                    samples[2 * done + 1] = right[k];
                }
            }
        }
        return nb::ndarray<nb::numpy, float, nb::shape<-1, 2>>(samples, {frames, 2}, owner);
    }

    const World& played() const { return *world; }

private:
    std::unique_ptr<World> world;
};

} // namespace

void bindWorlds(nb::module_& module) {
    nb::class_<PythonWorld>(
        module, "World",
        "Bodies that are moved, struck and pressed, and the sound that a listener hears.\n\n"
        "`bodies` are modal objects, or pairs of an object and a size. They are numbered from 0 "
        "and "
        "stand at the origin. Without a `listener` everything is heard at the struck place. At "
        "most "
        "`events` calls wait for the next `render`. One thread may render while another says what "
        "happens. Positions are in m. What is out of range raises ValueError.")
        .def(nb::init<const std::vector<PythonWorld::Body>&, double, bool, std::size_t>(),
             nb::arg("bodies"), nb::kw_only(), nb::arg("sample_rate") = 48000.0,
             nb::arg("listener") = true, nb::arg("events") = 65536)
        .def_prop_ro(
            "seconds", [](const PythonWorld& self) { return self.played().seconds(); },
            "The world's clock: what has been rendered.")
        .def_prop_ro("sample_rate",
                     [](const PythonWorld& self) { return self.played().sampleRateHz(); })
        .def_prop_ro(
            "silent", [](const PythonWorld& self) { return self.played().silent(); },
            "Whether nothing sounds or waits.")
        .def_prop_ro(
            "impacts_left_out",
            [](const PythonWorld& self) { return self.played().impactsLeftOut(); },
            "Impacts that were too hard for their objects.")
        .def("place", &PythonWorld::place, nb::arg("body"), nb::arg("position"),
             nb::arg("rotation") = nb::none(),
             "Says where a body is; the rotation is a unit quaternion (x, y, z, w).")
        .def("listen", &PythonWorld::listen, nb::arg("position"), nb::arg("towards"),
             nb::arg("up") = Numbers3{0, 0, 1}, "Says where the listener is and looks.")
        .def("strike", &PythonWorld::strike, nb::arg("body"), nb::arg("impulse"),
             nb::arg("point") = nb::none(), nb::arg("vertex") = nb::none(),
             nb::arg("time") = nb::none(), nb::arg("contact_time") = 0.0,
             "Strikes a body by an impulse (N s) at a point of the world or a vertex of its "
             "object.\n\n"
             "`time` is by the world's clock; None, or a time that has passed, means at once. "
             "`contact_time` is in s.")
        .def("begin_touch", &PythonWorld::beginTouch, "Takes one of 24 touches.")
        .def("touch", &PythonWorld::touch, nb::arg("touch"), nb::arg("body"), nb::arg("point"),
             nb::arg("force"), nb::arg("slide") = Numbers3{}, nb::arg("roll") = 0.0,
             nb::arg("other") = nb::none(),
             "Says how a body slides or rolls: the force (N), the velocity of the other surface "
             "past "
             "it and the speed of rolling (m/s).")
        .def("end_touch", &PythonWorld::endTouch, nb::arg("touch"))
        .def("set_quality", &PythonWorld::setQuality, nb::kw_only(), nb::arg("budget") = nb::none(),
             nb::arg("tau") = nb::none(), nb::arg("slope") = nb::none(),
             nb::arg("compression") = nb::none(),
             "Sets the mode budget, truncation, quality slope and compression; None leaves one.")
        .def("set_material", &PythonWorld::setMaterial, nb::arg("body"), nb::arg("material").none(),
             "Replaces the material of a body; None restores it.")
        .def("set_damping", &PythonWorld::setDamping, nb::arg("body"), nb::arg("rate"),
             "Damps a body further: its sound falls as exp(-rate t). 0: no more.")
        .def("set_gain", &PythonWorld::setGain, nb::arg("gain"))
        .def("render", &PythonWorld::render, nb::arg("frames"),
             "Returns the next samples [frames, 2] of both ears, float32.");
}

} // namespace idiophone::python
