#include "Object/FileName.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("Names of files have no letters that a system forbids, and never lead elsewhere") {
    CHECK(fileNameFrom("Bell No. 2") == "Bell No. 2");
    CHECK(fileNameFrom("a/b\\c:d\n") == "a_b_c_d_");
    CHECK(fileNameFrom("..") == "__");
    CHECK(fileNameFrom(".") == "_");
    CHECK(fileNameFrom("").empty());
}

TEST_CASE("Long names of files are cut between letters") {
    CHECK(fileNameFrom(std::string(200, 'x')) == std::string(200, 'x'));
    CHECK(fileNameFrom(std::string(500, 'x')) == std::string(200, 'x'));
    CHECK(fileNameFrom(std::string(199, 'x') + "\xc3\xa9") == std::string(199, 'x')); // é
}
