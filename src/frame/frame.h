// One frame: from point sets, camera and styles to what is to be drawn.  [NPAR 6]
#pragma once

#include "base/runtime.h"
#include "frame/scene/camera.h"
#include "frame/scene/disc.h"
#include "frame/scene/frame_info.h"
#include "frame/scene/item.h"

#include <memory>
#include <span>

namespace hrbfnpr::frame {

class LayerFrame;

// Reused from frame to frame: allocates nothing once warm.
class Frame {
public:
    explicit Frame(const base::Runtime& runtime);
    ~Frame();

    // Throws Error{invalid_argument, callback, out_of_memory}; on failure no frame is prepared.
    void prepare(std::span<const Item> items, const Camera& camera);

    [[nodiscard]] bool prepared() const noexcept;
    [[nodiscard]] const Camera& camera() const noexcept;
    [[nodiscard]] const glm::vec4& paper() const noexcept;
    // Far to near: the order of painting.
    [[nodiscard]] std::span<const Disc> discs() const;
    // NULL: painted as published.
    [[nodiscard]] const LayerFrame* layer_frame() const noexcept;
    [[nodiscard]] const FrameInfo& info() const noexcept;

    // The mark behind a disc, for outputs that want more of it than a disc holds.
    struct MarkSource {
        glm::vec3 position; // world
        glm::vec3 normal;
        glm::vec3 direction;
    };
    [[nodiscard]] MarkSource source(const Disc& disc) const noexcept;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace hrbfnpr::frame
