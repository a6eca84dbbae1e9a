// Protects the terminal from control characters in texts of files and of the command line.
#pragma once

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace idiophone {

/// While it exists, everything written to a stream is escaped (Object/OneLine.h). JSON stays
/// unchanged.
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
    std::string unfinished; ///< the beginning of a character written byte by byte
};

} // namespace idiophone
