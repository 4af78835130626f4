// A frame as published: discs of ink and of paper, to be painted from far to near.     [NPAR 6.1]
#pragma once

#include "base/runtime.h"
#include "frame/published/classify.h"
#include "frame/published/visibility.h"
#include "frame/scene/disc.h"
#include "frame/scene/frame_info.h"
#include "frame/scene/order.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

class PublishedFrame {
public:
    explicit PublishedFrame(const base::Runtime& runtime) noexcept;

    // Fills the scene's marks.  Throws Error{callback, out_of_memory}.
    void run(Scene& scene, const glm::vec4& paper);

    [[nodiscard]] std::span<const Disc> discs() const noexcept { return discs_.span(); } // far to near
    [[nodiscard]] const FrameInfo& info() const noexcept { return info_; }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    [[nodiscard]] static bool hides(const Scene& scene) noexcept;
    void emit_keys(const Scene& scene);
    void build_discs(const Scene& scene, const glm::vec4& paper);
    [[nodiscard]] static std::uint64_t ink_key(const Scene& scene, const Run& run, std::int64_t place) noexcept;
    [[nodiscard]] static std::uint64_t paper_key(const Scene& scene, const Run& run, std::int64_t place) noexcept;
    [[nodiscard]] static Disc disc_of(const Scene& scene, const glm::vec4& paper, const Run& run, std::int64_t place,
                                      bool is_paper) noexcept;
    [[nodiscard]] static float ink_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept;
    [[nodiscard]] static float cover_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept;

    const base::Runtime& runtime_;
    FrameInfo info_;
    ToneCalls tone_calls_;
    VisibilityMap visibility_;
    FarToNear order_;
    base::Array<FrameInfo> counts_;       // of each chunk
    base::Array<std::int64_t> first_key_; // of each chunk
    base::Array<std::uint64_t> keys_;
    base::Array<Disc> discs_;
};

} // namespace hrbfnpr::frame
