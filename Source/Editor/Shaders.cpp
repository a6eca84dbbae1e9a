#include "Editor/Shaders.h"

#include "Object/EmbeddedFiles.h"

#include <array>
#include <span>
#include <string>

namespace idiophone {

std::span<const EmbeddedFile> shaderFiles(); // generated

namespace {

std::string textOf(std::string_view name) {
    const auto* file = findNamed(shaderFiles(), name);
    jassert(file != nullptr);
    return std::string(file->bytes);
}

juce::String sourceOf(std::string_view name, std::string_view definition) {
    return juce::String::fromUTF8(
        ("#version 150\n" +
         (definition.empty() ? "" : "#define " + std::string(definition) + "\n") +
         textOf("lighting.glsl") + textOf(name))
            .c_str());
}

} // namespace

std::unique_ptr<juce::OpenGLShaderProgram> linkedProgram(juce::OpenGLContext& context,
                                                         std::string_view vertexFile,
                                                         std::string_view fragmentFile,
                                                         std::string_view definition) {
    auto program = std::make_unique<juce::OpenGLShaderProgram>(context);
    if (!program->addVertexShader(sourceOf(vertexFile, definition)) ||
        !program->addFragmentShader(sourceOf(fragmentFile, definition)))
        return nullptr;
    constexpr std::array names{"place", "normal", "offset", "sky"};
    for (std::size_t i = 0; i < names.size(); ++i)
        juce::gl::glBindAttribLocation(program->getProgramID(), static_cast<juce::uint32>(i),
                                       names[i]);
    if (!program->link())
        return nullptr;
    return program;
}

} // namespace idiophone
