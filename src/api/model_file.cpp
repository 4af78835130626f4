// Saving and loading models.
#include "api/barrier.h"
#include "api/model.h"
#include "api/streams.h"
#include "io/files.h"

#include <array>

using namespace hrbfnpr;

namespace hrbfnpr::api {
namespace {

using Numbers = std::array<double, 16>;

Numbers numbers_of(const fit::FitReport& report) noexcept {
    return {static_cast<double>(report.samples),
            static_cast<double>(report.merged_samples),
            static_cast<double>(report.rescaled_normals),
            report.kernel_radius,
            report.regularization,
            report.value_residual_max,
            report.value_residual_rms,
            report.gradient_residual_max,
            report.gradient_residual_rms,
            report.solver_residual,
            report.condition_estimate,
            static_cast<double>(report.iterations),
            report.fallback ? 1.0 : 0.0,
            report.seconds_assemble,
            report.seconds_solve,
            report.seconds_total};
}

// A count out of a file may be any number.
std::int64_t count_of(double number) noexcept {
    constexpr double largest = 9007199254740992.0; // 2^53
    return number >= 0.0 && number <= largest ? static_cast<std::int64_t>(number) : 0;
}

fit::FitReport report_of(std::span<const double> stored) noexcept {
    Numbers n{};
    std::copy_n(stored.begin(), std::min(stored.size(), n.size()), n.begin());
    fit::FitReport report;
    report.samples = count_of(n[0]);
    report.merged_samples = count_of(n[1]);
    report.rescaled_normals = count_of(n[2]);
    report.kernel_radius = n[3];
    report.regularization = n[4];
    report.value_residual_max = n[5];
    report.value_residual_rms = n[6];
    report.gradient_residual_max = n[7];
    report.gradient_residual_rms = n[8];
    report.solver_residual = n[9];
    report.condition_estimate = n[10];
    report.iterations = static_cast<std::int32_t>(std::min<std::int64_t>(count_of(n[11]), 1000000));
    report.fallback = n[12] == 1.0;
    report.seconds_assemble = n[13];
    report.seconds_solve = n[14];
    report.seconds_total = n[15];
    return report;
}

void save(const hrbfnpr_model& model, io::Writer& writer) {
    const implicit::HrbfData* data = model.data();
    if (data == nullptr)
        fail(Status::invalid_argument, "model is a custom one: its function cannot be saved; only fits can");
    io::save_model(*data, numbers_of(model.report), writer);
}

hrbfnpr_model* load(hrbfnpr_context& context, io::Reader& reader) {
    io::ModelFile file = io::load_model(context.runtime.memory, reader);
    return make_handle<hrbfnpr_model>(context, std::move(file.data), report_of(file.report.span()));
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_model_save(const hrbfnpr_model* model, hrbfnpr_write_fn write, void* user,
                                  hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        if (write == nullptr) fail(Status::invalid_argument, "write is NULL");
        api::CallbackWriter writer(write, user);
        api::save(handle, writer);
    });
}

hrbfnpr_status hrbfnpr_model_save_memory(const hrbfnpr_model* model, void* destination, int64_t capacity, int64_t* size,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        api::save_to_memory(destination, capacity, size, [&](io::Writer& writer) { api::save(handle, writer); });
    });
}

hrbfnpr_status hrbfnpr_model_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user, hrbfnpr_model** out_model,
                                  hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        auto& parent = api::deref(context, "context");
        if (read == nullptr) fail(Status::invalid_argument, "read is NULL");
        api::CallbackReader reader(read, user);
        return api::load(parent, reader);
    });
}

hrbfnpr_status hrbfnpr_model_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
                                         hrbfnpr_model** out_model, hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        auto& parent = api::deref(context, "context");
        io::MemoryReader reader = api::memory_reader(data, size);
        return api::load(parent, reader);
    });
}

} // extern "C"
