// Writes the matrices of a model for eigensolver.py, which compares our solver with SciPy. `solve`
// runs in a process of its own, so that time and memory are the solver's alone.
//
//     eigensolver_benchmark write shell|tetrahedra ROWS MODES FOLDER
//     eigensolver_benchmark solve FOLDER
//
// FOLDER gets stiffness.* and mass.* (lower triangles by compressed columns: starts and rows as
// int32, values as float64) and band.txt: rows, rows per vertex, lowest and highest Hz. `solve`
// writes eigenvalues.f64 and prints one line of JSON.
#include "Analysis/Eigensolver.h"
#include "Analysis/ElasticLaw.h"
#include "Analysis/QuadraticTetrahedra.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/ParametricMesh.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <vector>

using namespace idiophone;
using Matrix = Eigen::SparseMatrix<double>;
namespace fs = std::filesystem;

namespace {

template <class T>
void writeRaw(const fs::path& file, const T* values, std::size_t count) {
    std::ofstream out(file, std::ios::binary);
    out.write(reinterpret_cast<const char*>(values),
              static_cast<std::streamsize>(count * sizeof(T)));
    if (!out)
        throw std::runtime_error("Cannot write " + file.string() + ".");
}

template <class T>
std::vector<T> readRaw(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::vector<T> values(in ? fs::file_size(file) / sizeof(T) : 0);
    in.read(reinterpret_cast<char*>(values.data()),
            static_cast<std::streamsize>(values.size() * sizeof(T)));
    if (!in)
        throw std::runtime_error("Cannot read " + file.string() + ".");
    return values;
}

void writeMatrix(const fs::path& folder, const std::string& name, Matrix matrix) {
    matrix.makeCompressed();
    const auto entries = static_cast<std::size_t>(matrix.nonZeros());
    writeRaw(folder / (name + ".starts"), matrix.outerIndexPtr(),
             static_cast<std::size_t>(matrix.cols()) + 1);
    writeRaw(folder / (name + ".rows"), matrix.innerIndexPtr(), entries);
    writeRaw(folder / (name + ".values"), matrix.valuePtr(), entries);
}

Matrix readMatrix(const fs::path& folder, const std::string& name) {
    const auto starts = readRaw<int>(folder / (name + ".starts"));
    const auto rows = readRaw<int>(folder / (name + ".rows"));
    const auto values = readRaw<double>(folder / (name + ".values"));
    const auto n = static_cast<Eigen::Index>(starts.size()) - 1;
    return Eigen::Map<const Matrix>(n, n, static_cast<Eigen::Index>(values.size()), starts.data(),
                                    rows.data(), values.data());
}

Material wood() {
    Material material;
    material.youngsModulusPa = 20e9;
    material.densityKgPerM3 = 1000;
    material.poissonRatio = 0.25;
    return material;
}

/// Returns the model of a solid bar of 0.4 × 0.05 × 0.02 m, divided until it has about `rows` rows.
VibrationModel tetrahedra(Eigen::Index rows) {
    const auto box = boxMesh({0.4, 0.05, 0.02}, {8, 1, 1});
    double edge = 0.03;
    for (int attempt = 0;; ++attempt) {
        const auto mesh = tetrahedralise(box, {.targetEdgeMetres = edge, .keepSurface = false});
        if (!mesh)
            throw std::runtime_error(mesh.error().message);
        const double share =
            3.0 * static_cast<double>(mesh->nodes.rows()) / static_cast<double>(rows);
        if (attempt == 12 || std::abs(share - 1) < 0.05)
            return quadraticTetrahedra(*mesh, elasticLaw(wood()), wood().densityKgPerM3);
        edge *= std::pow(share, 0.3);
    }
}

VibrationModel modelOf(const std::string& kind, Eigen::Index rows) {
    if (kind == "tetrahedra")
        return tetrahedra(rows);
    if (kind == "shell")
        return twoLayerShell(sheetMesh(0.4, 0.3, static_cast<int>(rows / 6)), wood(), 0.008);
    throw std::runtime_error("There is no model \"" + kind + "\".");
}

/// Returns a frequency with `modes` modes below it, including zero modes. If modes are closer than
/// a millionth, the number may be larger.
double frequencyAbove(const VibrationModel& model, Eigen::Index modes) {
    double low = 20, high = 1e6;
    while (high / low > 1 + 1e-6) {
        const double middle = std::sqrt(low * high);
        const auto count = countModesBelow(model, middle);
        if (!count)
            throw std::runtime_error(count.error().message);
        if (*count == modes)
            return middle;
        (*count < modes ? low : high) = middle;
    }
    return high;
}

void write(const std::string& kind, Eigen::Index rows, Eigen::Index modes, const fs::path& folder) {
    const auto model = modelOf(kind, rows);
    fs::create_directories(folder);
    writeMatrix(folder, "stiffness", model.stiffness);
    writeMatrix(folder, "mass", model.mass);
    std::ofstream band(folder / "band.txt");
    band.precision(std::numeric_limits<double>::max_digits10);
    band << model.stiffness.rows() << ' ' << model.rowsPerVertex << " 20 "
         << frequencyAbove(model, modes) << '\n';
    if (!band.flush())
        throw std::runtime_error("Cannot write " + (folder / "band.txt").string() + ".");
}

double processorSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peakMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

void solve(const fs::path& folder) {
    const double startMegabytes = peakMegabytes();
    VibrationModel model{.stiffness = readMatrix(folder, "stiffness"),
                         .mass = readMatrix(folder, "mass")};
    FrequencyBand band;
    band.threads = 1; // as SciPy
    Eigen::Index rows = 0;
    std::ifstream(folder / "band.txt") >> rows >> model.rowsPerVertex >> band.lowestHz >>
        band.highestHz;
    const auto start = std::chrono::steady_clock::now();
    const double startProcessor = processorSeconds();
    const auto modes = solveModes(model, band);
    const double processor = processorSeconds() - startProcessor;
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    if (!modes)
        throw std::runtime_error(modes.error().message);
    writeRaw(folder / "eigenvalues.f64", modes->eigenvalues.data(),
             static_cast<std::size_t>(modes->eigenvalues.size()));
    std::cout << "{\"rows\": " << rows << ", \"modes\": " << modes->eigenvalues.size()
              << ", \"zero_modes\": " << modes->zeroModes << ", \"wall_s\": " << wall.count()
              << ", \"processor_s\": " << processor
              << ", \"megabytes\": " << peakMegabytes() - startMegabytes << "}\n";
}

} // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    try {
        if (words.size() == 5 && words[0] == "write")
            write(words[1], std::stoi(words[2]), std::stoi(words[3]), words[4]);
        else if (words.size() == 2 && words[0] == "solve")
            solve(words[1]);
        else
            throw std::runtime_error("usage: eigensolver_benchmark write shell|tetrahedra ROWS "
                                     "MODES FOLDER | solve FOLDER");
    } catch (const std::exception& fault) {
        std::cerr << fault.what() << '\n';
        return 1;
    }
}
