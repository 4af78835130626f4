// SPDX-License-Identifier: MIT
#include "painted.h"

#include "arrays.h"
#include "fields.h"
#include "limits.h"
#include "samples.h"
#include "scenes.h"

#include <algorithm>
#include <cmath>

namespace fuzz {
namespace {

constexpr std::initializer_list<hrbfnpr_status> failures = {
    HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_OUT_OF_MEMORY, HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
    HRBFNPR_STATUS_CALLBACK, HRBFNPR_STATUS_CANCELLED};

std::int32_t evaluate(void* user, std::int64_t count, const double* positions, const double* normals, double* values,
                      double* weights) {
    const auto& function = *static_cast<const Paint::Function*>(user);
    for (std::int64_t i = 0; i < count; ++i) {
        for (std::uint32_t c = 0; c < function.components; ++c)
            values[i * function.components + c] = 0.5 + positions[3 * i + c % 3];
        if (function.oddity == 0) weights[i] = std::abs(normals[3 * i]) > 0.5 ? 1.0 : 0.0;
    }
    if (count > 0 && function.oddity == 1) values[0] = std::nan("");
    if (count > 0 && function.oddity == 2) weights[0] = 1.5;
    return function.oddity == 3 ? 1 : 0;
}

// Returns values around the range from 0 to 1, sometimes with an odd one.
std::vector<double> some_values(std::size_t count, Input& input) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = 0.5 + 0.7 * std::sin(static_cast<double>(i));
    if (count > 0 && input.once_in(4)) values[input.below(count)] = odd_float(0.5, 1e308, input);
    return values;
}

std::vector<std::uint32_t> some_triangles(std::size_t points, Input& input) {
    std::vector<std::uint32_t> corners(3 * (input.once_in(2) ? input.below(40) : 0));
    for (std::uint32_t& corner : corners) corner = static_cast<std::uint32_t>(input.below(points));
    if (!corners.empty() && input.once_in(8)) corners[0] = odd_integer(corners[0], 0U, input);
    return corners;
}

std::vector<hrbfnpr_dab> some_dabs(const Samples& on, Input& input) {
    std::vector<hrbfnpr_dab> dabs(input.below(6));
    for (hrbfnpr_dab& dab : dabs) {
        hrbfnpr_dab_init(&dab, sizeof dab);
        const std::size_t place = on.points.empty() ? 0 : 3 * input.below(on.points.size() / 3);
        for (std::size_t c = 0; c < 3 && place + c < on.points.size(); ++c) {
            dab.position[c] = on.points[place + c];
            dab.normal[c] = on.normals[place + c];
            dab.direction[c] = input.between(-1.0, 1.0);
        }
        dab.radius = input.between(0.001, 2.0);
        dab.value = input.unit();
        if (input.once_in(4)) change_fields(input, "hrbfnpr_dab", &dab);
    }
    return dabs;
}

// A camera and an image, and what hides places from it.
struct Projected {
    explicit Projected(Input& input) {
        for (std::size_t i = 0; i < std::size(pixels); ++i) pixels[i] = static_cast<float>(i % 5) / 4.0F;
        if (input.once_in(4)) pixels[input.below(std::size(pixels))] = odd_float(0.5F, 2.0F, input);
        hrbfnpr_image_init(&image, sizeof image);
        image.format = input.once_in(4) ? HRBFNPR_FORMAT_RGBA8 : HRBFNPR_FORMAT_RGBA32F;
        image.width = 3;
        image.height = 2;
        image.pixels = pixels;
        const double low[3] = {-1.4, -1.4, -1.0}, high[3] = {1.4, 1.4, 1.0}, up[3] = {0.1, 1.0, 0.2};
        const double direction[3] = {input.between(-1.0, 1.0), 0.5, input.between(-1.0, 1.0)};
        hrbfnpr_camera_init(&camera, sizeof camera);
        Call fit("camera_fit_bounds");
        fit.expect(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, input.once_in(2) ? 0.0 : 0.6, 60.0,
                                             40.0, 0.05, fit.error()));
        if (input.once_in(4)) change_fields(input, "hrbfnpr_camera", &camera);
        if (!input.once_in(3)) return;
        hrbfnpr_item item;
        hrbfnpr_item_init(&item, sizeof item);
        item.line_set = scene_lines(input.below(line_set_count));
        Call gather("occluders_create");
        gather.expect(
            hrbfnpr_occluders_create(scene_context().handle, &item, 1, 0, nullptr, &occluders, gather.error()));
    }
    Projected(const Projected&) = delete;
    Projected& operator=(const Projected&) = delete;
    ~Projected() { hrbfnpr_occluders_release(occluders); }

    float pixels[4 * 3 * 2];
    hrbfnpr_image image;
    hrbfnpr_camera camera;
    hrbfnpr_occluders* occluders = nullptr;
};

// Asks for the values at the places of samples.
void evaluate_at(const hrbfnpr_field* field, std::uint32_t components, const Samples& places, Input& input) {
    const Array positions(places.points, 3, input), normals(places.normals, 3, input);
    const Room values(places.count(), components, HRBFNPR_SCALAR_FLOAT64);
    const Room weights(places.count(), 1, HRBFNPR_SCALAR_FLOAT64);
    const Operation operation(scene_context(), input);
    Call call("field_evaluate");
    const hrbfnpr_status status = hrbfnpr_field_evaluate(field, &positions.view, &normals.view, &values.out,
                                                         &weights.out, operation.handle, call.error());
    operation.check(status);
    if (!call.expect(status, failures)) return;
    require(values.is_finite(), "the values of a field are finite");
    for (const double weight : weights.numbers<double>())
        require(weight >= 0.0 && weight <= 1.0, "the weights of a field are from 0 to 1");
}

// Makes a field of a kind. Returns null if it is refused.
const hrbfnpr_field* make_field(std::uint32_t kind, Paint::Function& function, Input& input) {
    const std::uint32_t components = kind == HRBFNPR_FIELD_KIND_SCALAR ? 1 : 3;
    function = {components, input.below(16)};
    const Samples samples = some_samples(input, 60);
    const std::size_t count = samples.points.size() / 3;
    const Array points(samples.points, 3, input), values(some_values(components * count, input), components, input);
    std::vector<std::uint32_t> corners;
    if (count > 0) corners = some_triangles(count, input);
    const std::vector<hrbfnpr_dab> dabs = some_dabs(samples, input);
    const Projected projected(input);
    hrbfnpr_field_desc desc;
    hrbfnpr_field_desc_init(&desc, sizeof desc);
    desc.kind = kind;
    desc.source = static_cast<std::uint32_t>(input.below(4));
    desc.points = points.view;
    desc.values = values.view;
    if (!corners.empty())
        desc.triangles = {corners.data(), static_cast<std::int64_t>(corners.size() / 3), 0, HRBFNPR_SCALAR_UINT32, 3};
    desc.function = evaluate;
    desc.user = &function;
    desc.dabs = dabs.data();
    desc.dab_count = static_cast<std::int64_t>(dabs.size());
    desc.image = &projected.image;
    desc.camera = &projected.camera;
    desc.occluders = projected.occluders;
    // The function must know how many numbers it writes.
    if (input.once_in(2)) change_fields(input, "hrbfnpr_field_desc", &desc, {"kind", "struct_size"});
    const Operation operation(scene_context(), input);
    hrbfnpr_field* field = nullptr;
    Call call("field_create");
    const hrbfnpr_status status =
        hrbfnpr_field_create(scene_context().handle, &desc, operation.handle, &field, call.error());
    operation.check(status);
    require(call.expect(status, failures) == (field != nullptr), "a handle comes with success only");
    if (field != nullptr) evaluate_at(field, components, samples, input);
    return field;
}

void require_finite(const hrbfnpr_array& array) {
    const std::span numbers(static_cast<const float*>(array.data),
                            static_cast<std::size_t>(array.count) * array.components);
    require(std::all_of(numbers.begin(), numbers.end(), [](float number) { return std::isfinite(number); }),
            "marks have finite values");
}

void view_fields(const hrbfnpr_point_set* set) {
    hrbfnpr_point_set_info info;
    hrbfnpr_point_set_info_init(&info, sizeof info);
    Call ask("point_set_get_info");
    ask.expect(hrbfnpr_point_set_get_info(set, &info, ask.error()));
    for (std::int64_t number = 0; number < info.field_count; ++number) {
        const char* name = nullptr;
        Call get("point_set_get_field");
        get.expect(hrbfnpr_point_set_get_field(set, number, &name, nullptr, get.error()));
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            hrbfnpr_array values, weights;
            Call view("point_set_view_field");
            view.expect(hrbfnpr_point_set_view_field(set, layer, name, &values, &weights, view.error()));
            require_finite(values);
            require_finite(weights);
        }
    }
}

// Whatever values marks have, a file can hold them.
void save_and_load(const hrbfnpr_point_set* set) {
    std::int64_t size = 0;
    Call measure("point_set_save_memory");
    measure.expect(hrbfnpr_point_set_save_memory(set, nullptr, 0, &size, measure.error()),
                   {HRBFNPR_STATUS_BUFFER_TOO_SMALL});
    Bytes file(static_cast<std::size_t>(size));
    Call save("point_set_save_memory");
    save.expect(hrbfnpr_point_set_save_memory(set, file.data(), size, &size, save.error()));
    hrbfnpr_point_set* loaded = nullptr;
    Call load("point_set_load_memory");
    load.expect(hrbfnpr_point_set_load_memory(scene_context().handle, file.data(), size, &loaded, load.error()));
    view_fields(loaded);
    hrbfnpr_point_set_release(loaded);
}

} // namespace

Paint::Paint(Input& input) {
    for (std::uint32_t kind = 0; kind < fields_.size(); ++kind)
        fields_[kind] = make_field(kind, functions_[kind], input);
}

Paint::~Paint() {
    for (const hrbfnpr_point_set* const set : sets_) hrbfnpr_point_set_release(set);
    for (const hrbfnpr_field* const field : fields_) hrbfnpr_field_release(field);
}

const hrbfnpr_point_set* Paint::on(const hrbfnpr_point_set* set, Input& input) {
    double transform[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    double& number = transform[input.below(16)];
    if (input.once_in(2)) number = odd_float(number, 0.5, input);
    std::array<hrbfnpr_mark_field, 3> list;
    for (std::size_t kind = 0; kind < list.size(); ++kind) {
        hrbfnpr_mark_field_init(&list[kind], sizeof list[kind]);
        list[kind].name = field_names[kind];
        list[kind].field = fields_[kind];
        if (input.once_in(3)) list[kind].transform = transform;
        if (input.once_in(8)) change_fields(input, "hrbfnpr_mark_field", &list[kind]);
    }
    const Operation operation(scene_context(), input);
    hrbfnpr_point_set* painted = nullptr;
    {
        const ShortMemory memory(scene_context(), input);
        Call call("point_set_with_fields");
        const hrbfnpr_status status =
            hrbfnpr_point_set_with_fields(scene_context().handle, set, list.data(), list.size(), sizeof list[0],
                                          operation.handle, &painted, call.error());
        operation.check(status);
        require(call.expect(status, failures) == (painted != nullptr), "a handle comes with success only");
    }
    if (painted == nullptr) return set;
    sets_.push_back(painted);
    view_fields(painted);
    if (input.once_in(4)) save_and_load(painted);
    return painted;
}

} // namespace fuzz
