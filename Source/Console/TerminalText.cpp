#include "Console/TerminalText.h"

#include "Object/OneLine.h"

#include <utility>

namespace idiophone {

TerminalText::TerminalText(std::ostream& written)
    : stream(written), terminal(written.rdbuf(this)) {}

TerminalText::~TerminalText() {
    pass(unfinished);
    stream.rdbuf(terminal);
}

bool TerminalText::pass(std::string_view text) {
    const auto shown = escaped(text);
    const auto size = static_cast<std::streamsize>(shown.size());
    return terminal->sputn(shown.data(), size) == size;
}

std::streamsize TerminalText::xsputn(const char* text, std::streamsize count) {
    unfinished.append(text, static_cast<std::size_t>(count));
    const auto all = std::exchange(unfinished, {});
    const auto whole = all.size() - unfinishedBytes(all);
    unfinished = all.substr(whole);
    return pass(std::string_view(all).substr(0, whole)) ? count : 0;
}

TerminalText::int_type TerminalText::overflow(int_type character) {
    if (traits_type::eq_int_type(character, traits_type::eof()))
        return traits_type::not_eof(character);
    const char one = traits_type::to_char_type(character);
    return xsputn(&one, 1) == 1 ? character : traits_type::eof();
}

int TerminalText::sync() {
    return terminal->pubsync();
}

} // namespace idiophone
