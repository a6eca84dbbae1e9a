// The picture's shader programs, from the files in Resources/Shaders.
#pragma once

#include <juce_opengl/juce_opengl.h>
#include <memory>
#include <string_view>

namespace idiophone {

/// The places of the vertices' attributes in all programs.
enum class Attribute : juce::uint32 { place, normal, offset, sky };

/// Compiles and links a program of GLSL 1.50 from two files. `definition` ("FINISH 2") is a macro
/// of both. Returns nullptr if the driver refuses them. OpenGL thread.
std::unique_ptr<juce::OpenGLShaderProgram> linkedProgram(juce::OpenGLContext& context,
                                                         std::string_view vertexFile,
                                                         std::string_view fragmentFile,
                                                         std::string_view definition = {});

} // namespace idiophone
