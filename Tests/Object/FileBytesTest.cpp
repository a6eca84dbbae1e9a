#include "Object/FileBytes.h"
#include "Object/ModalObjectFile.h"
#include "Object/TextFile.h"
#include "Support/TestFolder.h"

#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <fstream>
#include <future>
#if !defined(_WIN32)
#include <sys/stat.h>
#endif

using namespace idiophone;

TEST_CASE("A file's bytes are read completely, or the error says what is wrong") {
    const auto file = test::testFolder() / "bytes.bin";
    const std::string bytes("a\0\r\nb", 5);
    std::ofstream(file, std::ios::binary) << bytes;
    CHECK(readBytes(file, 5) == bytes);
    CHECK(readBytes(file, 4).error().message == "it is larger than 4 bytes");
    CHECK(readBytes(test::testFolder(), 4).error().message == "it is a directory");
    CHECK(readBytes(test::testFolder() / "none", 4).error().message == "the file cannot be opened");
    std::ofstream(file, std::ios::binary) << std::string((1 << 20) + 1, 'x');
    CHECK(readBytes(file, 1 << 20).error().message == "it is larger than 1 MiB");
    CHECK(readBytes(file, 3 << 10).error().message == "it is larger than 3 KiB");
}

#if !defined(_WIN32)
TEST_CASE("A pipe without a writer does not block the reader") {
    const auto pipe = test::testFolder() / "pipe";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    auto reading = std::async(std::launch::async, [&] { return readBytes(pipe, 4); });
    // The time limit only ends a failing test.
    const bool ended = reading.wait_for(std::chrono::seconds(60)) == std::future_status::ready;
    if (!ended)
        std::ofstream{pipe};
    CHECK(ended);
    CHECK(reading.get().error().message == "the file cannot be opened");
}
#endif

TEST_CASE("Stored names are UTF-8 with forward slashes and lead back to the file") {
    const auto path = std::filesystem::path(u8"Glöckchen") / u8"γ" / "60.modal";
    CHECK(storedNameOf(path) == "Gl\xc3\xb6"
                                "ckchen/\xce\xb3/60.modal");
    CHECK(pathNamed(storedNameOf(path)) == path);
    CHECK(pathNamed("").empty());
}

TEST_CASE("Network names of Windows are recognised, and changed only on Windows") {
    for (const auto* name :
         {"\\\\host\\share\\x.modal", "//host/share/x.modal", "/\\host\\x", "\\/host/x",
          "//?/UNC/host/share/x", "\\??\\UNC\\host\\x", "///x", "//"}) {
        INFO(name);
        CHECK(isNetworkName(name));
    }
    for (const auto* name : {"", "/", "/home/x.modal", "\\x", "Objects//x.modal", "C:\\\\x", "../x",
                             "/??", "?//x", "/?/x/y"}) {
        INFO(name);
        CHECK_FALSE(isNetworkName(name));
        CHECK(localName(name) == name);
    }
#if defined(_WIN32)
    CHECK(leadsIntoNetwork("//host/x"));
    CHECK(localName("\\\\host\\x") == "host\\x");
    CHECK(localName("\\??\\UNC\\x") == "UNC\\x");
    CHECK(localName("//").empty());
#else
    CHECK_FALSE(leadsIntoNetwork("//host/x"));
    CHECK(localName("//host/x") == "//host/x");
#endif
}

TEST_CASE("A file's name is returned in UTF-8") {
    CHECK(nameOf(std::filesystem::path(u8"Glöckchen/γ.obj").filename()) == "\xce\xb3.obj");
}

TEST_CASE("A file's name in a sentence is printable and limited in length") {
    CHECK(shownNameOf(std::filesystem::path(u8"Glöckchen")) == "Gl\xc3\xb6"
                                                               "ckchen");
    CHECK(shownName("\x1b]0;a\n.modal") == "?]0;a?.modal");
    CHECK(shownName(std::string(300, 'x')) == std::string(300, 'x'));
    CHECK(shownName(std::string(1 << 20, 'x')).size() < 1000);
    CHECK(readTextFile(std::string(3000, 'x')).error().message.size() < 1000);
    CHECK(readModalObject(std::string(3000, 'x')).error().message.size() < 1000);
    CHECK(readModalObject(std::span<const std::byte>(), "\x1b[31m").error().message.front() == '?');
}
