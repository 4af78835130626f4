// The work of Gather on one piece of a run.
#pragma once

#include "frame/gather.h"

namespace hrbfnpr::frame {

class Gatherer {
public:
    Gatherer(Gather& all, const Scene& scene, const Run& run, std::int32_t run_number,
             std::int64_t first_place) noexcept;

    void operator()(const sampling::Cluster& cluster) noexcept;
    // This cluster comes soon: its marks lie in as many pieces of memory as they have numbers.
    void expect(std::int64_t cluster) const noexcept;

    [[nodiscard]] std::int64_t ink_end() const noexcept { return ink_ - all_.inks_.data(); }
    [[nodiscard]] std::int64_t cover_end() const noexcept { return cover_ - all_.covers_.data(); }
    [[nodiscard]] const FrameInfo& info() const noexcept { return info_; }

private:
    // What is the same for all marks of a cluster.
    struct Local {
        const sampling::Cluster* cluster = nullptr;
        ClusterView view;
        float pixel_curvature = 0.0F; // of an object's curvature of 1
        float band = 0.0F;            // |nu| up to which a mark may be a contour's
        float per_ink = 1.0F;         // 1 / ink per pixel, if all marks are shown and nothing is foreshortened
        float most_shown = 1.0F;      // no tone shows a larger share of its marks
        bool front_ink = false;       // marks of this set are drawn
    };
    // A mark as a part of its contour.
    struct Contour {
        float share = 0.0F; // 1 in the middle of the band, 0 outside of it
        float shown = 1.0F; // of the marks, so that the line is dense enough
    };

    [[nodiscard]] Local local_of(const sampling::Cluster& cluster) const noexcept;
    [[nodiscard]] float reach(float ppe) const noexcept;
    [[nodiscard]] bool count_whole(const Local& local, std::int64_t marks) noexcept;
    [[nodiscard]] std::int64_t first_hidden(const sampling::Cluster& cluster, float shown) const noexcept;
    [[nodiscard]] float most_shown(const Local& local) const noexcept;
    [[nodiscard]] float most_of_contour(const Local& local) const noexcept;
    void cover(const Local& local, const Seen& seen, std::int64_t count) noexcept;
    [[nodiscard]] std::int64_t covers_of(const Local& local) const noexcept;
    // counted: its class already is.
    void mark(const Local& local, const Seen& seen, std::int64_t i, bool counted) noexcept;
    [[nodiscard]] float radial_curvature(const Local& local, std::int64_t place) const noexcept;
    [[nodiscard]] float contour_shown(const Local& local, float pixel_curvature) const noexcept;
    [[nodiscard]] Contour contour_of(const Local& local, float nu, std::int64_t place) const noexcept;
    [[nodiscard]] float tone_share(const Local& local, const Seen& seen, std::int64_t i,
                                   FrameInfo& info) const noexcept;
    [[nodiscard]] float silhouette_share(const Seen& seen, std::int64_t i, std::int64_t place,
                                         float most) const noexcept;
    [[nodiscard]] bool bears_halo(const Local& local, float nu, std::int64_t place) const noexcept;
    [[nodiscard]] float depth_tone_of(const Seen& seen, std::int64_t i) const noexcept;
    [[nodiscard]] float tau_of(const Seen& seen, std::int64_t i, std::int64_t place) const noexcept;
    [[nodiscard]] float shown_for(const Local& local, float tau, float nu) const noexcept;
    [[nodiscard]] float grown(float rank, float shown) const noexcept;
    [[nodiscard]] bool inside(const Seen& seen, std::int64_t i) const noexcept;
    void put(const Local& local, const Seen& seen, std::int64_t i, float radius, MarkClass mark_class) noexcept;

    Gather& all_;
    const Scene& scene_;
    const Run& run_;
    const ItemView& item_;
    const Style& style_;
    const ItemSight& sight_;
    const ItemInk& item_ink_;
    const ClearTable& clear_;
    const sampling::MarkClusters& marks_;
    std::uint32_t color_;
    float share_;
    float more_for_fade_; // marks, as those that fade in are small
    bool depth_active_;
    FrameInfo info_;
    Ink* ink_;
    Cover* cover_;
};

} // namespace hrbfnpr::frame
