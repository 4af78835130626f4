// SPDX-License-Identifier: MIT
// A drawing as published: discs of ink and of paper, to be painted from far to near.     [NPAR 6.1]
#pragma once

#include "base/runtime.h"
#include "drawing/far_to_near.h"
#include "frame/scene/scene.h"
#include "published/classify.h"
#include "published/visibility.h"

namespace hrbfnpr::published {

using namespace frame; // the scene that this room classifies and paints

class PublishedFrame {
public:
    explicit PublishedFrame(const base::Runtime& runtime) noexcept;

    // Fills the scene's marks, and what the scene does not fill of the drawing.
    // Throws Error{callback, out_of_memory}.
    void run(Scene& scene, drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    [[nodiscard]] static bool hides(const Scene& scene) noexcept;
    void emit_keys(const Scene& scene);
    void put_dots(const Scene& scene, drawing::Drawing& drawing) const;
    [[nodiscard]] static std::uint64_t ink_key(const Scene& scene, const Run& run, std::int64_t place) noexcept;
    [[nodiscard]] static std::uint64_t paper_key(const Scene& scene, const Run& run, std::int64_t place) noexcept;
    [[nodiscard]] static Dot dot_of(const Scene& scene, std::int64_t number, std::int64_t place,
                                    bool is_paper) noexcept;
    [[nodiscard]] static float ink_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept;
    [[nodiscard]] static float splat_radius(const Scene& scene, const Run& run, std::int64_t place) noexcept;

    const base::Runtime& runtime_;
    ToneCalls tone_calls_;
    VisibilityMap visibility_;
    drawing::FarToNear order_;
    base::Array<Counts> counts_;          // of each chunk
    base::Array<std::int64_t> first_key_; // of each chunk
    base::Array<std::uint64_t> keys_;
};

} // namespace hrbfnpr::published
