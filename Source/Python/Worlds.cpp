#include "Python/Binding.h"
#include "World/World.h"

#include <Eigen/Geometry>
#include <mutex>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>
#include <variant>

namespace idiophone::python {
namespace {

Eigen::Vector3d vectorOf(const Numbers3& numbers, const char* name) {
    return Eigen::Vector3d(valuesOf(numbers, name).data());
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

    /// Raises ValueError if the body does not exist.
    void checkBody(std::size_t body) const {
        if (body >= world->bodyCount())
            throw nb::value_error(("there is no body " + std::to_string(body) + ": the world has " +
                                   std::to_string(world->bodyCount()) + ", numbered from 0")
                                      .c_str());
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
               const Numbers3& positionMetres,
               const std::optional<Numbers<4>>& rotation) {
        checkBody(body);
        WorldPose pose{.originMetres = vectorOf(positionMetres, "the position")};
        if (rotation) {
            const Eigen::Quaterniond turn(valuesOf(*rotation, "the rotation").data());
            if (!(std::abs(turn.norm() - 1) < 1e-3))
                throw nb::value_error("the rotation is not a unit quaternion");
            pose.axes = turn.normalized().toRotationMatrix();
        }
        check(world->place(body, pose), "the position is not finite");
    }

    void listen(const Numbers3& positionMetres, const Numbers3& towardsMetres, const Numbers3& up) {
        check(world->placeListener({.positionMetres = vectorOf(positionMetres, "the position"),
                                    .towardsMetres = vectorOf(towardsMetres, "towards"),
                                    .up = vectorOf(up, "up")}),
              "the world has no listener, or a number is not finite");
    }

    void strike(std::size_t body,
                const Numbers3& impulseNewtonSeconds,
                const std::optional<Numbers3>& pointMetres,
                const std::optional<std::int64_t>& vertex,
                const std::optional<double>& seconds,
                double contactSeconds) {
        checkBody(body);
        if (pointMetres.has_value() == vertex.has_value())
            throw nb::value_error("a strike needs either a point or a vertex");
        check(world->strike({.body = body,
                             .seconds = seconds.value_or(0),
                             .vertex = vertex,
                             .pointMetres = pointMetres ? vectorOf(*pointMetres, "the point")
                                                        : Eigen::Vector3d::Zero(),
                             .impulseNewtonSeconds = vectorOf(impulseNewtonSeconds, "the impulse"),
                             .contactSeconds = contactSeconds}),
              vertex ? "the vertex carries no shapes, or a number is out of range"
                     : "a number is out of range");
    }

    std::size_t beginTouch() {
        const auto touch = world->beginTouch();
        if (!touch)
            throw nb::buffer_error("all touches are in use");
        return *touch;
    }
    void touch(std::size_t number,
               std::size_t body,
               const Numbers3& pointMetres,
               double forceNewtons,
               const Numbers3& slideMetresPerSecond,
               double rollMetresPerSecond,
               const std::optional<std::size_t>& other) {
        checkBody(body);
        checkBody(other.value_or(body));
        check(world->touch(number,
                           {.body = body,
                            .other = other,
                            .pointMetres = vectorOf(pointMetres, "the point"),
                            .forceNewtons = forceNewtons,
                            .slideMetresPerSecond = vectorOf(slideMetresPerSecond, "the slide"),
                            .rollMetresPerSecond = rollMetresPerSecond}),
              "the touch does not exist, or a number is not finite");
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
        checkBody(body);
        check(world->setMaterial(body,
                                 material ? std::optional(liveMaterial(*material)) : std::nullopt),
              "a figure of the material is out of range");
    }
    void setDamping(std::size_t body, double dampingPerSecond) {
        checkBody(body);
        check(world->setDamping(body, dampingPerSecond), "the rate is negative or not finite");
    }
    void setGain(double gain) { check(world->setGain(gain), "the gain is out of range"); }

    /// Returns [frames, 2] samples.
    auto render(std::size_t frames) {
        if (frames > std::size_t{1} << 32)
            throw nb::value_error("the number of frames is above 2^32");
        auto* samples = new float[2 * frames];
        const nb::capsule owner(samples,
                                [](void* data) noexcept { delete[] static_cast<float*>(data); });
        {
            const nb::gil_scoped_release unlocked;
            const std::lock_guard lock(rendering);
            std::array<float, 256> left, right;
            for (std::size_t done = 0; done < frames;) {
                const std::size_t count = std::min(frames - done, left.size());
                if (done > 0 && done % 65536 == 0) {
                    const nb::gil_scoped_acquire locked;
                    checkInterrupt();
                }
                world->render(std::span(left).first(count), std::span(right).first(count));
                for (std::size_t k = 0; k < count; ++k, ++done) {
                    samples[2 * done] = left[k];
                    samples[2 * done + 1] = right[k];
                }
            }
        }
        return nb::ndarray<nb::numpy, float, nb::shape<-1, 2>>(samples, {frames, 2}, owner);
    }

    bool silent() {
        const nb::gil_scoped_release unlocked;
        const std::lock_guard lock(rendering);
        return world->silent();
    }

    const World& played() const { return *world; }

private:
    std::mutex rendering; ///< the world has one audio thread; taken without the interpreter's lock
    std::unique_ptr<World> world;
};

} // namespace

void bindWorlds(nb::module_& module) {
    nb::class_<PythonWorld>(
        module, "World",
        "Bodies that are moved, struck and pressed, and the sound that a listener hears.\n\n"
        "`bodies` are modal objects, or pairs of an object and a size. They are numbered from 0 "
        "and stand at the origin. Without a `listener` everything is heard at the struck place. At "
        "most `events` calls wait for the next `render`; a further one raises BufferError. One "
        "thread may render while another says what happens. Positions are in m. A number out of "
        "range raises ValueError.")
        .def(nb::init<const std::vector<PythonWorld::Body>&, double, bool, std::size_t>(),
             nb::arg("bodies"), nb::kw_only(), nb::arg("sample_rate") = 48000.0,
             nb::arg("listener") = true, nb::arg("events") = 65536)
        .def_prop_ro(
            "seconds", [](const PythonWorld& self) { return self.played().seconds(); },
            "The world's clock: what has been rendered.")
        .def_prop_ro(
            "sample_rate", [](const PythonWorld& self) { return self.played().sampleRateHz(); },
            "In Hz.")
        .def_prop_ro("silent", &PythonWorld::silent, "Whether nothing sounds or waits.")
        .def_prop_ro(
            "impacts_left_out",
            [](const PythonWorld& self) { return self.played().impactsLeftOut(); },
            "Impacts that were too hard for their objects.")
        .def("place", &PythonWorld::place, nb::arg("body"), nb::arg("position"),
             nb::arg("rotation") = nb::none(),
             "Says where a body is: the origin of its object, and a rotation about it as a unit "
             "quaternion (x, y, z, w).")
        .def("listen", &PythonWorld::listen, nb::arg("position"), nb::arg("towards"),
             nb::arg("up") = Numbers3{{{0, 0, 1}}},
             "Says where the listener is, a point that it looks at, and a direction upwards.")
        .def("strike", &PythonWorld::strike, nb::arg("body"), nb::arg("impulse"),
             nb::arg("point") = nb::none(), nb::arg("vertex") = nb::none(),
             nb::arg("time") = nb::none(), nb::arg("contact_time") = 0.0,
             "Strikes a body by an impulse (N s), at a point or at a vertex of its object.\n\n"
             "`impulse` and `point` are in the world's axes; an impact into a surface points "
             "against its normal. `time` is by the world's clock; None, or a time that has passed, "
             "means at once. `contact_time` is in s, 0 to 1.")
        .def("begin_touch", &PythonWorld::beginTouch,
             "Takes one of 24 touches and returns its number. It sounds from the first `touch` "
             "until `end_touch`.")
        .def("touch", &PythonWorld::touch, nb::arg("touch"), nb::arg("body"), nb::arg("point"),
             nb::arg("force"), nb::arg("slide") = Numbers3{{{}}}, nb::arg("roll") = 0.0,
             nb::arg("other") = nb::none(),
             "Says how a body slides or rolls: the force (N), the velocity of the other surface "
             "past it and the speed of rolling (m/s). `other` is the body under it, which sounds "
             "too.")
        .def("end_touch", &PythonWorld::endTouch, nb::arg("touch"), "Ends a touch.")
        .def("set_quality", &PythonWorld::setQuality, nb::kw_only(), nb::arg("budget") = nb::none(),
             nb::arg("tau") = nb::none(), nb::arg("slope") = nb::none(),
             nb::arg("compression") = nb::none(),
             "Sets the mode budget, truncation, quality slope and compression of all bodies; None "
             "leaves one as it is.")
        .def("set_material", &PythonWorld::setMaterial, nb::arg("body"), nb::arg("material").none(),
             "Replaces the material of a body; None restores it.")
        .def("set_damping", &PythonWorld::setDamping, nb::arg("body"), nb::arg("rate"),
             "Damps a body further: its sound falls as exp(-rate t). 0: no more.")
        .def("set_gain", &PythonWorld::setGain, nb::arg("gain"),
             "Sets the gain of everything, 1 at first: full scale is 1 Pa, without a listener "
             "1 m/s.")
        .def("render", &PythonWorld::render, nb::arg("frames"),
             "Returns the next samples [frames, 2] of both ears, float32.");
}

} // namespace idiophone::python
