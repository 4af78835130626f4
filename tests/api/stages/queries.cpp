// SPDX-License-Identifier: MIT
// Stages of queries, marks, line sets and files.
#include "stages/stages.h"
#include "support/csg_nodes.h"

#include <array>
#include <cstring>

namespace api_test {
namespace {

std::int32_t around_y(void* /*user*/, std::int64_t count, const double* positions, const double* /*normals*/,
                      double* directions) {
    for (std::int64_t i = 0; i < 3 * count; i += 3) {
        directions[i] = positions[i + 2];
        directions[i + 1] = 0.0;
        directions[i + 2] = -positions[i];
    }
    return 0;
}

std::int32_t upper_half(void* /*user*/, std::int64_t count, const double* positions, const double* /*normals*/,
                        double* density) {
    for (std::int64_t i = 0; i < count; ++i) density[i] = positions[3 * i + 1] > 0.0 ? 1.0 : 0.3;
    return 0;
}

std::int32_t write_bytes(void* user, const void* data, std::uint64_t size) {
    auto& [room, used] = *static_cast<std::pair<Bytes, std::size_t>*>(user);
    if (used + size > room.size()) return 1;
    std::memcpy(room.data() + used, data, size);
    used += size;
    return 0;
}

struct Reading {
    const Bytes& bytes;
    std::size_t at = 0;
    static std::int64_t read(void* user, void* data, std::uint64_t size) {
        auto& self = *static_cast<Reading*>(user);
        const std::size_t n = std::min<std::size_t>(size, self.bytes.size() - self.at);
        std::memcpy(data, self.bytes.data() + self.at, n);
        self.at += n;
        return static_cast<std::int64_t>(n);
    }
};

} // namespace

void Stages::add_queries(std::vector<Stage>& stages) {
    const auto query = [&](const char* name, auto&& call) { add(stages, name, std::forward<decltype(call)>(call)); };
    query("evaluate", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<double> value(places_.size() / 3), gradient(places_.size()), hessian(2 * places_.size());
        const hrbfnpr_array from = in(places_);
        const hrbfnpr_array_out values = out(value, 1), gradients = out(gradient), hessians = out(hessian, 6);
        const auto status = attempt([&] {
            return hrbfnpr_model_evaluate(model_.get(), &from, &values, &gradients, &hessians, attempt.operation,
                                          error);
        });
        if (status == HRBFNPR_STATUS_OK) append(bytes, value), append(bytes, gradient), append(bytes, hessian);
        return status;
    });
    query("project", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<double> position(places_.size()), normal(places_.size());
        const hrbfnpr_array from = in(places_);
        auto projection = made(hrbfnpr_projection_init);
        projection.position = out(position);
        projection.normal = out(normal);
        const auto status = attempt(
            [&] { return hrbfnpr_model_project(model_.get(), &from, nullptr, &projection, attempt.operation, error); });
        if (status == HRBFNPR_STATUS_OK) append(bytes, position), append(bytes, normal);
        return status;
    });
    query("curvature", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<double> k1(places_.size() / 3), d1(places_.size());
        const hrbfnpr_array from = in(places_);
        auto curvature = made(hrbfnpr_curvature_init);
        curvature.k1 = out(k1, 1);
        curvature.d1 = out(d1);
        const auto status =
            attempt([&] { return hrbfnpr_model_curvature(model_.get(), &from, &curvature, attempt.operation, error); });
        if (status == HRBFNPR_STATUS_OK) append(bytes, k1), append(bytes, d1);
        return status;
    });
    query("cast_rays", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<double> t(2 * places_.size() / 3), normal(2 * places_.size());
        const hrbfnpr_array from = in(places_), along = in(directions_);
        auto desc = made(hrbfnpr_cast_desc_init);
        desc.maximum_hits = 2;
        auto hits = made(hrbfnpr_ray_hits_init);
        hits.t = out(t, 2);
        hits.normal = out(normal, 6);
        const auto status = attempt([&] {
            return hrbfnpr_model_cast_rays(model_.get(), &from, &along, &desc, &hits, attempt.operation, error);
        });
        if (status == HRBFNPR_STATUS_OK) append(bytes, t), append(bytes, normal);
        return status;
    });
    query("contains", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<std::uint8_t> inside(places_.size() / 3);
        const hrbfnpr_array from = in(places_);
        const hrbfnpr_array_out to = out(inside, 1);
        const auto status = attempt(
            [&] { return hrbfnpr_model_contains(model_.get(), &from, &to, nullptr, attempt.operation, error); });
        if (status == HRBFNPR_STATUS_OK) append(bytes, inside);
        return status;
    });
    query("lipschitz", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        double bound = 0.0;
        const auto status =
            attempt([&] { return hrbfnpr_model_lipschitz(model_.get(), &bound, attempt.operation, error); });
        if (status == HRBFNPR_STATUS_OK) append_value(bytes, bound);
        return status;
    });
    query("step_patches", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::vector<double> corner(24);
        const hrbfnpr_array_out corners = out(corner, 12);
        const auto status = attempt([&] {
            return hrbfnpr_point_set_step_patches(context_.get(), model_.get(), nullptr, &corners, nullptr,
                                                  attempt.operation, error);
        });
        if (status == HRBFNPR_STATUS_OK) append(bytes, corner);
        return status;
    });
}

void Stages::add_set(std::vector<Stage>& stages, const std::string& name, const Generation& desc) {
    add(stages, name, [this, desc](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        Generation own = desc;
        hrbfnpr_point_set* set = nullptr;
        const hrbfnpr_generate_desc* settings = own.get();
        const auto status = attempt([&] {
            return hrbfnpr_point_set_generate(context_.get(), model_.get(), settings, attempt.operation, &set, error);
        });
        EXPECT_EQ(set != nullptr, status == HRBFNPR_STATUS_OK);
        if (const PointSet owned(set); owned) append(bytes, owned);
        return status;
    });
}

void Stages::add_line_set(std::vector<Stage>& stages, const char* name, bool curved) {
    add(stages, name, [this, curved](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        const std::vector<double> level{0.0, 0.4};
        std::array<hrbfnpr_line_desc, 4> lines{};
        const std::array<std::uint32_t, 4> kinds{HRBFNPR_LINE_KIND_RIDGE, HRBFNPR_LINE_KIND_VALLEY,
                                                 HRBFNPR_LINE_KIND_PARABOLIC, HRBFNPR_LINE_KIND_SECTION};
        for (std::size_t i = 0; i < lines.size(); ++i) {
            lines[i] = made(hrbfnpr_line_desc_init);
            lines[i].kind = kinds[i];
        }
        lines[3].levels = in(level, 1);
        auto desc = made(hrbfnpr_line_set_desc_init);
        desc.cell_size = 0.4;
        if (curved) {
            desc.flags = HRBFNPR_LINE_SET_WITH_CURVATURE;
            desc.lines = lines.data();
            desc.line_count = static_cast<std::int64_t>(lines.size());
        }
        hrbfnpr_line_set* set = nullptr;
        const auto status = attempt([&] {
            return hrbfnpr_line_set_create(context_.get(), (curved ? model_ : half_model_).get(), &desc,
                                           attempt.operation, &set, error);
        });
        EXPECT_EQ(set != nullptr, status == HRBFNPR_STATUS_OK);
        const LineSet owned(set);
        if (!owned) return status;
        auto info = made(hrbfnpr_line_set_info_init);
        EXPECT_EQ(hrbfnpr_line_set_get_info(set, &info, nullptr), HRBFNPR_STATUS_OK);
        append(bytes, std::vector<std::int64_t>{info.triangles, info.turned, info.lines, info.borders});
        return status;
    });
}

void Stages::add_marks(std::vector<Stage>& stages) {
    add_set(stages, "marks.stipples", one_layer(HRBFNPR_LAYER_KIND_STIPPLES, sizes_.marks));
    constexpr std::array<std::pair<std::uint32_t, const char*>, 3> guides{
        {{HRBFNPR_HATCH_GUIDE_CURVATURE, "marks.hatch"},
         {HRBFNPR_HATCH_GUIDE_COMBING, "marks.hatch.combing"},
         {HRBFNPR_HATCH_GUIDE_SILHOUETTE, "marks.hatch.silhouette"}}};
    for (const auto& [guide, name] : guides) {
        Generation desc = one_layer(HRBFNPR_LAYER_KIND_HATCH, sizes_.marks);
        desc.layer[0].guide = guide;
        add_set(stages, name, desc);
    }
    Generation along = one_layer(HRBFNPR_LAYER_KIND_HATCH, sizes_.marks);
    along.layer[0].direction_function = around_y;
    add_set(stages, "marks.hatch.function", along);
    Generation dense = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, sizes_.marks);
    dense.layer[0].density = HRBFNPR_DENSITY_CALLBACK;
    dense.layer[0].density_function = upper_half;
    dense.layer[0].flags = HRBFNPR_LAYER_WITH_CURVATURE;
    dense.layer[0].tone_smoothing = 0.02;
    add_set(stages, "marks.density", dense);
    Generation shared = hrbfnpr::test::three_layers(sizes_.marks);
    shared.shared_budget = sizes_.marks;
    shared.tone_ranges = HRBFNPR_TONE_RANGES_IN_TURN;
    shared.seed_source = HRBFNPR_SEED_BOX;
    add_set(stages, "marks.shared", shared);
    Generation published = small_desc(HRBFNPR_DISTRIBUTION_PUBLISHED);
    published.add(HRBFNPR_LAYER_KIND_HATCH, sizes_.marks).direction_function = around_y;
    for (hrbfnpr_layer_desc& layer : published.layer) {
        layer.levels = 1;
        layer.budget = sizes_.marks;
    }
    published.layer[2].start = HRBFNPR_STROKE_START_STIPPLES;
    add_set(stages, "marks.published", published);
    add_line_set(stages, "lines", false);
    add_line_set(stages, "lines.curved", true);
}

void Stages::add_files(std::vector<Stage>& stages) {
    add(stages, "marks.own", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        const std::vector<std::uint32_t> first{0, 3, 6};
        const std::vector<double> position(samples_.points.begin(), samples_.points.begin() + 18);
        auto arrays = made(hrbfnpr_layer_arrays_init);
        arrays.position = arrays.normal = in(position);
        arrays.stroke_first = in(first, 1);
        auto desc = made(hrbfnpr_point_set_desc_init);
        desc.base = set_.get();
        desc.layers = &arrays;
        desc.layer_count = 1;
        hrbfnpr_point_set* set = nullptr;
        const auto status = attempt([&] { return hrbfnpr_point_set_create(context_.get(), &desc, &set, error); });
        EXPECT_EQ(set != nullptr, status == HRBFNPR_STATUS_OK);
        if (const PointSet owned(set); owned) append(bytes, owned);
        return status;
    });
    add(stages, "file.model", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        std::pair<Bytes, std::size_t> file{Bytes(4 << 20), 0};
        auto status = attempt([&] { return hrbfnpr_model_save(model_.get(), write_bytes, &file, error); });
        if (status != HRBFNPR_STATUS_OK) return status;
        file.first.resize(file.second);
        Reading reading{file.first};
        hrbfnpr_model* loaded = nullptr;
        status = attempt([&] { return hrbfnpr_model_load(context_.get(), Reading::read, &reading, &loaded, error); });
        EXPECT_EQ(loaded != nullptr, status == HRBFNPR_STATUS_OK);
        if (const Model owned(loaded); owned) append(bytes, owned);
        return status;
    });
    add(stages, "csg", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        hrbfnpr::test::CsgNodes nodes = hrbfnpr::test::csg_part();
        nodes.add(HRBFNPR_CSG_MODEL, 1).model = model_.get();
        const hrbfnpr_csg_desc desc = nodes.desc();
        hrbfnpr_model* part = nullptr;
        auto status = attempt([&] { return hrbfnpr_model_create_csg(context_.get(), &desc, &part, error); });
        EXPECT_EQ(part != nullptr, status == HRBFNPR_STATUS_OK);
        if (status != HRBFNPR_STATUS_OK) return status;
        const Model owned(part);
        std::vector<double> value(places_.size() / 3), gradient(places_.size());
        const hrbfnpr_array from = in(places_);
        const hrbfnpr_array_out values = out(value, 1), gradients = out(gradient);
        status = attempt([&] {
            return hrbfnpr_model_evaluate(part, &from, &values, &gradients, nullptr, attempt.operation, error);
        });
        if (status != HRBFNPR_STATUS_OK) return status;
        append(bytes, value), append(bytes, gradient);
        std::pair<Bytes, std::size_t> file{Bytes(4 << 20), 0};
        status = attempt([&] { return hrbfnpr_model_save(part, write_bytes, &file, error); });
        if (status != HRBFNPR_STATUS_OK) return status;
        file.first.resize(file.second);
        Reading reading{file.first};
        hrbfnpr_model* loaded = nullptr;
        status = attempt([&] { return hrbfnpr_model_load(context_.get(), Reading::read, &reading, &loaded, error); });
        EXPECT_EQ(loaded != nullptr, status == HRBFNPR_STATUS_OK);
        if (const Model again(loaded); again) append(bytes, again);
        return status;
    });
    add(stages, "file.point_set", [this](Attempt& attempt, Bytes& bytes, hrbfnpr_error* error) {
        Bytes file(4 << 20);
        std::int64_t size = 0;
        auto status =
            attempt([&] { return hrbfnpr_point_set_save_memory(set_.get(), file.data(), 4 << 20, &size, error); });
        if (status != HRBFNPR_STATUS_OK) return status;
        hrbfnpr_point_set* loaded = nullptr;
        status =
            attempt([&] { return hrbfnpr_point_set_load_memory(context_.get(), file.data(), size, &loaded, error); });
        EXPECT_EQ(loaded != nullptr, status == HRBFNPR_STATUS_OK);
        if (const PointSet owned(loaded); owned) append(bytes, owned);
        return status;
    });
}

} // namespace api_test
