#include "backend_gl/program.h"

#include <stdexcept>

namespace dirt {
namespace {

struct ShaderKind {
    static void destroy(GLuint id) { glDeleteShader(id); }
};

GLenum stageOf(const std::string& file) {
    const std::string extension = file.substr(file.rfind('.') + 1);
    if (extension == "vert") return GL_VERTEX_SHADER;
    if (extension == "geom") return GL_GEOMETRY_SHADER;
    if (extension == "frag") return GL_FRAGMENT_SHADER;
    return GL_COMPUTE_SHADER;
}

GlObject<ShaderKind> compile(const ShaderFiles& shaders, const std::string& file,
                             const std::vector<std::string>& defines) {
    const ShaderText source = shaders.compose(file, defines);
    GlObject<ShaderKind> shader(glCreateShader(stageOf(file)));
    const char* text = source.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint compiled = 0, length = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log((size_t) length + 1, '\0');
    glGetShaderInfoLog(shader.id(), length, nullptr, log.data());
    throw std::runtime_error(source.withNames(log.substr(0, log.find('\0'))));
}

} // namespace

Program::Program(const ShaderFiles& shaders, const ProgramSource& source)
    : program_(glCreateProgram()) {
    std::vector<GlObject<ShaderKind>> stages;
    for (const std::string& file : source.files) {
        stages.push_back(compile(shaders, file, source.defines));
        glAttachShader(id(), stages.back().id());
    }
    std::vector<const char*> captured;
    for (const std::string& output : source.captured) captured.push_back(output.c_str());
    if (!captured.empty())
        glTransformFeedbackVaryings(id(), (GLsizei) captured.size(), captured.data(),
                                    GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(id());
    for (const auto& stage : stages) glDetachShader(id(), stage.id());
    GLint linked = 0, length = 0;
    glGetProgramiv(id(), GL_LINK_STATUS, &linked);
    if (linked) return;
    glGetProgramiv(id(), GL_INFO_LOG_LENGTH, &length);
    std::string log((size_t) length + 1, '\0');
    glGetProgramInfoLog(id(), length, nullptr, log.data());
    throw std::runtime_error(source.name + ": " + log.substr(0, log.find('\0')));
}

} // namespace dirt
