#include "Object/OneLine.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("Printable text stays unchanged") {
    CHECK(oneLine("").empty());
    CHECK(oneLine("Bell, 'ü', 鐘, 🔔") == "Bell, 'ü', 鐘, 🔔");
    CHECK(inQuotes("bell") == "'bell'");
}

TEST_CASE("Control characters and invalid UTF-8 become question marks") {
    CHECK(oneLine(std::string_view("a\nb\tc\0d\x7f", 8)) == "a?b?c?d?");
    CHECK(oneLine("\xc2\x85") == "??");           // a control character beyond ASCII
    CHECK(oneLine("\xc3") == "?");                // cut off
    CHECK(oneLine("\xc3(") == "?(");              // not continued
    CHECK(oneLine("\xc0\xaf") == "??");           // overlong form
    CHECK(oneLine("\xe0\x80\xaf") == "???");      // overlong form
    CHECK(oneLine("\xed\xa0\x80") == "???");      // half of a surrogate pair
    CHECK(oneLine("\xf4\x90\x80\x80") == "????"); // beyond Unicode
    CHECK(oneLine("\xff\xfe") == "??");
    CHECK(oneLine("wav.\u202egpj") == "wav.???gpj"); // would show as wav.jpg
    CHECK(oneLine("\u2028\u2066") == "??????");
    CHECK(oneLine("\u2027\u202f\u2065\u206a") == "\u2027\u202f\u2065\u206a");
}

TEST_CASE("A long text is cut between characters") {
    CHECK(oneLine(std::string(100, 'x')) == std::string(100, 'x'));
    CHECK(oneLine(std::string(101, 'x')) == std::string(100, 'x') + "...");
    CHECK(oneLine(std::string(99, 'x') + "ü") == std::string(99, 'x') + "...");
    CHECK(inQuotes(std::string(1000, '\n')) == "'" + std::string(100, '?') + "...'");
}

TEST_CASE("Control characters are escaped, so that a terminal shows them") {
    CHECK(escaped("Bell\t'ü', 鐘, 🔔\n") == "Bell\t'ü', 鐘, 🔔\n");
    CHECK(escaped("\x1b[31mRED\x1b]0;title\x07\r") ==
          "\\u001b[31mRED\\u001b]0;title\\u0007\\u000d");
    CHECK(escaped(std::string_view("\0\x7f", 2)) == "\\u0000\\u007f");
    CHECK(escaped("\xc2\x9b") == "\\u009b");
    CHECK(escaped("wav.\u202egpj\u2069") == "wav.\\u202egpj\\u2069");
    CHECK(escaped("\xe2\x80") == "\xe2\\u0080");
    CHECK(escaped("\x9b") == "\\u009b"); // a control character for terminals that read bytes
    CHECK(escaped("\xe9t\xe9") == "\xe9t\xe9");
    CHECK(escaped("\xc2\xc2\x85") == "\xc2\\u0085");
    CHECK(escaped("\xc2\x1b") == "\xc2\\u001b");
}

TEST_CASE("An incomplete character at the end of a text is reported") {
    CHECK(unfinishedBytes("") == 0);
    CHECK(unfinishedBytes("ü") == 0);
    CHECK(unfinishedBytes("a\xc3") == 1);
    CHECK(unfinishedBytes("\xf0\x9f\x94") == 3);
    CHECK(unfinishedBytes("🔔") == 0);
    CHECK(unfinishedBytes("\x80\x80\x80\x80") == 0);
    CHECK(unfinishedBytes("\xff") == 0);
}
