// SPDX-License-Identifier: MIT
// Saves and loads models.
#include "api/barrier.h"
#include "api/model.h"
#include "api/streams.h"
#include "io/files.h"

#include <array>

using namespace hrbfnpr;

namespace hrbfnpr::api {
namespace {

// The numbers of a report. New numbers must be added at the end, because older files have fewer numbers.
using Numbers = std::array<double, 32>;

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
            report.seconds_total,
            static_cast<double>(report.solver),
            static_cast<double>(report.solver_reason),
            static_cast<double>(report.outliers_found),
            static_cast<double>(report.outliers_dropped),
            static_cast<double>(report.flipped_found),
            static_cast<double>(report.flipped_repaired),
            static_cast<double>(report.near_duplicates),
            report.noise_estimate,
            report.input_distance_max,
            report.input_distance_rms,
            report.input_share_within,
            static_cast<double>(report.choice_rounds),
            report.seconds_clean,
            report.seconds_choose,
            report.seconds_precondition,
            static_cast<double>(report.peak_bytes)};
}

// Converts a number from a file, which may have any value, into a count.
std::int64_t count_of(double number) noexcept {
    constexpr double largest = 9007199254740992.0; // 2^53, up to which doubles hold all whole numbers
    return number >= 0.0 && number <= largest ? static_cast<std::int64_t>(number) : 0;
}

std::int32_t small_count_of(double number) noexcept {
    return static_cast<std::int32_t>(std::min<std::int64_t>(count_of(number), 1000000));
}

// Reads the numbers that files of version 0.1 do not have. Without these numbers, the report keeps its defaults.
void read_rest(std::span<const double> stored, const Numbers& n, fit::FitReport& report) noexcept {
    if (stored.size() < n.size()) return;
    if (n[16] == static_cast<double>(fit::SolverKind::iterative)) report.solver = fit::SolverKind::iterative;
    report.solver_reason = static_cast<fit::SolverReason>(
        std::min<std::int64_t>(count_of(n[17]), static_cast<std::int64_t>(fit::SolverReason::not_definite)));
    report.outliers_found = count_of(n[18]);
    report.outliers_dropped = count_of(n[19]);
    report.flipped_found = count_of(n[20]);
    report.flipped_repaired = count_of(n[21]);
    report.near_duplicates = count_of(n[22]);
    report.noise_estimate = n[23];
    report.input_distance_max = n[24];
    report.input_distance_rms = n[25];
    report.input_share_within = n[26];
    report.choice_rounds = small_count_of(n[27]);
    report.seconds_clean = n[28];
    report.seconds_choose = n[29];
    report.seconds_precondition = n[30];
    report.peak_bytes = count_of(n[31]);
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
    report.iterations = small_count_of(n[11]);
    report.fallback = n[12] == 1.0;
    report.seconds_assemble = n[13];
    report.seconds_solve = n[14];
    report.seconds_total = n[15];
    read_rest(stored, n, report);
    return report;
}

// Packs the vectors in the order of the given samples, not in the order of the support. Otherwise loading would make a
// different support, and saving that support a different file.
void pack(base::Array<double>& packed, const surface::Support& support, const geometry::VecArray& vectors) {
    packed.resize(3 * vectors.size());
    for (std::int64_t at = 0; at < vectors.size(); ++at)
        for (int c = 0; c < 3; ++c) packed[3 * support.index(at) + c] = vectors[at][c];
}

geometry::VecArray unpacked(const base::Array<double>& packed) {
    geometry::VecArray vectors(packed.memory());
    for (std::int64_t i = 0; i + 2 < packed.size(); i += 3)
        vectors.push_back({packed[i], packed[i + 1], packed[i + 2]});
    return vectors;
}

io::TrimFile file_of(base::Memory& memory, const generate::FoundTrim& found) {
    io::TrimFile file(memory);
    if (found.trim == nullptr) return file;
    const surface::Support& support = found.trim->support();
    file.limit = found.trim->limit();
    file.closest = found.trim->closest();
    file.grid = support.grid();
    pack(file.position, support, support.positions());
    pack(file.normal, support, support.normals());
    for (const std::uint64_t cell : support.kept().packed()) file.kept_cells.push_back(static_cast<std::int64_t>(cell));
    for (const std::uint64_t cell : support.ends().packed()) file.end_cells.push_back(static_cast<std::int64_t>(cell));
    const generate::TrimReport& report = found.report;
    for (const double number : {static_cast<double>(report.parts), static_cast<double>(report.parts_to_end),
                                report.share, report.farthest, report.spacing})
        file.report.push_back(number);
    return file;
}

generate::FoundTrim trim_of(const base::Runtime& runtime, const io::TrimFile& file) {
    surface::Support support(runtime, unpacked(file.position), unpacked(file.normal), file.closest);
    geometry::CellSet kept(runtime.memory);
    geometry::CellSet ends(runtime.memory);
    for (const std::int64_t cell : file.kept_cells) kept.insert(static_cast<std::uint64_t>(cell));
    for (const std::int64_t cell : file.end_cells) ends.insert(static_cast<std::uint64_t>(cell));
    support.keep(file.grid, std::move(kept), std::move(ends), file.limit);
    std::array<double, 5> n{};
    std::copy_n(file.report.begin(), std::min<std::int64_t>(file.report.size(), 5), n.begin());
    generate::FoundTrim found;
    found.report = {support.samples(), count_of(n[0]), count_of(n[1]), n[2], n[3], n[4]};
    found.trim = std::make_unique<surface::SupportDomain>(std::move(support), file.limit, file.closest);
    return found;
}

void save_csg(const CsgSolid& solid, const io::TrimFile& trim, io::Writer& writer) {
    base::Memory& memory = solid.tree().memory();
    base::Array<Numbers> reports(memory, solid.models().size());
    base::Array<io::FitToSave> leaves(memory);
    for (const hrbfnpr_model* leaf : solid.models()) {
        if (leaf->data() == nullptr && leaf->pieces() == nullptr)
            fail(Status::invalid_argument,
                 "model is a CSG tree with a custom model in it; the function of a custom model cannot be saved");
        Numbers& report = reports[leaves.size()];
        report = numbers_of(leaf->report);
        leaves.push_back({leaf->data(), leaf->pieces(), report});
    }
    io::save_csg(solid.tree(), solid.function().bounds(), leaves.span(), &trim, writer);
}

void save(const hrbfnpr_model& model, io::Writer& writer) {
    const io::TrimFile trim = file_of(model.runtime().memory, model.trim());
    if (const CsgSolid* const solid = model.untrimmed().csg()) return save_csg(*solid, trim, writer);
    const implicit::HrbfData* data = model.data();
    const implicit::SheetTreeData* pieces = model.pieces();
    if (data == nullptr && pieces == nullptr)
        fail(Status::invalid_argument,
             "model is a custom model, and its function cannot be saved; save a fit, or a CSG tree of fits");
    io::save_model({data, pieces, numbers_of(model.untrimmed().report)}, &trim, writer);
}

// Makes a model from the data of a file. The data is moved.
hrbfnpr_model* model_of(hrbfnpr_context& context, io::FitFile& file) {
    const fit::FitReport report = report_of(file.report.span());
    if (file.pieces) return make_handle<hrbfnpr_model>(context, std::move(*file.pieces), report);
    return make_handle<hrbfnpr_model>(
        context, fit::FitResult{std::move(file.data), report, base::Array<double>(context.runtime.memory)});
}

// Invalid nodes are reported as a damaged file, because the caller did not make them.
hrbfnpr_model* tree_of(hrbfnpr_context& context, io::ModelFile& file) {
    try {
        check_csg_tree("nodes", file.tree);
        auto solid = std::make_unique<CsgSolid>(context.runtime);
        for (std::int64_t i = 0; i < file.leaves.size(); ++i) {
            const hrbfnpr_model* const model = model_of(context, file.leaves[i]);
            const HandleHold<const hrbfnpr_model> hold(model);
            release_handle(model);
            static_cast<void>(solid->leaf(*model));
        }
        for (const implicit::CsgNode& node : file.tree) static_cast<void>(solid->add(node));
        return make_csg_model(context, std::move(solid), &file.bounds);
    } catch (const Error& error) {
        if (error.status() != Status::invalid_argument) throw;
        fail(Status::corrupt_data, "this model file is damaged: %s", error.what());
    }
}

hrbfnpr_model* read_model(hrbfnpr_context& context, io::Reader& reader) {
    io::ModelFile file = io::load_model(context.runtime.memory, reader);
    auto* const model = file.tree.empty() ? model_of(context, file) : tree_of(context, file);
    if (file.trim.position.empty()) return model;
    const HandleHold<hrbfnpr_model> whole(model); // This object now owns the model.
    release_handle(model);
    return make_handle<hrbfnpr_model>(context, *model, trim_of(context.runtime, file.trim));
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
        return api::read_model(parent, reader);
    });
}

hrbfnpr_status hrbfnpr_model_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
                                         hrbfnpr_model** out_model, hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        auto& parent = api::deref(context, "context");
        io::MemoryReader reader = api::memory_reader(data, size);
        return api::read_model(parent, reader);
    });
}

} // extern "C"
