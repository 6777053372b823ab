#pragma once

#include "backend_gl/gl_objects.h"
#include "backend_gl/shader_files.h"

#include <string>
#include <vector>

namespace dirt {

/// What a program is made of.
struct ProgramSource {
    std::string name;
    std::vector<std::string> files;    ///< one per stage, which its extension names
    std::vector<std::string> defines;  ///< `NAME VALUE`
    std::vector<std::string> captured; ///< outputs for transform feedback, interleaved
};

/// A linked program.
class Program {
public:
    /// Throws std::runtime_error with the compiler's first complaint, by file and line.
    Program(const ShaderFiles& shaders, const ProgramSource& source);
    void use() const { glUseProgram(program_.id()); }
    GLuint id() const { return program_.id(); }

private:
    struct Kind {
        static void destroy(GLuint id) { glDeleteProgram(id); }
    };
    GlObject<Kind> program_;
};

} // namespace dirt
