// SPDX-License-Identifier: MIT
// The work of Gather on one piece of a run.
#pragma once

#include "frame/depth_layers/gather.h"

namespace hrbfnpr::frame {

class Gatherer {
public:
    // inks, splats: where its own go.
    Gatherer(Gather& all, const Scene& scene, const Run& run, std::int32_t run_number, Dot* inks,
             Splat* splats) noexcept;

    void operator()(const marks::Cluster& cluster) noexcept;
    // This cluster comes soon.
    void expect(std::int64_t cluster) const noexcept;

    [[nodiscard]] const Dot* dots_end() const noexcept { return ink_; }
    [[nodiscard]] const Splat* splats_end() const noexcept { return splat_; }
    [[nodiscard]] const Counts& info() const noexcept { return info_; }

private:
    // What is the same for all marks of a cluster.
    struct Local {
        const marks::Cluster* cluster = nullptr;
        ClusterView view;
        Selection selection;
        float pixel_curvature = 0.0F; // per pixel, of a curvature of 1
        float rim_band = 0.0F;        // marks of the cluster with |nu| below this may be near a contour
        float splat_spacing = 1.0F;   // pixels
    };

    // A mark near a contour, in object space.
    struct Rim {
        glm::vec3 normal, sight;
        float curvature; // along the line of sight
    };

    [[nodiscard]] Selection common_selection() const noexcept;
    [[nodiscard]] Local local_of(const marks::Cluster& cluster) const noexcept;
    void set_rim(Local& local) const noexcept;
    [[nodiscard]] float reach(float pixels_per_unit) const noexcept;
    [[nodiscard]] bool count_whole(const Local& local) noexcept;
    [[nodiscard]] std::int64_t shown_of(const marks::Cluster& cluster, float shown) const noexcept;
    [[nodiscard]] float most_shown(const Local& local) const noexcept;
    [[nodiscard]] std::int64_t splats_of(const Local& local) const noexcept;
    void splat(const Local& local, const Seen& seen, std::int64_t count) noexcept;
    [[nodiscard]] Rim rim_of(const Local& local, std::int64_t i) const noexcept;
    [[nodiscard]] float to_rim(const Rim& rim, float nu) const noexcept;
    void set_halo(Splat& c, const Local& local, const Seen& seen, std::int64_t i) const noexcept;
    void ink(const Local& local, const Seen& seen, std::int64_t count, bool counted) noexcept;
    [[nodiscard]] const float* taus(const Local& local, const Seen& seen, std::int64_t count,
                                    float* scratch) const noexcept;
    [[nodiscard]] const float* depth_tones(const Seen& seen, std::int64_t count, float* scratch) const noexcept;
    void put(const Local& local, const Seen& seen, std::int64_t i, float radius) noexcept;

    Gather& all_;
    const Scene& scene_;
    const Run& run_;
    const ItemView& item_;
    const Style& style_;
    const ItemSight& sight_;
    const ItemInk& item_ink_;
    const TransmittanceTable& transmittance_;
    const marks::MarkClusters& marks_;
    std::uint32_t layer_;
    Selection selection_; // what is the same for all clusters
    Counts info_;
    Dot* ink_;
    Splat* splat_;
};

} // namespace hrbfnpr::frame
