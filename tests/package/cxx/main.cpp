// SPDX-License-Identifier: MIT
// One sample is a plane: z at (0, 0, 2) must be 2.  Prints "2" and the version.
#include <cmath>
#include <hrbfnpr.h>
#include <iostream>
#include <memory>
#include <stdexcept>

namespace {

void check(hrbfnpr_status status, const hrbfnpr_error& error) {
    if (status != HRBFNPR_STATUS_OK) throw std::runtime_error(error.message);
}

hrbfnpr_array view(const double (&xyz)[3]) { return {xyz, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3}; }

double distance_to_plane() {
    const double point[3] = {0, 0, 0};
    const double normal[3] = {0, 0, 1};
    const double query[3] = {0, 0, 2};
    hrbfnpr_error error;
    hrbfnpr_error_init(&error, sizeof error);
    hrbfnpr_fit_desc desc;
    hrbfnpr_fit_desc_init(&desc, sizeof desc);
    desc.points = view(point);
    desc.normals = view(normal);

    hrbfnpr_context* raw_context = nullptr;
    check(hrbfnpr_context_create(nullptr, &raw_context, &error), error);
    const std::unique_ptr<hrbfnpr_context, void (*)(hrbfnpr_context*)> context(raw_context, hrbfnpr_context_release);
    hrbfnpr_model* raw_model = nullptr;
    check(hrbfnpr_model_fit(context.get(), &desc, nullptr, &raw_model, &error), error);
    const std::unique_ptr<hrbfnpr_model, void (*)(const hrbfnpr_model*)> model(raw_model, hrbfnpr_model_release);

    double value = 0;
    const hrbfnpr_array queries = view(query);
    const hrbfnpr_array_out values = {&value, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    check(hrbfnpr_model_evaluate(model.get(), &queries, &values, nullptr, nullptr, nullptr, &error), error);
    return value;
}

} // namespace

int main() {
    try {
        const double value = distance_to_plane();
        std::cout << value << ' ' << hrbfnpr_version_string() << '\n';
        return std::abs(value - 2) < 1e-6 ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}
