#include "HostileMeshes.h"

#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"
#include "Support/GeneratedMeshes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace idiophone::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Random numbers that are the same with every standard library, unlike its distributions.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    double uniform() { return static_cast<double>(engine_()) / 4294967296.0; }
    double between(double low, double high) { return low + (high - low) * uniform(); }
    double decades(double low, double high) { return std::pow(10.0, between(low, high)); }
    int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    int from(int low, int high) { return low + below(high - low + 1); }
    bool oneIn(int count) { return below(count) == 0; }
    Eigen::RowVector3d offset(double amount) {
        const double x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
        return amount * Eigen::RowVector3d(x, y, z);
    }

private:
    std::mt19937 engine_;
};

Mesh scaled(Mesh mesh, double factor) {
    mesh.vertices *= factor;
    return mesh;
}

Mesh shaken(Mesh mesh, Dice& dice, double amount) {
    for (auto vertex : mesh.vertices.rowwise())
        vertex += dice.offset(amount);
    return mesh;
}

Mesh meshOf(const std::vector<Eigen::RowVector3d>& points,
            const std::vector<Eigen::RowVector3i>& faces) {
    Mesh mesh{Eigen::MatrixXd(points.size(), 3), Eigen::MatrixXi(faces.size(), 3)};
    for (std::size_t i = 0; i < points.size(); ++i)
        mesh.vertices.row(static_cast<Eigen::Index>(i)) = points[i];
    for (std::size_t i = 0; i < faces.size(); ++i)
        mesh.faces.row(static_cast<Eigen::Index>(i)) = faces[i];
    return mesh;
}

/// A closed body of about 0.1 m.
Mesh plainBody(Dice& dice) {
    switch (dice.below(6)) {
    case 0:
        return boxMesh({0.2, 0.1, 0.05}, {dice.from(1, 5), dice.from(1, 4), dice.from(1, 3)});
    case 1:
        return icosphereMesh(0.1, dice.from(0, 2));
    case 2:
        return torusMesh(0.1, 0.03, 2 * dice.from(3, 9), dice.from(3, 7));
    case 3:
        return extrudedMesh(discMesh(0.1, dice.from(1, 4)), dice.decades(-3, -1), dice.from(1, 2));
    case 4:
        return hollowSphereMesh(0.1, dice.decades(-4, -1.2), dice.from(0, 1));
    default:
        return extrudedMesh(annulusMesh(0.05, 0.1, dice.from(6, 20), dice.from(1, 2)), 0.02);
    }
}

Mesh soup(Dice& dice) {
    const int vertices = dice.from(3, 60), faces = dice.from(1, 150);
    Mesh mesh{Eigen::MatrixXd(vertices, 3), Eigen::MatrixXi(faces, 3)};
    const double step = dice.oneIn(2) ? 0.25 : 0;
    for (double& coordinate : mesh.vertices.reshaped()) {
        coordinate = dice.uniform();
        if (step > 0)
            coordinate = std::round(coordinate / step) * step;
    }
    for (int& vertex : mesh.faces.reshaped())
        vertex = dice.below(vertices);
    return scaled(mesh, 0.2);
}

/// A prism whose sides are cut along diagonals that twist inwards. With three sides it is
/// Schönhardt's polyhedron, which tetrahedra cannot fill without extra points.
Mesh twistedPrism(Dice& dice) {
    const int sides = dice.from(3, 24);
    const double twist = dice.oneIn(3) ? pi / sides * dice.uniform() : pi / 2 / sides,
                 height = dice.decades(-2.5, -0.3);
    std::vector<Eigen::RowVector3d> points;
    for (const double level : {0.0, 1.0})
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * pi * i / sides + level * twist;
            points.emplace_back(0.1 * std::cos(angle), 0.1 * std::sin(angle), level * height);
        }
    std::vector<Eigen::RowVector3i> faces;
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        faces.emplace_back(i, next, sides + i);
        faces.emplace_back(next, sides + next, sides + i);
    }
    for (int i = 1; i + 1 < sides; ++i) {
        faces.emplace_back(0, i + 1, i);
        faces.emplace_back(sides, sides + i, sides + i + 1);
    }
    return meshOf(points, faces);
}

/// Randomly filled cubes of a lattice: tunnels, hollows, edges of four faces, cospherical points.
Mesh voxels(Dice& dice) {
    const int n = dice.from(2, 4);
    const double share = dice.between(0.2, 0.9);
    std::vector<char> filled(static_cast<std::size_t>(n * n * n));
    for (char& cell : filled)
        cell = dice.uniform() < share ? 1 : 0;
    const auto isFilled = [&](const Eigen::Vector3i& c) {
        return (c.array() >= 0).all() && (c.array() < n).all() &&
               filled[static_cast<std::size_t>((c.z() * n + c.y()) * n + c.x())] != 0;
    };
    std::map<std::array<int, 3>, int> numbers;
    std::vector<Eigen::RowVector3d> points;
    std::vector<Eigen::RowVector3i> faces;
    const auto vertex = [&](const Eigen::Vector3i& c) {
        const auto [place, isNew] =
            numbers.try_emplace({c.x(), c.y(), c.z()}, static_cast<int>(points.size()));
        if (isNew)
            points.emplace_back(0.05 * c.cast<double>().transpose());
        return place->second;
    };
    for (int i = 0; i < n * n * n; ++i)
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) {
                const Eigen::Vector3i cell(i % n, i / n % n, i / n / n);
                const Eigen::Vector3i out = Eigen::Vector3i::Unit(axis);
                if (!isFilled(cell) || isFilled(cell + (2 * side - 1) * out))
                    continue;
                const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3),
                                      v = Eigen::Vector3i::Unit((axis + 2) % 3),
                                      corner = cell + side * out;
                const int a = vertex(corner), b = vertex(corner + u), c = vertex(corner + u + v),
                          d = vertex(corner + v);
                faces.emplace_back(a, side == 1 ? b : c, side == 1 ? c : b);
                faces.emplace_back(a, side == 1 ? c : d, side == 1 ? d : c);
            }
    if (faces.empty())
        return boxMesh({0.1, 0.1, 0.1}, {2, 2, 2});
    return meshOf(points, faces);
}

/// A ball with one face cut into three, one of those again, and so on towards a corner.
Mesh graded(Dice& dice) {
    Mesh mesh = icosphereMesh(0.1, dice.from(0, 1));
    const int rounds = dice.from(5, 40);
    const double share = dice.between(0.05, 0.5);
    for (int round = 0; round < rounds; ++round) {
        const int face = dice.oneIn(4) ? dice.below(static_cast<int>(mesh.faceCount())) : 0;
        const Eigen::RowVector3i f = mesh.faces.row(face);
        const int fresh = static_cast<int>(mesh.vertexCount());
        mesh.vertices.conservativeResize(fresh + 1, Eigen::NoChange);
        mesh.vertices.row(fresh) = (1 - share) * mesh.vertices.row(f(0)) +
                                   share / 2 * (mesh.vertices.row(f(1)) + mesh.vertices.row(f(2)));
        const auto last = mesh.faceCount();
        mesh.faces.conservativeResize(last + 2, Eigen::NoChange);
        mesh.faces.row(face) << f(0), f(1), fresh;
        mesh.faces.row(last) << f(1), f(2), fresh;
        mesh.faces.row(last + 1) << f(2), f(0), fresh;
    }
    return mesh;
}

/// Two bodies that almost touch, touch, lie one in the other, or coincide.
Mesh twoBodies(Dice& dice) {
    const Mesh first = plainBody(dice);
    const double gap = (dice.oneIn(4) ? 0 : 1) * dice.decades(-14, -3);
    const Eigen::RowVector3d extent =
        first.vertices.colwise().maxCoeff() - first.vertices.colwise().minCoeff();
    switch (dice.below(6)) {
    case 0:
        return joined(first, moved(first, Eigen::RowVector3d(extent.x() + gap, 0, 0)));
    case 1:
        return joined(first, scaled(first, 1 - gap));
    case 2:
        return joined(first, insideOut(scaled(first, 1 - std::max(gap, 1e-6))));
    case 3:
        return joined(first, moved(scaled(plainBody(dice), dice.decades(-6, 0)), extent));
    case 4:
        return joined(first, moved(plainBody(dice), dice.offset(0.1)));
    default:
        return joined(first, moved(scaled(icosphereMesh(0.1, 1), dice.decades(-3, -1)),
                                   Eigen::RowVector3d(0, 0, extent.z() / 2 - gap)));
    }
}

/// A ball with random radii; it never intersects itself.
Mesh star(Dice& dice) {
    Mesh mesh = icosphereMesh(1, dice.from(0, 2));
    const double wildness = dice.between(0, 3);
    for (auto vertex : mesh.vertices.rowwise())
        vertex *= 0.1 * dice.decades(-wildness, 0);
    return mesh;
}

Mesh spiked(Dice& dice) {
    Mesh mesh = plainBody(dice);
    for (int spikes = dice.from(1, 4); spikes > 0; --spikes) {
        const int vertex = dice.below(static_cast<int>(mesh.vertexCount()));
        mesh.vertices.row(vertex) *= dice.decades(0, 6);
    }
    return mesh;
}

/// Slabs side by side on a common back, with slots down to the limit of double precision.
Mesh comb(Dice& dice) {
    const int teeth = dice.from(2, 6);
    const double slot = dice.decades(-13, -2), tooth = 0.02, depth = 0.1, back = 0.02;
    std::vector<Eigen::RowVector2d> outline{{0, 0}};
    for (int i = 0; i < teeth; ++i) {
        const double left = i * (tooth + slot);
        if (i > 0)
            outline.insert(outline.end(), {{left - slot, back}, {left, back}});
        outline.insert(outline.end(), {{left, depth}, {left + tooth, depth}});
    }
    outline.emplace_back((teeth - 1) * (tooth + slot) + tooth, 0);
    // The outline is flat below, so its polygon is a fan of strips from the lower side.
    const int n = static_cast<int>(outline.size());
    std::vector<Eigen::RowVector3d> points;
    for (const double z : {0.0, 0.02})
        for (const auto& p : outline)
            points.emplace_back(p.x(), p.y(), z);
    std::vector<Eigen::RowVector3i> faces;
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        faces.emplace_back(i, i + n, next);
        faces.emplace_back(next, i + n, next + n);
    }
    for (const int level : {0, n}) {
        const auto cap = [&](int a, int b, int c) {
            faces.emplace_back(level + a, level + (level == 0 ? b : c),
                               level + (level == 0 ? c : b));
        };
        for (int i = 0; i < teeth; ++i) {
            const int first = i == 0 ? 0 : 4 * i; // the tooth's lower left corner in the outline
            const int left = i == 0 ? 1 : first, top = i == 0 ? 1 : first + 1;
            const int right = i + 1 == teeth ? n - 1 : 4 * i + 3;
            if (i == 0) {
                cap(0, top, top + 1);
                cap(0, top + 1, right);
            } else {
                cap(left, top, top + 1);
                cap(left, top + 1, right);
                cap(0, 4 * i - 1, left);
                cap(0, left, right);
            }
        }
    }
    return meshOf(points, faces);
}

/// A knife's edge: a triangular prism whose angle goes down to zero.
Mesh wedge(Dice& dice) {
    Mesh mesh = boxMesh({0.2, 0.1, 0.05}, {dice.from(1, 6), dice.from(1, 3), 1});
    const double edge = (dice.oneIn(3) ? 0 : 1) * dice.decades(-12, -2);
    for (auto vertex : mesh.vertices.rowwise())
        vertex.z() *= (vertex.y() + 0.05) / 0.1 + edge;
    return mesh;
}

/// A body with random vertices merged.
Mesh pinched(Dice& dice) {
    Mesh mesh = plainBody(dice);
    const auto count = static_cast<int>(mesh.vertexCount());
    for (int pinches = dice.from(1, 4); pinches > 0; --pinches) {
        const int kept = dice.below(count), gone = dice.below(count);
        for (int& vertex : mesh.faces.reshaped())
            vertex = vertex == gone ? kept : vertex;
    }
    return mesh;
}

Mesh bunch(Dice& dice) {
    const Mesh body = plainBody(dice);
    const int members = dice.from(2, 5);
    Mesh all = body;
    for (int i = 1; i < members; ++i) {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(2 * pi * i / members, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        Mesh next = body;
        next.vertices = ((body.vertices.rowwise() - body.vertices.row(0)) * turn).rowwise() +
                        body.vertices.row(0);
        all = joined(all, next);
    }
    return all;
}

Mesh smallBottle(Dice& dice) {
    const int around = dice.from(4, 16), across = dice.from(4, 10);
    return scaled(kleinBottle(around, across), 0.05);
}

/// A sheet folded back and forth; its layers coincide if the folds are flat.
Mesh folded(Dice& dice) {
    Mesh mesh = sheetMesh(0.2, 0.1, dice.from(10, 120));
    const double width = dice.between(0.01, 0.06), lift = dice.decades(-14, -2);
    for (auto vertex : mesh.vertices.rowwise()) {
        const double x = vertex.x() + 0.1, fold = std::floor(x / width);
        const double within = x - fold * width;
        vertex.x() = std::fmod(fold, 2) == 0 ? within : width - within;
        vertex.z() = fold * (dice.oneIn(50) ? 0 : lift);
    }
    return mesh;
}

Mesh fan(Dice& dice) {
    const int around = dice.from(3, 200);
    std::vector<Eigen::RowVector3d> points{{0, 0, dice.decades(-8, 0)}, {0, 0, 0}};
    std::vector<Eigen::RowVector3i> faces;
    for (int i = 0; i < around; ++i) {
        const double angle = 2 * pi * i / around;
        points.emplace_back(0.1 * std::cos(angle), 0.1 * std::sin(angle), 0);
        faces.emplace_back(0, i + 2, (i + 1) % around + 2);
        faces.emplace_back(1, (i + 1) % around + 2, i + 2);
    }
    return meshOf(points, faces);
}

struct Family {
    const char* name;
    Mesh (*make)(Dice&);
};

constexpr std::array<Family, 17> families{{{"body", plainBody},
                                           {"soup", soup},
                                           {"twisted prism", twistedPrism},
                                           {"voxels", voxels},
                                           {"graded ball", graded},
                                           {"two bodies", twoBodies},
                                           {"two bodies more", twoBodies},
                                           {"star", star},
                                           {"spiked body", spiked},
                                           {"comb", comb},
                                           {"wedge", wedge},
                                           {"pinched body", pinched},
                                           {"bunch", bunch},
                                           {"Klein bottle", smallBottle},
                                           {"folded sheet", folded},
                                           {"fan", fan},
                                           {"body again", plainBody}}};

Mesh turned(Mesh mesh, Dice& dice) {
    const Eigen::Vector3d axis = (dice.offset(1).transpose() + Eigen::Vector3d(0, 0, 1e-3));
    mesh.vertices *= Eigen::AngleAxisd(dice.between(0, 6), axis.normalized()).toRotationMatrix();
    return mesh;
}

Mesh withHoles(Mesh mesh, Dice& dice) {
    Eigen::Index kept = 1;
    for (Eigen::Index face = 1; face < mesh.faceCount(); ++face)
        if (!dice.oneIn(6))
            mesh.faces.row(kept++) = mesh.faces.row(face).eval();
    mesh.faces.conservativeResize(kept, Eigen::NoChange);
    return mesh;
}

/// Applies a random kind of damage and adds it to the name.
void spoil(HostileMesh& result, Dice& dice) {
    Mesh& mesh = result.mesh;
    const auto note = [&](const char* what) { result.name += std::string(", ") + what; };
    switch (dice.below(16)) {
    case 0:
        note("shaken");
        mesh = shaken(mesh, dice, dice.decades(-3, -0.8));
        break;
    case 1:
        note("shaken a hair");
        mesh = shaken(mesh, dice, dice.decades(-17, -4));
        break;
    case 2:
        note("turned and rounded to floats");
        mesh = turned(mesh, dice);
        mesh.vertices = mesh.vertices.cast<float>().cast<double>().eval();
        break;
    case 3:
        note("flattened");
        mesh.vertices.col(dice.below(3)) *= (dice.oneIn(4) ? 0 : 1) * dice.decades(-14, -1);
        break;
    case 4:
        note("flattened and turned");
        mesh.vertices.col(dice.below(3)) *= (dice.oneIn(4) ? 0 : 1) * dice.decades(-14, -1);
        mesh = turned(mesh, dice);
        break;
    case 5:
        note("with holes");
        mesh = withHoles(mesh, dice);
        break;
    case 6:
        note("as soup");
        mesh = soupOf(mesh);
        break;
    case 7:
        note("turned over at random");
        for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
            if (dice.oneIn(2))
                std::swap(mesh.faces(face, 0), mesh.faces(face, 1));
        break;
    case 8:
        note("of another size");
        mesh = scaled(mesh, dice.decades(-30, 30));
        break;
    case 9:
        note("not finite");
        mesh.vertices(dice.below(static_cast<int>(mesh.vertexCount())), dice.below(3)) =
            dice.oneIn(2) ? std::numeric_limits<double>::quiet_NaN()
                          : -std::numeric_limits<double>::infinity();
        break;
    case 10:
        note("far away");
        mesh = moved(mesh, dice.offset(dice.decades(0, 9)));
        break;
    case 11:
        note("sheared");
        mesh.vertices.col(0) += dice.decades(0, 8) * mesh.vertices.col(2);
        break;
    case 12:
        note("a little smaller or larger");
        mesh = scaled(mesh, dice.decades(-2.5, 2));
        break;
    default:
        break;
    }
}

} // namespace

HostileMesh hostileMesh(std::uint32_t seed) {
    Dice dice(seed);
    const auto& family = families[static_cast<std::size_t>(dice.below(families.size()))];
    HostileMesh result{family.name, family.make(dice)};
    spoil(result, dice);
    if (dice.oneIn(6))
        spoil(result, dice);
    return result;
}

} // namespace idiophone::test
