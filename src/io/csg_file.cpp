// SPDX-License-Identifier: MIT
// Saves and loads models that are CSG trees.
#include "io/check.h"
#include "io/model_sections.h"

namespace hrbfnpr::io {
namespace {

using implicit::CsgKind;
using implicit::CsgNode;

constexpr std::uint32_t tag_box = tag("CBOX");
constexpr std::uint32_t tag_node_kind = tag("CKND");
constexpr std::uint32_t tag_parent = tag("CPAR");
constexpr std::uint32_t tag_model = tag("CMOD");
constexpr std::uint32_t tag_numbers = tag("CNUM");
constexpr std::uint32_t tag_leaves = tag("CLVS");

constexpr std::size_t numbers_of_node = 21;
using Numbers = std::array<double, numbers_of_node>;

Numbers numbers_of(const CsgNode& node) noexcept {
    Numbers n{};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) n[static_cast<std::size_t>(3 * column + row)] = node.linear[column][row];
    for (int i = 0; i < 3; ++i) {
        n[static_cast<std::size_t>(9 + i)] = node.translation[i];
        n[static_cast<std::size_t>(12 + i)] = node.size[i];
    }
    const std::array<double, 6> rest{node.radius,   node.second_radius, node.height,
                                     node.distance, node.blend,         node.exponent};
    std::copy(rest.begin(), rest.end(), n.begin() + 15);
    return n;
}

void set_numbers(CsgNode& node, const double* n) noexcept {
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) node.linear[column][row] = n[3 * column + row];
    for (int i = 0; i < 3; ++i) {
        node.translation[i] = n[9 + i];
        node.size[i] = n[12 + i];
    }
    node.radius = n[15];
    node.second_radius = n[16];
    node.height = n[17];
    node.distance = n[18];
    node.blend = n[19];
    node.exponent = n[20];
}

void encode(Encoder& encoder, const implicit::CsgTree& tree, const geometry::Bounds& bounds) {
    const auto& [low, high] = bounds;
    encoder.section<double>(tag_box, std::array{low.x, low.y, low.z, high.x, high.y, high.z});
    base::Memory& memory = tree.memory();
    base::Array<std::uint32_t> kind(memory);
    base::Array<std::int64_t> parent(memory);
    base::Array<std::int64_t> model(memory);
    base::Array<double> numbers(memory);
    for (const CsgNode& node : tree) {
        kind.push_back(static_cast<std::uint32_t>(node.kind));
        parent.push_back(node.parent);
        model.push_back(node.model);
        for (const double number : numbers_of(node)) numbers.push_back(number);
    }
    encoder.section<std::uint32_t>(tag_node_kind, kind.span());
    encoder.section<std::int64_t>(tag_parent, parent.span());
    encoder.section<std::int64_t>(tag_model, model.span());
    encoder.section<double>(tag_numbers, numbers.span());
}

void check_node(const Decoder& decoder, const ModelFile& file, std::int64_t i) {
    const CsgNode& node = file.tree[i];
    const bool is_model = node.kind == CsgKind::model;
    if (is_model ? node.model < 0 || node.model >= file.leaves.size() : node.model != -1)
        decoder.damaged("node %lld has a leaf that does not exist", static_cast<long long>(i));
    for (const double number : numbers_of(node))
        if (!std::isfinite(number))
            decoder.damaged("node %lld has a number that is not finite", static_cast<long long>(i));
}

} // namespace

void save_csg(const implicit::CsgTree& tree, const geometry::Bounds& bounds, std::span<const FitToSave> leaves,
              const TrimFile* trim, Writer& writer) {
    write_file(writer, kind_model, model_version, [&](Encoder& encoder) {
        encode_kind(encoder, {csg_kind, 0});
        encode(encoder, tree, bounds);
        encoder.section<std::uint32_t>(tag_leaves, std::array{static_cast<std::uint32_t>(leaves.size())});
        for (const FitToSave& leaf : leaves) encode_fit(encoder, leaf);
        encode_trim(encoder, trim);
    });
}

void decode_csg(Decoder& decoder, const ModelKind& kind, ModelFile& file) {
    if (kind[1] != 0) decoder.damaged("its kind is unknown");
    base::Memory& memory = file.tree.memory();
    std::array<double, 6> box{};
    decoder.section<double>(tag_box, box);
    file.bounds = {{box[0], box[1], box[2]}, {box[3], box[4], box[5]}};
    base::Array<std::uint32_t> kinds(memory);
    base::Array<std::int64_t> parent(memory);
    base::Array<std::int64_t> model(memory);
    base::Array<double> numbers(memory);
    decoder.section(tag_node_kind, kinds);
    const std::int64_t count = kinds.size();
    if (count < 1 || count > implicit::most_csg_nodes) decoder.damaged("it has no nodes, or more than 65536");
    decoder.section(tag_parent, parent, count);
    decoder.section(tag_model, model, count);
    decoder.section(tag_numbers, numbers, count * static_cast<std::int64_t>(numbers_of_node));
    for (std::int64_t i = 0; i < count; ++i) {
        if (kinds[i] > implicit::last_csg_kind)
            decoder.damaged("the kind of node %lld is unknown", static_cast<long long>(i));
        CsgNode node;
        node.kind = static_cast<CsgKind>(kinds[i]);
        node.parent = parent[i];
        node.model = model[i];
        set_numbers(node, numbers.data() + i * static_cast<std::int64_t>(numbers_of_node));
        file.tree.push_back(node);
    }
    std::array<std::uint32_t, 1> leaves{};
    decoder.section<std::uint32_t>(tag_leaves, leaves);
    if (leaves[0] > static_cast<std::uint64_t>(count)) decoder.damaged("it has more leaves than nodes");
    for (std::uint32_t i = 0; i < leaves[0]; ++i) decode_fit(decoder, decode_kind(decoder), file.leaves.add());
}

void check_csg(const Decoder& decoder, const ModelFile& file) {
    check_bounds(decoder, file.bounds);
    for (std::int64_t i = 0; i < file.tree.size(); ++i) check_node(decoder, file, i);
    for (std::int64_t i = 0; i < file.leaves.size(); ++i) check_fit(decoder, file.leaves[i]);
}

} // namespace hrbfnpr::io
