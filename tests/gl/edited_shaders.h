#pragma once

#include "backend_gl/shader_files.h"
#include "tests/support/temporary_folder.h"

#include <string>

#include <gtest/gtest.h>

namespace dirt::test {

/// Edited copies of the shaders.
class EditedShaders {
public:
    EditedShaders() {
        for (const std::string& file : ShaderFiles::builtIn())
            folder_.write(file, ShaderFiles().read(file));
    }
    void replace(const std::string& file, const std::string& from, const std::string& to) const {
        std::string source = files().read(file); // one edit after the other
        const size_t at = source.find(from);
        ASSERT_NE(at, source.npos) << "'" << from << "' is no longer in " << file;
        folder_.write(file, source.replace(at, from.size(), to));
    }
    ShaderFiles files() const { return ShaderFiles(folder_.path()); }

private:
    TemporaryFolder folder_;
};

} // namespace dirt::test
