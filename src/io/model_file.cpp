// SPDX-License-Identifier: MIT
#include "io/check.h"
#include "io/model_sections.h"

namespace hrbfnpr::io {
namespace {

constexpr std::uint32_t tag_kind = tag("KIND");
constexpr std::uint32_t tag_model_numbers = tag("NUMB");
constexpr std::uint32_t tag_sample_position = tag("SPOS");
constexpr std::uint32_t tag_sample_normal = tag("SNRM");
constexpr std::uint32_t tag_centre[3] = {tag("CENX"), tag("CENY"), tag("CENZ")};
constexpr std::uint32_t tag_alpha = tag("ALPH");
constexpr std::uint32_t tag_beta[3] = {tag("BETX"), tag("BETY"), tag("BETZ")};
constexpr std::uint32_t tag_polynomial = tag("POLY");
constexpr std::uint32_t tag_report = tag("RPRT");

// Tags of the sections at the end of the file of a trimmed model.
constexpr std::uint32_t tag_trim = tag("TRIM");
constexpr std::uint32_t tag_trim_report = tag("TRRP");
constexpr std::uint32_t tag_trim_position = tag("TPOS");
constexpr std::uint32_t tag_trim_normal = tag("TNRM");
constexpr std::uint32_t tag_trim_kept = tag("TKEP");
constexpr std::uint32_t tag_trim_ends = tag("TEND");

constexpr std::int32_t highest_degree = 3;
constexpr std::int64_t longest_report = 1024;

// Limits for the inputs and results of a fit. The scale of a model is the spacing of its samples. It cannot be much
// less than 1e-9 diagonals, because a fit merges samples that are closer than this.
constexpr double smallest_side = 1e-110;
constexpr double most_scale_ratio = 1e12; // the largest ratio of the bounds' longest side to the scale
constexpr double radius_limit = 1e30;
// The limit of weights: the cube of the largest radius, times 1e30; a solver can still handle it.
constexpr double weight_limit = 1e120;

// Returns the number of terms of a polynomial in three variables of a degree from -1 to 3.
constexpr std::int64_t term_count(std::int32_t degree) noexcept {
    return std::int64_t{degree + 1} * (degree + 2) * (degree + 3) / 6;
}

using ModelNumbers = std::array<double, 12>;

ModelNumbers numbers_of(const implicit::HrbfData& data) noexcept {
    const auto& [low, high] = data.bounds;
    return {data.kernel_radius,
            data.centre.x,
            data.centre.y,
            data.centre.z,
            data.scale,
            low.x,
            low.y,
            low.z,
            high.x,
            high.y,
            high.z,
            data.spacing};
}

void set_numbers(implicit::HrbfData& data, const ModelNumbers& n) noexcept {
    data.kernel_radius = n[0];
    data.centre = {n[1], n[2], n[3]};
    data.scale = n[4];
    data.bounds = {{n[5], n[6], n[7]}, {n[8], n[9], n[10]}};
    data.spacing = n[11];
}

} // namespace

void encode_hrbf(Encoder& encoder, const implicit::HrbfData& data) {
    // The second number is not negative, because the degree is at least -1.
    const ModelKind kind{static_cast<std::uint32_t>(data.kernel),
                         static_cast<std::uint32_t>(data.polynomial_degree + 1)};
    encoder.section<std::uint32_t>(tag_kind, kind);
    encoder.section<double>(tag_model_numbers, numbers_of(data));
    encoder.section(tag_sample_position, data.sample_position.span());
    encoder.section(tag_sample_normal, data.sample_normal.span());
    encoder.section(tag_centre[0], data.centre_position.x.span());
    encoder.section(tag_centre[1], data.centre_position.y.span());
    encoder.section(tag_centre[2], data.centre_position.z.span());
    encoder.section(tag_alpha, data.alpha.span());
    encoder.section(tag_beta[0], data.beta.x.span());
    encoder.section(tag_beta[1], data.beta.y.span());
    encoder.section(tag_beta[2], data.beta.z.span());
    encoder.section(tag_polynomial, data.polynomial.span());
}

namespace {

void encode(Encoder& encoder, const TrimFile& trim) {
    const glm::dvec3& origin = trim.grid.origin;
    encoder.section<double>(tag_trim,
                            std::array{trim.limit, trim.closest, origin.x, origin.y, origin.z, trim.grid.side});
    encoder.section(tag_trim_report, trim.report.span());
    encoder.section(tag_trim_position, trim.position.span());
    encoder.section(tag_trim_normal, trim.normal.span());
    encoder.section(tag_trim_kept, trim.kept_cells.span());
    encoder.section(tag_trim_ends, trim.end_cells.span());
}

void decode(Decoder& decoder, TrimFile& trim) {
    std::array<double, 6> n{};
    decoder.section<double>(tag_trim, n);
    trim.limit = n[0];
    trim.closest = n[1];
    trim.grid = {{n[2], n[3], n[4]}, n[5]};
    decoder.section(tag_trim_report, trim.report);
    decoder.section(tag_trim_position, trim.position);
    decoder.section(tag_trim_normal, trim.normal, trim.position.size());
    decoder.section(tag_trim_kept, trim.kept_cells);
    decoder.section(tag_trim_ends, trim.end_cells);
}

void set_kind(const Decoder& decoder, const ModelKind& kind, implicit::HrbfData& data) {
    if (kind[0] > static_cast<std::uint32_t>(kernel::Kind::wendland_c2)) decoder.damaged("its kernel is unknown");
    if (kind[1] > highest_degree + 1) decoder.damaged("its polynomial degree is unknown");
    data.kernel = static_cast<kernel::Kind>(kind[0]);
    data.polynomial_degree = static_cast<std::int32_t>(kind[1]) - 1;
}

void decode_arrays(Decoder& decoder, implicit::HrbfData& data) {
    decoder.section(tag_sample_position, data.sample_position);
    const std::int64_t count = data.sample_position.size() / 3;
    if (count < 1 || data.sample_position.size() != 3 * count) decoder.damaged("its number of samples is wrong");
    decoder.section(tag_sample_normal, data.sample_normal, 3 * count);
    decoder.section(tag_centre[0], data.centre_position.x, count);
    decoder.section(tag_centre[1], data.centre_position.y, count);
    decoder.section(tag_centre[2], data.centre_position.z, count);
    decoder.section(tag_alpha, data.alpha, count);
    decoder.section(tag_beta[0], data.beta.x, count);
    decoder.section(tag_beta[1], data.beta.y, count);
    decoder.section(tag_beta[2], data.beta.z, count);
    decoder.section(tag_polynomial, data.polynomial, term_count(data.polynomial_degree));
}

void check_extent(const Decoder& decoder, const implicit::HrbfData& data) {
    check_bounds(decoder, data.bounds);
    for (int axis = 0; axis < 3; ++axis) {
        if (data.bounds.min[axis] < -coordinate_limit || data.bounds.max[axis] > coordinate_limit)
            decoder.damaged("its bounds reach beyond 1e100");
        if (!(data.centre[axis] >= data.bounds.min[axis] && data.centre[axis] <= data.bounds.max[axis]))
            decoder.damaged("its centre is outside its bounds");
    }
    const double side = longest_side(data.bounds);
    if (side > 0.0 && side < smallest_side) decoder.damaged("its bounds are smaller than 1e-110");
    if (data.spacing > 2.0 * side) decoder.damaged("its sample spacing is larger than its bounds");
    // A fit to a single sample has the scale 1, whatever its bounds are.
    if (data.count() > 1 ? data.scale > 2.0 * side || data.scale < side / most_scale_ratio : data.scale != 1.0)
        decoder.damaged("its scale does not fit its bounds");
}

void check_numbers(const Decoder& decoder, const implicit::HrbfData& data) {
    const ModelNumbers numbers = numbers_of(data);
    check_finite<double>(decoder, "numbers", numbers);
    if (!(data.scale > 0.0)) decoder.damaged("its scale is not positive");
    if (data.kernel_radius < 0.0 || (data.kernel_radius == 0.0 && data.kernel != kernel::Kind::triharmonic))
        decoder.damaged("its kernel radius is not positive");
    if (data.spacing < 0.0) decoder.damaged("its sample spacing is negative");
    check_extent(decoder, data);
    // A radius that the fit chose may be as large as the bounds.
    if (data.kernel != kernel::Kind::triharmonic &&
        (data.kernel_radius < 1.0 / radius_limit ||
         data.kernel_radius > std::max(radius_limit, 2.0 * longest_side(data.bounds) / data.scale)))
        decoder.damaged("its kernel radius is out of range");
}

void check_weights(const Decoder& decoder, const implicit::HrbfData& data, const char* name,
                   std::span<const double> weights) {
    check_finite(decoder, name, weights);
    if (data.kernel_radius > radius_limit) return;
    for (std::size_t i = 0; i < weights.size(); ++i)
        if (std::abs(weights[i]) > weight_limit)
            decoder.damaged("%s[%lld] is too large for a fit", name, static_cast<long long>(i));
}

// Checks that each centre coincides with its sample up to rounding.
void check_places(const Decoder& decoder, const implicit::HrbfData& data) {
    for (std::int64_t i = 0; i < data.count(); ++i) {
        const glm::dvec3 centre = data.centre_position[i];
        check_sample(decoder, data.bounds, data.sample_position.data() + 3 * i, i);
        for (int axis = 0; axis < 3; ++axis) {
            const double sample = data.sample_position[3 * i + axis];
            const double expected = implicit::normalised(sample, data.centre[axis], data.scale);
            const double off = 1e-6 * (1.0 + std::abs(expected)) + 1e-15 * std::abs(sample) / data.scale;
            if (!(std::abs(centre[axis] - expected) <= off))
                decoder.damaged("centre[%lld] is not at its sample", static_cast<long long>(i));
        }
    }
}

void check_arrays(const Decoder& decoder, const implicit::HrbfData& data) {
    check_finite(decoder, "sample_position", data.sample_position.span());
    check_unit(decoder, "sample_normal", data.sample_normal.span());
    check_finite(decoder, "centre.x", data.centre_position.x.span());
    check_finite(decoder, "centre.y", data.centre_position.y.span());
    check_finite(decoder, "centre.z", data.centre_position.z.span());
    check_weights(decoder, data, "alpha", data.alpha.span());
    check_weights(decoder, data, "beta.x", data.beta.x.span());
    check_weights(decoder, data, "beta.y", data.beta.y.span());
    check_weights(decoder, data, "beta.z", data.beta.z.span());
    check_weights(decoder, data, "polynomial", data.polynomial.span());
    check_places(decoder, data);
}

void check(const Decoder& decoder, const TrimFile& trim) {
    const glm::dvec3& origin = trim.grid.origin;
    const std::array<double, 6> numbers{trim.limit, trim.closest, origin.x, origin.y, origin.z, trim.grid.side};
    check_finite<double>(decoder, "trim", numbers);
    if (!(trim.limit > 0.0) || trim.closest < 0.0 || !(trim.grid.side > 0.0))
        decoder.damaged("the limit, spacing or cell side of its trim is out of range");
    if (trim.report.size() > longest_report) decoder.damaged("the report of its trim is too long");
    if (trim.position.empty() || trim.position.size() % 3 != 0)
        decoder.damaged("the number of samples of its trim is wrong");
    check_finite(decoder, "trim.position", trim.position.span());
    for (const double x : trim.position)
        if (std::abs(x) > coordinate_limit) decoder.damaged("its trim has a sample beyond 1e100");
    check_unit(decoder, "trim.normal", trim.normal.span());
    for (const auto* cells : {&trim.kept_cells, &trim.end_cells})
        for (const std::int64_t cell : *cells)
            if (cell < 0) decoder.damaged("its trim has an invalid cell");
}

} // namespace

void encode_kind(Encoder& encoder, const ModelKind& kind) { encoder.section<std::uint32_t>(tag_kind, kind); }

ModelKind decode_kind(Decoder& decoder) {
    ModelKind kind{};
    decoder.section<std::uint32_t>(tag_kind, kind);
    return kind;
}

void decode_hrbf(Decoder& decoder, const ModelKind& kind, implicit::HrbfData& data) {
    set_kind(decoder, kind, data);
    ModelNumbers numbers{};
    decoder.section<double>(tag_model_numbers, numbers);
    set_numbers(data, numbers);
    decode_arrays(decoder, data);
}

void check_hrbf(const Decoder& decoder, const implicit::HrbfData& data) {
    check_numbers(decoder, data);
    check_arrays(decoder, data);
}

void encode_fit(Encoder& encoder, const FitToSave& fit) {
    if (fit.pieces != nullptr) {
        encode_kind(encoder, {sheets_kind, 0});
        encode_pieces(encoder, *fit.pieces);
    } else {
        encode_hrbf(encoder, *fit.data);
    }
    encoder.section(tag_report, fit.report);
}

void decode_fit(Decoder& decoder, const ModelKind& kind, FitFile& file) {
    if (kind == ModelKind{sheets_kind, 0} && decoder.version() > fit_version)
        decode_pieces(decoder, file.pieces.emplace(file.report.memory()));
    else
        decode_hrbf(decoder, kind, file.data);
    decoder.section(tag_report, file.report);
}

void check_fit(const Decoder& decoder, const FitFile& file) {
    if (file.report.size() > longest_report) decoder.damaged("its report is too long");
    if (file.pieces)
        check_pieces(decoder, *file.pieces);
    else
        check_hrbf(decoder, file.data);
}

void encode_trim(Encoder& encoder, const TrimFile* trim) {
    if (trim != nullptr && !trim->position.empty()) encode(encoder, *trim);
}

void save_model(const FitToSave& fit, const TrimFile* trim, Writer& writer) {
    const std::uint32_t version = fit.pieces != nullptr ? model_version : fit_version;
    write_file(writer, kind_model, version, [&](Encoder& encoder) {
        encode_fit(encoder, fit);
        encode_trim(encoder, trim);
    });
}

ModelFile load_model(base::Memory& memory, Reader& reader) {
    Decoder decoder(reader, kind_model, fit_version, model_version, "model");
    ModelFile file(memory);
    const ModelKind kind = decode_kind(decoder);
    const bool is_tree = kind[0] == csg_kind && decoder.version() > fit_version;
    if (is_tree)
        decode_csg(decoder, kind, file);
    else
        decode_fit(decoder, kind, file);
    const bool trimmed = decoder.has_more();
    if (trimmed) decode(decoder, file.trim);
    decoder.finish();
    if (is_tree)
        check_csg(decoder, file);
    else
        check_fit(decoder, file);
    if (trimmed) check(decoder, file.trim);
    return file;
}

} // namespace hrbfnpr::io
