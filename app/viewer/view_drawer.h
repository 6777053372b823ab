#pragma once

#include "app/viewer/scene_loading.h"
#include "app/viewer/view_picture.h"
#include "app/viewer/view_state.h"
#include "core/explain/path_account.h"

#include <functional>
#include <memory>
#include <optional>

namespace dirt {

/// Draws what a state of the viewer says: has the scene, the threads and the backend. To be used by
/// one thread alone.
class ViewDrawer {
public:
    /// Whether the state has changed, so that the picture under way is not wanted any more.
    using Stop = std::function<bool()>;
    using Show = std::function<void(ViewPicture)>;

    /// Loads the scene of \p options. If that fails, the one that is there stays. \p progress: see
    /// LoadingWatch. \p showPart, where it is given, gets pictures of what has been read so far;
    /// only as long as there is no scene.
    void open(const CommonOptions& options, const LoadProgress& progress, const Stop& stop,
              const Show& showPart);
    /// What was opened.
    const Input& input() const { return input_; }
    /// The first state that shows it.
    ViewState firstState() const;
    /// After a scene was read again; see Backend::reloadShaders.
    void reloadShaders();

    /// Shows a picture, or several that each have more samples. \p moving: one at once, of as many
    /// pixels as can be drawn in a fifteenth of a second. Brings the camera of \p state to where it
    /// is if it moves by itself.
    void draw(ViewState& state, bool moving, const Stop& stop, const Show& show);

    /// Gives up what a failure may have left in disorder.
    void forget();

private:
    void prepare(ViewState& state);
    RenderSettings coarse(RenderSettings settings) const;
    void drawOnce(const ViewState& state, const RenderSettings& settings, bool moving,
                  const Stop& stop, const Show& show);
    void drawImage(const ViewState& state, const RenderSettings& settings, bool moving,
                   const Stop& stop, const Show& show);
    void drawBuffer(const ViewState& state, const RenderSettings& settings, bool moving,
                    const Stop& stop, const Show& show);
    const PathAccount* accountOf(const ViewState& state, const Stop& stop);
    void tellTile(const ViewState& state, ViewPicture& picture) const;
    std::vector<PathStep> pathOf(const ViewState& state, const PathAccount& account,
                                 const std::vector<PictureValues>& parts) const;
    void finish(ViewPicture picture, const Show& show) const;

    CommonOptions options_;
    Input input_;
    std::unique_ptr<Executor> executor_;
    unsigned threads_ = 0;
    std::unique_ptr<Backend> backend_;
    BackendKind backendKind_{};
    std::optional<PathAccount> account_;
    ViewState accountState_;       ///< that it was taken down of
    double pixelShare_ = 1.0 / 16; ///< of the pixels at rest, while something moves
    /// From the beginning of a picture at rest to its first sample; none: not known yet.
    std::optional<double> restMs_;
};

} // namespace dirt
