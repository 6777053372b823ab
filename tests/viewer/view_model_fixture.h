#pragma once

#include "app/viewer/view_model.h"
#include "tests/support/temporary_folder.h"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include <gtest/gtest.h>

namespace dirt::test {

inline constexpr const char* kFloorAndBox = "v -2 0 -4\nv 2 0 -4\nv 2 0 1\nv -2 0 1\n"
                                            "v -1 0 -3\nv 1 0 -3\nv 1 1.5 -3\nv -1 1.5 -3\n"
                                            "f 1 4 3 2\nf 5 6 7 8\n";

class ViewModelTest : public testing::Test {
public:
    CommonOptions options(const std::string& text = kFloorAndBox) {
        CommonOptions options;
        options.scene = folder_.write("box.obj", text);
        options.size = ImageSize{48, 32};
        options.samples = 4;
        options.bounces = 2;
        options.threads = 2;
        options.quiet = options.noCache = true;
        return options;
    }

    /// Whether it comes true within a time that no machine needs.
    static bool comes(const std::function<bool()>& what) {
        for (int i = 0; i < 6000; ++i) {
            if (what()) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    }

    /// The picture of the last change with all its samples; null if it does not come.
    static std::shared_ptr<const ViewPicture> rest(const ViewModel& model) {
        std::shared_ptr<const ViewPicture> picture;
        comes([&] {
            picture = model.picture();
            return picture && picture->done && picture->change == model.changes();
        });
        return picture;
    }

protected:
    test::TemporaryFolder folder_;
};

} // namespace dirt::test
