#include "Object/FileBeside.h"

#include "Object/FileBytes.h"
#include "Object/TextFile.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <iterator>
#include <string>

using namespace idiophone;
using test::emptyFolder;
namespace fs = std::filesystem;

namespace {

auto writing(std::string text) {
    return [text = std::move(text)](std::ostream& stream) { stream << text; };
}

void failing(std::ostream& stream) {
    stream << "half";
    stream.setstate(std::ios::failbit);
}

std::string textOf(const fs::path& file) {
    return readTextFile(file).value_or("none");
}

auto fileCount(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

} // namespace

TEST_CASE("A file is replaced completely or stays unchanged") {
    const auto folder = emptyFolder("replaced");
    const auto file = folder / "file";
    REQUIRE_FALSE(replaceFile(file, failing));
    CHECK(fileCount(folder) == 0);
    REQUIRE(replaceFile(file, writing("longer at first")));
    CHECK(textOf(file) == "longer at first");
    REQUIRE(replaceFile(file, writing("then short")));
    CHECK(textOf(file) == "then short");
    REQUIRE_FALSE(replaceFile(file, failing));
    CHECK(textOf(file) == "then short");
    CHECK(fileCount(folder) == 1);
    CHECK_FALSE(replaceFile(folder / "none" / "file", writing("x")));
    CHECK_FALSE(replaceFile(folder, writing("x")));
}

TEST_CASE("A file with the longest possible name is replaced") {
    const auto folder = emptyFolder("long");
#ifdef _WIN32
    const std::size_t longest = 259 - (folder.native().size() + 1); // of the whole path
#else
    const std::size_t longest = 255;
#endif
    for (const std::string& letter : {std::string("x"), std::string("\xe9\x9f\xb3")}) {
        std::string name;
        while (name.size() + letter.size() <= longest)
            name += letter;
        const auto file = folder / pathNamed(name);
        REQUIRE(replaceFile(file, writing("first")));
        REQUIRE(replaceFile(file, writing("second")));
        CHECK(textOf(file) == "second");
    }
    CHECK(fileCount(folder) == 2);
    CHECK_FALSE(replaceFile(folder / std::string(256, 'x'), writing("too long")));
}

TEST_CASE("A write-protected file is not replaced") {
    const auto folder = emptyFolder("protected");
    const auto file = folder / "file";
    REQUIRE(replaceFile(file, writing("kept")));
    fs::permissions(file, fs::perms::owner_read);
    CHECK_FALSE(makeFileBeside(file));
    CHECK_FALSE(replaceFile(file, writing("lost")));
    CHECK(textOf(file) == "kept");
    CHECK(fileCount(folder) == 1);
    fs::permissions(file, fs::perms::owner_all);
}

#ifndef _WIN32

TEST_CASE("A link to a missing file leads to the new file, and a link to itself is refused") {
    const auto folder = emptyFolder("dangling");
    fs::create_directory(folder / "there");
    fs::create_symlink("second", folder / "first");
    fs::create_symlink(fs::path("there") / "file", folder / "second");
    CHECK(behindLinks(folder / "first") == folder / "there" / "file");
    REQUIRE(replaceFile(folder / "first", writing("text")));
    CHECK(fs::is_symlink(folder / "first"));
    CHECK(textOf(folder / "there" / "file") == "text");
    fs::create_symlink("loop", folder / "loop");
    CHECK_FALSE(replaceFile(folder / "loop", writing("text")));
    CHECK(fs::is_symlink(folder / "loop"));
    CHECK(fileCount(folder) == 4);
}

TEST_CASE("A link's target is replaced, and the link is kept") {
    const auto folder = emptyFolder("linked");
    REQUIRE(replaceFile(folder / "file", writing("first")));
    fs::create_symlink("file", folder / "link");
    REQUIRE(replaceFile(folder / "link", writing("second")));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(textOf(folder / "file") == "second");
}

TEST_CASE("A device is written directly") {
    CHECK(replaceFile("/dev/null", writing("x")));
    CHECK_FALSE(fs::exists("/dev/null.1.part"));
    CHECK_FALSE(fs::is_regular_file("/dev/null"));
}

#endif
