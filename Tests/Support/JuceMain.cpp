// Runs tests of the plugin with JUCE's message manager, without a display, and with a user folder
// of their own.
#include "Support/HomeFolder.h"
#include "Support/TestFolder.h"

#include <catch2/catch_session.hpp>
#include <cstdlib>
#include <juce_events/juce_events.h>

int main(int argumentCount, char* arguments[]) {
#if defined(_WIN32)
    _putenv_s("APPDATA", idiophone::test::testFolder().string().c_str());
#elif defined(__APPLE__)
    idiophone::test::setHome(idiophone::test::testFolder().string());
#else
    setenv("XDG_CONFIG_HOME", idiophone::test::testFolder().c_str(), 1);
    unsetenv("DISPLAY"); // a view without OpenGL paints its picture itself
#endif
    const juce::ScopedJuceInitialiser_GUI juce;
    return Catch::Session().run(argumentCount, arguments);
}
