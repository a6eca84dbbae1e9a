// What a terminal does not obey: texts of files and of the command line may hold anything.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace idiophone {

/// While it lives, what is written to a stream is escaped (Object/OneLine.h) on its way. JSON stays
/// what it is.
class TerminalText : std::streambuf {
public:
    explicit TerminalText(std::ostream& written);
    ~TerminalText() override;

private:
    int_type overflow(int_type character) override;
    std::streamsize xsputn(const char* text, std::streamsize count) override;
    int sync() override;

    bool pass(std::string_view text);

    std::ostream& stream;
    std::streambuf* terminal;
    std::string unfinished; ///< a character that is written byte by byte
};

} // namespace idiophone
