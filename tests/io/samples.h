// SPDX-License-Identifier: MIT
// Small models and point sets for the tests of files, and readers and writers of files in memory.
#pragma once

#include "base/random.h"
#include "io/crc32.h"
#include "io/files.h"
#include "io/format.h"
#include "io/stream.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace hrbfnpr::io::samples {

using Bytes = std::vector<std::uint8_t>;

class BytesWriter final : public Writer {
public:
    void write(const void* data, std::uint64_t size) override {
        const auto* begin = static_cast<const std::uint8_t*>(data);
        bytes.insert(bytes.end(), begin, begin + size);
    }
    Bytes bytes;
};

// Gives at most `step` bytes at a time, as a pipe does.
class TrickleReader final : public Reader {
public:
    TrickleReader(const Bytes& bytes, std::uint64_t step) : bytes_(bytes), step_(step) {}
    std::uint64_t read(void* data, std::uint64_t size) override {
        const std::uint64_t count = std::min({size, step_, bytes_.size() - at_});
        std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), count, static_cast<std::uint8_t*>(data));
        at_ += count;
        return count;
    }

private:
    const Bytes& bytes_;
    std::uint64_t step_;
    std::uint64_t at_ = 0;
};

inline double number(std::int64_t index) {
    return base::uniform4(7, static_cast<std::uint64_t>(index), base::Purpose::candidate)[0] - 0.5;
}

inline implicit::HrbfData model(base::Memory& memory, std::int64_t count, kernel::Kind kind = kernel::Kind::triharmonic,
                                std::int32_t degree = 1) {
    implicit::HrbfData data(memory);
    data.kernel = kind;
    data.kernel_radius = kind == kernel::Kind::triharmonic ? 0.0 : 2.5;
    data.polynomial_degree = degree;
    data.bounds = {{0.0, -4.0, 1.0}, {2.0, 0.0, 5.0}};
    data.centre = data.bounds.centre();
    data.scale = 0.25;
    data.spacing = 0.25;
    data.sample_normal.resize(3 * count);
    for (std::int64_t i = 0; i < count; ++i) {
        glm::dvec3 sample;
        for (int k = 0; k < 3; ++k) sample[k] = data.centre[k] + number(3 * i + k);
        for (int k = 0; k < 3; ++k) data.sample_position.push_back(sample[k]);
        data.sample_normal[3 * i + i % 3] = 1.0;
        data.centre_position.push_back((sample - data.centre) / data.scale);
        data.beta.push_back({number(400 + i), number(500 + i), number(600 + i)});
        data.alpha.push_back(number(700 + i));
    }
    for (int i = 0; i < (degree + 1) * (degree + 2) * (degree + 3) / 6; ++i) data.polynomial.push_back(number(800 + i));
    return data;
}

inline const std::vector<double>& report() {
    static const auto& numbers = *new std::vector<double>{6.0, 1.0, 0.5, 1e300, INFINITY};
    return numbers;
}

inline marks::PointSet point_set(base::Memory& memory, std::int64_t count) {
    marks::PointSet set(memory);
    set.distribution = marks::Distribution::blue_noise;
    set.seed_source = marks::SeedSource::box;
    if (count > 0) {
        set.origin = {10.0, 20.0, 30.0};
        set.bounds = {{9.0, 19.0, 29.0}, {11.0, 21.0, 31.0}};
        set.spacing = 0.125;
    }
    set.seeds = {100, 90, 4, 3, 2, 1};
    set.seconds_total = 0.75;
    // Stipples, strokes whose marks are not in the order of the strokes, and an empty layer.
    for (const marks::Kind kind : {marks::Kind::stipples, marks::Kind::hatch, marks::Kind::own}) {
        marks::Layer& layer = set.layers.add(memory, kind);
        layer.progressive = kind == marks::Kind::stipples;
        layer.report.full_count = 7;
        layer.report.levels = 3;
        layer.report.step = 0.5;
        layer.report.of(12) = {1, 2, 3, 4, 5, 6};
        if (kind == marks::Kind::own) continue;
        const bool strokes = kind == marks::Kind::hatch;
        for (std::int64_t i = 0; i < count; ++i) {
            layer.rank.push_back(static_cast<float>(number(i) + 0.5));
            layer.level.push_back(static_cast<std::uint8_t>(i % 13));
            layer.stroke.push_back(static_cast<std::uint32_t>(strokes ? i % 2 : 2 * i));
            layer.stroke.push_back(static_cast<std::uint32_t>(strokes ? i / 2 : 0));
            for (int k = 0; k < 3; ++k) {
                layer.position.push_back(static_cast<float>(number(1000 + 3 * i + k)));
                layer.normal.push_back(k == i % 3 ? 1.0F : 0.0F);
                layer.direction.push_back(k == (i + 1) % 3 ? 1.0F : 0.0F);
                if (strokes) layer.curvature.push_back(static_cast<float>(number(2000 + 3 * i + k)));
            }
        }
        if (strokes) marks::index_strokes(layer);
    }
    return set;
}

// Gives all layers a colour, and strokes a number with weights.
inline marks::PointSet with_fields(marks::PointSet set) {
    for (marks::Layer& layer : set.layers) {
        marks::MarkField& colour = layer.fields.add(layer.rank.memory());
        colour.name = {'c', 'o', 'l', 'o', 'u', 'r'};
        colour.kind = marks::FieldKind::colour;
        for (std::int64_t i = 0; i < 3 * layer.count(); ++i)
            colour.value.push_back(static_cast<float>(number(3000 + i) + 0.5));
        if (layer.kind != marks::Kind::hatch) continue;
        marks::MarkField& heat = layer.fields.add(layer.rank.memory());
        heat.name = {'h', 'e', 'a', 't'};
        for (std::int64_t i = 0; i < layer.count(); ++i) {
            heat.value.push_back(static_cast<float>(number(4000 + i)));
            heat.weight.push_back(i % 2 == 0 ? 1.0F : 0.25F);
        }
    }
    return set;
}

inline Bytes bytes_of(const implicit::HrbfData& data) {
    BytesWriter writer;
    save_model({&data, nullptr, report()}, nullptr, writer);
    return writer.bytes;
}

inline Bytes bytes_of(const marks::PointSet& set) {
    BytesWriter writer;
    save_point_set(set, writer);
    return writer.bytes;
}

inline MemoryReader reader_of(const Bytes& bytes) { return MemoryReader(std::as_bytes(std::span(bytes))); }

inline Bytes model_bytes(std::int64_t count = 2) {
    base::Memory memory;
    return bytes_of(model(memory, count));
}

inline TrimFile& fill(TrimFile& trim) {
    trim.limit = 1.5;
    trim.closest = 0.25;
    trim.grid = {{1.0, 2.0, 3.0}, 0.5};
    for (const double number : {4.0, 5.0}) trim.report.push_back(number);
    for (const double number : {0.0, 1.0, 2.0}) trim.position.push_back(number);
    for (const double number : {0.0, 0.0, 1.0}) trim.normal.push_back(number);
    for (const std::int64_t cell : {std::int64_t{7}, std::int64_t{1} << 60}) trim.end_cells.push_back(cell);
    trim.kept_cells.push_back(3);
    return trim;
}

inline Bytes trimmed_model_bytes(std::int64_t count = 2) {
    base::Memory memory;
    ModelFile file(memory);
    file.data = model(memory, count);
    BytesWriter writer;
    save_model({&file.data, nullptr, report()}, &fill(file.trim), writer);
    return writer.bytes;
}

// A tree that subtracts a ball from a fit.
inline implicit::CsgTree csg_tree(base::Memory& memory) {
    implicit::CsgTree tree(memory);
    implicit::CsgNode node;
    node.kind = implicit::CsgKind::subtract;
    node.blend = 0.125;
    tree.push_back(node);
    node.kind = implicit::CsgKind::model;
    node.parent = 0;
    node.model = 0;
    tree.push_back(node);
    node.kind = implicit::CsgKind::sphere;
    node.model = -1;
    node.linear[1] = {0.0, 2.0, 0.5};
    node.translation = {1.0, 2.0, 3.0};
    tree.push_back(node);
    return tree;
}

inline Bytes bytes_of(const implicit::CsgTree& tree, const geometry::Bounds& bounds, std::span<const FitToSave> leaves,
                      const TrimFile* trim = nullptr) {
    BytesWriter writer;
    save_csg(tree, bounds, leaves, trim, writer);
    return writer.bytes;
}

inline Bytes csg_model_bytes(std::int64_t count = 2) {
    base::Memory memory;
    const implicit::HrbfData data = model(memory, count);
    const std::vector<double> numbers = report();
    const FitToSave leaf{&data, nullptr, numbers};
    return bytes_of(csg_tree(memory), {glm::dvec3(-2.0), glm::dvec3(3.0)}, {&leaf, 1});
}

// The kinds of files that the damage tests change.
enum class Sample : std::uint8_t { point_set, painted_set, model, trimmed_model, csg_model };
inline constexpr Sample all_samples[] = {Sample::point_set, Sample::painted_set, Sample::model, Sample::trimmed_model,
                                         Sample::csg_model};
inline const char* name_of(Sample sample) {
    constexpr const char* names[] = {"PointSet", "PaintedSet", "Model", "TrimmedModel", "CsgModel"};
    return names[static_cast<std::size_t>(sample)];
}

inline Bytes point_set_bytes(std::int64_t count = 2) {
    base::Memory memory;
    return bytes_of(point_set(memory, count));
}

inline Bytes painted_set_bytes(std::int64_t count = 2) {
    base::Memory memory;
    return bytes_of(with_fields(point_set(memory, count)));
}

inline Bytes bytes_of(Sample sample, std::int64_t count = 2) {
    if (sample == Sample::point_set) return point_set_bytes(count);
    if (sample == Sample::painted_set) return painted_set_bytes(count);
    if (sample == Sample::csg_model) return csg_model_bytes(count);
    return sample == Sample::model ? model_bytes(count) : trimmed_model_bytes(count);
}

inline std::uint32_t crc_of(std::span<const std::uint8_t> bytes) {
    Crc32 crc;
    crc.add(bytes);
    return crc.value();
}

// Corrects the checksums after a change, so that the checks after them are tested.
inline void sign(Bytes& bytes) {
    store(&bytes[36], crc_of(std::span(bytes).first(36)));
    if (bytes.size() >= header_size + 4)
        store(&bytes[bytes.size() - 4],
              crc_of(std::span(bytes).subspan(header_size).first(bytes.size() - header_size - 4)));
}

// The result of loading. The message is "" on success.
struct Outcome {
    Status status = Status::ok;
    std::string message;
};

inline Outcome load(base::Memory& memory, const Bytes& bytes, bool is_model) {
    try {
        MemoryReader reader = reader_of(bytes);
        if (is_model) {
            (void)load_model(memory, reader);
        } else {
            (void)load_point_set(memory, reader);
        }
    } catch (const Error& error) {
        return {error.status(), error.what()};
    }
    return {};
}

} // namespace hrbfnpr::io::samples
