// Writes the C++ source of a function that returns files embedded in the program, in the order of
// their names.
//
//     embed_files FUNCTION LIST SOURCE
//
// LIST names one file a line. SOURCE defines `std::span<const EmbeddedFile> idiophone::FUNCTION()`.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

// Compilers read a literal ten times as fast as numbers, but MSVC bounds its length. MSVC needs
// time and memory for each number, so eight bytes are one.
#ifdef _MSC_VER
void writeBytes(std::ostream& out, std::string bytes) {
    bytes.resize((bytes.size() + 7) / 8 * 8);
    out << "alignas(16) static const unsigned long long words[] = {" << std::hex;
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, sizeof word);
        out << (i % 64 == 0 ? "\n0x" : "0x") << word << ',';
    }
    out << "};\nstatic const char* const bytes = reinterpret_cast<const char*>(words);\n";
}
#else
void writeBytes(std::ostream& out, const std::string& bytes) {
    out << "alignas(16) static const char bytes[] =";
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (i % 64 == 0)
            out << (i == 0 ? "\n\"" : "\"\n\"");
        const auto byte = static_cast<unsigned char>(bytes[i]);
        out << '\\' << (byte >> 6) << (byte >> 3 & 7) << (byte & 7);
    }
    out << "\";\n";
}
#endif

} // namespace

int main(int count, char** arguments) {
    if (count != 4)
        return 1;
    std::vector<std::filesystem::path> files;
    std::ifstream list(arguments[2]);
    for (std::string line; std::getline(list, line);)
        files.emplace_back(line);
    std::ranges::sort(files, {}, [](const auto& file) { return file.filename().string(); });

    std::string bytes, table;
    for (const auto& file : files) {
        std::ifstream in(file, std::ios::binary);
        bytes.resize((bytes.size() + 15) / 16 * 16); // aligned for any type
        const auto start = bytes.size();
        bytes.append(std::istreambuf_iterator<char>(in), {});
        if (!in) {
            std::cerr << file.string() << ": the file cannot be read\n";
            return 1;
        }
        table += "    {R\"name(" + file.filename().string() + ")name\", {bytes + " +
                 std::to_string(start) + ", " + std::to_string(bytes.size() - start) + "}},\n";
    }
    std::ofstream out(arguments[3], std::ios::binary);
    out << R"(#include "Object/EmbeddedFiles.h"

namespace idiophone {

)";
    writeBytes(out, bytes);
    out << "\nstd::span<const EmbeddedFile> " << arguments[1] << R"(() {
    static const EmbeddedFile files[] = {
)" << table
        << "    };\n    return files;\n}\n\n} // namespace idiophone\n";
    return out.flush() ? 0 : 1;
}
