// SPDX-License-Identifier: MIT
#include "picture/ends.h"

#include "base/assert.h"
#include "picture/normals.h"
#include "picture/tuning_points.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::picture {

Model ended_by(const Call& call, const Model& model, const Points& places, const char* of,
               const hrbfnpr_trim_desc& desc) {
    HRBFNPR_ASSERT(model);
    hrbfnpr_trim_desc by_places = desc;
    by_places.points = view_of(places);
    Stage stage(call.report, HRBFNPR_STAGE_END);
    try {
        auto ended = make<Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
            return hrbfnpr_model_trim(model.get(), &by_places, stage.operation(), made, error);
        });
        stage.says(trim_in_words(call, ended, of));
        return ended;
    } catch (const Error& error) {
        if (error.status() != Status::not_converged) throw;
        call.report.warn(HRBFNPR_NOTE_END_NOT_FOUND, {},
                         "the end of the surface was not found: it runs on to the edge of its box",
                         {.detail = formatted(call.pool, "The search ended with: %s.", error.what())});
    }
    return model;
}

Model end_of_points(const Call& call, const Model& model, const Shape& shape, std::optional<double> hole) {
    if (call.options.has(HRBFNPR_PICTURE_CLOSE)) return model;
    auto desc = defaults<hrbfnpr_trim_desc>(hrbfnpr_trim_desc_init);
    if (hole) {
        HRBFNPR_ASSERT(shape.normals.size() == shape.points.size());
        desc.hole = *hole / diagonal_of(model);
        desc.normals = view_of(shape.normals);
        return ended_by(call, model, shape.points, "points", desc);
    }
    Points points(&call.pool);
    points.reserve(shape.points.size());
    std::copy_if(shape.points.begin(), shape.points.end(), std::back_inserter(points),
                 [](const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
    Model ended = ended_by(call, model, points, "points", desc);
    if (trim_info_of(ended).share < ends_tuning.mostly_left_out && lie_along_curves(points, call.pool))
        call.report.note(HRBFNPR_NOTE_ALONG_CURVES, {},
                         "the points lie along curves: the surface between the curves is drawn too",
                         {.detail = "They look like wires, cross sections or the path of a tracked pen."});
    return ended;
}

hrbfnpr_trim_info trim_info_of(const Model& model) {
    auto info = defaults<hrbfnpr_trim_info>(hrbfnpr_trim_info_init);
    picture::call([&](hrbfnpr_error* error) { return hrbfnpr_model_get_trim_info(model.get(), &info, error); });
    return info;
}

String trim_in_words(const Call& call, const Model& model, const char* of) {
    Pool& pool = call.pool;
    const hrbfnpr_trim_info info = trim_info_of(model);
    if (info.is_trimmed == 0) return {"the whole surface is kept", &pool};
    return formatted(pool, "left out %s of the surface, up to %s of the diagonal beyond the %s; {close!} keeps it",
                     percent_of(info.share, 1, pool).c_str(),
                     percent_of(info.farthest / diagonal_of(model), 1, pool).c_str(), of);
}

} // namespace hrbfnpr::picture
