#include "backend_gl/shader_files.h"

#include "backend_gl/embedded_shaders.h"
#include "core/base/error.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

namespace dirt {
namespace {

std::string_view trimmed(std::string_view line) {
    const size_t first = line.find_first_not_of(" \t");
    return first == line.npos ? std::string_view() : line.substr(first);
}

/// Puts one file, and what it includes, at the end of a text.
class Composer {
public:
    Composer(const ShaderFiles& shaders, const std::vector<std::string>& defines)
        : shaders_(shaders), defines_(defines) {}

    void add(const std::string& file) {
        const size_t index = out_.files.size();
        out_.files.push_back(file);
        std::istringstream lines(shaders_.read(file));
        if (index > 0) place(1, index); // the first begins with its #version
        std::string line;
        for (int number = 1; std::getline(lines, line); ++number) {
            const std::string_view text = trimmed(line);
            if (text.starts_with("#version")) {
                out_.text += line + "\n";
                for (const std::string& define : defines_) out_.text += "#define " + define + "\n";
                place(number + 1, index);
            } else if (text.starts_with("#include")) {
                include(text, file, number);
                place(number + 1, index);
            } else {
                out_.text += line + "\n";
            }
        }
    }

    ShaderText take() { return std::move(out_); }

private:
    void place(int line, size_t file) {
        out_.text += "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
    }

    void include(std::string_view text, const std::string& from, int line) {
        const size_t open = text.find('"'), close = text.rfind('"');
        if (open == close) return; // <…>: for the C++ compiler
        std::string file(text.substr(open + 1, close - open - 1));
        if (file.starts_with("shaders/")) file.erase(0, 8);
        if (std::count(out_.files.begin(), out_.files.end(), file)) return;
        try {
            add(file);
        } catch (const InputError& error) {
            if (out_.files.back() != file) throw; // further in
            throw InputError(from + ":" + std::to_string(line) + ": " + error.what());
        }
    }

    const ShaderFiles& shaders_;
    const std::vector<std::string>& defines_;
    ShaderText out_;
};

} // namespace

std::string ShaderText::withNames(const std::string& log) const {
    // Mesa and Intel write 3:12(5): …, NVIDIA 3(12) : …, glslang and AMD ERROR: 3:12: …
    static const std::regex place(
        "(^|\n)(?:ERROR: |WARNING: )?([0-9]+)(?::([0-9]+)(?:\\([0-9]+\\))?|\\(([0-9]+)\\)) ?:");
    std::string named;
    size_t done = 0;
    for (std::sregex_iterator it(log.begin(), log.end(), place), end; it != end; ++it) {
        const std::smatch& match = *it;
        named += log.substr(done, (size_t) match.position() - done);
        const size_t file = std::stoul(match[2]);
        named += match[1].str() + (file < files.size() ? files[file] : match[2].str()) + ":" +
                 match[3].str() + match[4].str() + ":";
        done = (size_t) (match.position() + match.length());
    }
    return named + log.substr(done);
}

ShaderFiles::ShaderFiles() {
    if (const char* folder = std::getenv("DIRT_SHADERS")) folder_ = folder;
}

std::string ShaderFiles::read(const std::string& file) const {
    if (folder_.empty()) {
        for (const EmbeddedShader& shader : kEmbeddedShaders)
            if (file == shader.file) return shader.text;
        throw InputError("there is no shader '" + file + "'");
    }
    std::ifstream stream(folder_ + "/" + file, std::ios::binary);
    std::ostringstream text;
    if (!stream || !(text << stream.rdbuf()))
        throw InputError("there is no shader '" + file + "' in " + folder_);
    return text.str();
}

ShaderText ShaderFiles::compose(const std::string& file,
                                const std::vector<std::string>& defines) const {
    Composer composer(*this, defines);
    composer.add(file);
    return composer.take();
}

std::vector<std::string> ShaderFiles::builtIn() {
    std::vector<std::string> files;
    for (const EmbeddedShader& shader : kEmbeddedShaders) files.push_back(shader.file);
    return files;
}

} // namespace dirt
