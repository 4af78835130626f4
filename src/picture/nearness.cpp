// SPDX-License-Identifier: MIT
#include "picture/nearness.h"

#include "picture/tuning_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

template <class Found>
String distances_of(const Found& found, double diagonal, Pool& pool) {
    const auto share = [&](double distance) { return percent_of(distance / diagonal, 2, pool); };
    // NaN means that no surface was found near the mesh.
    if (std::isnan(found.surface_p99)) return {"no surface near the mesh", &pool};
    // Infinity means that more than 1 % of the mesh has no surface near it.
    if (!std::isfinite(found.mesh_p99)) return {"parts of the mesh have no surface near them", &pool};
    String words = formatted(pool, "99%% of surface and mesh are within %s of the diagonal of each other, ",
                             share(std::max(found.surface_p99, found.mesh_p99)).c_str());
    if (!std::isfinite(found.mesh_max)) return words += "but parts of the mesh have no surface near them";
    return (words += "all within ") += share(std::max(found.surface_max, found.mesh_max));
}

} // namespace

String percent_of(double share, int digits, Pool& pool) {
    if (std::isnan(share)) return {"nan%", &pool}; // NaN is written here, because printf may write it with a sign.
    return formatted(pool, "%.*f%%", digits, 100.0 * share);
}

String distances_in_words(const hrbfnpr_mesh_fit_info& found, double diagonal, Pool& pool) {
    return distances_of(found, diagonal, pool);
}
String distances_in_words(const hrbfnpr_comparison& found, double diagonal, Pool& pool) {
    return distances_of(found, diagonal, pool);
}

void tell_nearness(const Call& call, const Mesh& mesh, const Model& model) {
    Pool& pool = call.pool;
    auto found = defaults<hrbfnpr_comparison>(hrbfnpr_comparison_init);
    {
        Stage stage(call.report, HRBFNPR_STAGE_COMPARE);
        picture::call([&](hrbfnpr_error* error) {
            return hrbfnpr_model_compare_mesh(model.get(), mesh.get(), nullptr, &found, stage.operation(), error);
        });
        stage.says(distances_in_words(found, found.diagonal, pool));
    }
    if (!(found.missed_share > nearness_tuning.missed_share)) return;
    const std::int64_t more = nearness_tuning.more_samples * model_info_of(model).samples;
    const double farthest = found.mesh_max / found.diagonal;
    call.report.warn(
        HRBFNPR_NOTE_OFF_MESH, {found.missed_share, farthest},
        formatted(pool, "%s of the mesh is more than %s of the diagonal off the surface: try {samples=%lld}",
                  percent_of(found.missed_share, 1, pool).c_str(), percent_of(nearness_tuning.far, 0, pool).c_str(),
                  static_cast<long long>(more)),
        {.detail = formatted(
             pool, "%s Thin parts need more samples.",
             std::isfinite(farthest)
                 ? formatted(pool, "The farthest place is %s off.", percent_of(farthest, 1, pool).c_str()).c_str()
                 : "Some places have no surface near them.")});
}

hrbfnpr_model_info model_info_of(const Model& model) {
    auto info = defaults<hrbfnpr_model_info>(hrbfnpr_model_info_init);
    picture::call([&](hrbfnpr_error* error) { return hrbfnpr_model_get_info(model.get(), &info, error); });
    return info;
}

double diagonal_of(const hrbfnpr_model_info& info) noexcept {
    glm::dvec3 size;
    for (glm::length_t axis = 0; axis < 3; ++axis) size[axis] = info.bounds_max[axis] - info.bounds_min[axis];
    const double diagonal = glm::length(size);
    return diagonal == 0.0 ? 1.0 : diagonal;
}

double diagonal_of(const Model& model) { return diagonal_of(model_info_of(model)); }

String nearness_of_points(const hrbfnpr_model_info& info, Pool& pool) {
    const double diagonal = diagonal_of(info);
    const double most = info.input_distance_max / diagonal;
    if (most < nearness_tuning.through) return {"passes through all samples", &pool};
    return formatted(pool, "samples within %.2g diagonals, %.2g on average (rms)", most,
                     info.input_distance_rms / diagonal);
}

void tell_repaired_samples(const Call& call, const hrbfnpr_model_info& info) {
    struct Repair {
        std::uint32_t code;
        std::int64_t count;
        const char* what;
    };
    const std::array repairs{
        Repair{HRBFNPR_NOTE_SAMPLES_MERGED, info.merged_samples, " merged with another at the same place"},
        Repair{HRBFNPR_NOTE_SAMPLES_NEAR, info.near_duplicates, " merged with a very near one"},
        Repair{HRBFNPR_NOTE_SAMPLES_DROPPED, info.outliers_dropped, " left out as strays"},
        Repair{HRBFNPR_NOTE_SAMPLES_FLIPPED, info.flipped_repaired, " with a flipped normal turned"}};
    for (const Repair& repair : repairs)
        if (repair.count > 0)
            call.report.note(repair.code, {static_cast<double>(repair.count)},
                             count_of(repair.count, "sample", call.pool) += repair.what);
}

void tell_doubted_samples(const Call& call, const hrbfnpr_model_info& info) {
    const double least =
        std::max(nearness_tuning.least_doubted, nearness_tuning.doubted_share * static_cast<double>(info.samples));
    const std::int64_t strays = info.outliers_found - info.outliers_dropped;
    const std::int64_t flipped = info.flipped_found - info.flipped_repaired;
    if (static_cast<double>(strays) >= least)
        call.report.warn(HRBFNPR_NOTE_LIKE_STRAYS, {static_cast<double>(strays)},
                         count_of(strays, "sample", call.pool) += " look like strays: {outliers=drop} leaves them out");
    if (static_cast<double>(flipped) >= least)
        call.report.warn(HRBFNPR_NOTE_LIKE_FLIPPED, {static_cast<double>(flipped)},
                         count_of(flipped, "sample", call.pool) +=
                         " look as if their normals were flipped: {flipped_normals=reorient} turns them");
}

} // namespace hrbfnpr::picture
