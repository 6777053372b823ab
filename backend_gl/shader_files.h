#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dirt {

/// One stage's text with its includes in place. Lines carry their place as `#line LINE FILE`, FILE
/// being an index into files.
struct ShaderText {
    std::string text;
    std::vector<std::string> files;

    /// A compiler's log with file names in place of indices.
    std::string withNames(const std::string& log) const;
};

/// The shaders: those built into the program, or those of a folder, read anew each time.
class ShaderFiles {
public:
    /// The folder of the environment variable DIRT_SHADERS, else the built-in ones.
    ShaderFiles();
    explicit ShaderFiles(std::string folder) : folder_(std::move(folder)) {}

    /// Throws InputError where there is no such file.
    std::string read(const std::string& file) const;

    /// \p file with \p defines (`NAME VALUE`) after its `#version` line, and with each file that it
    /// includes put in once, as `#include "include/x.glsl"` or `"shaders/shared/x.h"` first asks
    /// for it. Throws InputError naming file and line where an include cannot be found.
    ShaderText compose(const std::string& file, const std::vector<std::string>& defines) const;

    /// Names of all built-in files.
    static std::vector<std::string> builtIn();

private:
    std::string folder_; ///< empty: built in
};

} // namespace dirt
