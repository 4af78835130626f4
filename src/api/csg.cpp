// SPDX-License-Identifier: MIT
// Makes solids from other solids.
#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/lists.h"
#include "api/model.h"
#include "surface/region.h"

using namespace hrbfnpr;

static_assert(static_cast<std::uint32_t>(implicit::CsgKind::subtract) == HRBFNPR_CSG_DIFFERENCE);
static_assert(static_cast<std::uint32_t>(implicit::CsgKind::shell) == HRBFNPR_CSG_SHELL);
static_assert(static_cast<std::uint32_t>(implicit::CsgKind::model) == HRBFNPR_CSG_MODEL);
static_assert(static_cast<std::uint32_t>(implicit::CsgKind::torus) == HRBFNPR_CSG_TORUS);

namespace hrbfnpr::api {
namespace {

using implicit::CsgKind;
using implicit::CsgNode;
using Node = hrbfnpr_csg_node;
using Desc = hrbfnpr_csg_desc;

// Sizes, radii, heights, distances, blends and exponents are checked later, for the kinds of nodes that use them.
constexpr auto node_fields() noexcept {
    return FieldTable{field("kind", &Node::kind, &CsgNode::kind, rule::OneOf{HRBFNPR_CSG_TORUS, "HRBFNPR_CSG_*"}),
                      field("parent", &Node::parent, &CsgNode::parent, rule::Any{}),
                      field("model", &Node::model, rule::Any{}),
                      field("transform", &Node::transform, rule::AllNumbers{rule::Finite{}}),
                      field("size", &Node::size, &CsgNode::size, rule::Any{}),
                      field("radius", &Node::radius, &CsgNode::radius, rule::Any{}),
                      field("second_radius", &Node::second_radius, &CsgNode::second_radius, rule::Any{}),
                      field("height", &Node::height, &CsgNode::height, rule::Any{}),
                      field("distance", &Node::distance, &CsgNode::distance, rule::Any{}),
                      field("blend", &Node::blend, &CsgNode::blend, rule::Any{}),
                      field("exponent", &Node::exponent, &CsgNode::exponent, rule::Any{})};
}
static_assert(node_fields().covers<Node>());

constexpr auto desc_fields() noexcept {
    return FieldTable{reserved("reserved", &Desc::reserved),
                      field("nodes", &Desc::nodes, rule::Any{}),
                      field("node_count", &Desc::node_count, rule::Any{}),
                      field("node_stride", &Desc::node_stride, rule::Any{}),
                      field("bounds_min", &Desc::bounds_min, rule::AllNumbers{rule::Finite{}}),
                      field("bounds_max", &Desc::bounds_max, rule::AllNumbers{rule::Finite{}})};
}
static_assert(desc_fields().covers<Desc>());

} // namespace

template <>
hrbfnpr_csg_node defaults() noexcept {
    hrbfnpr_csg_node node{};
    node_fields().set_defaults(CsgNode{}, node);
    for (const int i : {0, 5, 10, 15}) node.transform[i] = 1.0;
    return node;
}

template <>
hrbfnpr_csg_desc defaults() noexcept {
    return {};
}

template <>
hrbfnpr_csg_info defaults() noexcept {
    return {};
}

namespace {

constexpr double smallest_box = 1e-100; // the smallest diagonal of a bounding box; the same limit as for custom models

void set_transform(const char* name, const Node& given, CsgNode& node) {
    const double(&m)[16] = given.transform;
    if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
        fail(Status::invalid_argument,
             "%s.transform has the last row %g %g %g %g; it must be 0 0 0 1, as in any affine transform", name, m[3],
             m[7], m[11], m[15]);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) node.linear[column][row] = m[4 * column + row];
    node.translation = {m[12], m[13], m[14]};
}

CsgNode checked(const Node& given, const char* name) {
    node_fields().check(name, given);
    CsgNode node;
    node_fields().copy(given, node);
    set_transform(name, given, node);
    return node;
}

// Adds the nodes to the solid, in order. If the model of a leaf is a tree, the tree replaces the leaf.
class Reader {
public:
    Reader(CsgSolid& solid, const base::Runtime& runtime, const Desc& desc)
        : solid_(solid),
          list_(desc.nodes, desc.node_count, desc.node_stride, implicit::most_csg_nodes, "csg_desc.nodes"),
          number_(runtime.memory), given_(runtime.memory) {}

    void read() {
        if (list_.count() == 0)
            fail(Status::invalid_argument, "csg_desc.node_count is 0; a tree needs at least one node");
        for (std::int64_t i = 0; i < list_.count(); ++i) {
            const Node node = list_[i];
            given_.push_back(checked(node, list_.name(i).text));
            check_model(i, node);
        }
        check_csg_tree("csg_desc.nodes", given_);
        for (std::int64_t i = 0; i < list_.count(); ++i) number_.push_back(add(i));
    }

private:
    void check_model(std::int64_t i, const Node& node) const {
        if (node.kind != HRBFNPR_CSG_MODEL) return;
        if (node.model == nullptr) fail(Status::invalid_argument, "%s.model is NULL", list_.name(i).text);
        if (node.model->implicit().domain() != nullptr)
            fail(Status::invalid_argument,
                 "%s.model is trimmed, so it bounds no solid; fit it with fit_desc.trim HRBFNPR_TRIM_NEVER",
                 list_.name(i).text);
    }
    std::int64_t add(std::int64_t i) {
        CsgNode node = given_[i];
        if (i > 0) node.parent = number_[node.parent];
        if (node.kind != CsgKind::model) return solid_.add(node);
        const hrbfnpr_model& model = list_[i].model->untrimmed();
        if (const CsgSolid* const tree = model.csg()) return solid_.add(*tree, node);
        node.model = solid_.leaf(model);
        return solid_.add(node);
    }

    CsgSolid& solid_;
    List<Node> list_;
    base::Array<std::int64_t> number_; // for each node: the node's index in the solid
    implicit::CsgTree given_;
};

void check_box(const geometry::Bounds& bounds) {
    const double diagonal = bounds.diagonal();
    if (!(diagonal >= smallest_box && diagonal <= 1.0 / smallest_box))
        fail(Status::invalid_argument,
             "csg_desc: the bounding box has the diagonal %g; it must be from %g to %g: scale the tree, or change "
             "bounds_min and bounds_max",
             diagonal, smallest_box, 1.0 / smallest_box);
}

geometry::Bounds given_bounds(const Desc& desc) {
    geometry::Bounds bounds;
    assign_field(bounds.min, desc.bounds_min);
    assign_field(bounds.max, desc.bounds_max);
    for (int axis = 0; axis < 3; ++axis)
        if (bounds.min[axis] > bounds.max[axis])
            fail(Status::invalid_argument,
                 "csg_desc.bounds_min[%d] is %g, above bounds_max[%d], which is %g; swap them", axis, bounds.min[axis],
                 axis, bounds.max[axis]);
    return bounds;
}

// Returns the bounding box of the model. The box is large enough that the search box, which is this box with a margin,
// contains the whole surface.
geometry::Bounds found_bounds(const implicit::CsgPlan& plan) {
    const implicit::CsgBox whole = plan.whole;
    if (whole.empty())
        fail(Status::invalid_argument,
             "csg_desc: the solid is empty, because parts that are intersected do not overlap; move or enlarge them");
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(whole.low[axis]) || !std::isfinite(whole.high[axis]))
            fail(Status::invalid_argument,
                 "csg_desc: the surface may be unbounded along %c; intersect it with a box, or set bounds_min and "
                 "bounds_max",
                 "xyz"[axis]);
    const implicit::CsgBox drawn = plan.drawn;
    if (drawn.empty()) return {whole.low, whole.high};
    const double margin = surface::region_margin * glm::length(drawn.high - drawn.low);
    return {glm::min(drawn.low, whole.low + margin), glm::max(drawn.high, whole.high - margin)};
}

hrbfnpr_model* create(hrbfnpr_context& context, const Desc& desc) {
    desc_fields().check("csg_desc", desc);
    auto solid = std::make_unique<CsgSolid>(context.runtime);
    Reader(*solid, context.runtime, desc).read();
    const auto none = [](const double(&v)[3]) { return v[0] == 0.0 && v[1] == 0.0 && v[2] == 0.0; };
    const bool given = !none(desc.bounds_min) || !none(desc.bounds_max);
    const geometry::Bounds box = given ? given_bounds(desc) : geometry::Bounds{};
    return make_csg_model(context, std::move(solid), given ? &box : nullptr);
}

hrbfnpr_csg_info describe_csg(const hrbfnpr_model& model) {
    hrbfnpr_csg_info info{};
    const CsgSolid* const solid = model.untrimmed().csg();
    if (solid == nullptr) return info;
    info.nodes = solid->tree().size();
    info.depth = solid->depth();
    info.models = solid->models().size();
    info.sheets = solid->planned().root().sheets;
    info.lipschitz = solid->function().lipschitz();
    return info;
}

} // namespace

hrbfnpr_model* make_csg_model(hrbfnpr_context& context, std::unique_ptr<CsgSolid> solid,
                              const geometry::Bounds* bounds) {
    solid->plan();
    if (!solid->planned().is_finite())
        fail(Status::invalid_argument,
             "csg_desc: the product of the nodes' transforms overflows a double; use smaller transforms");
    const geometry::Bounds box = bounds != nullptr ? *bounds : found_bounds(solid->planned());
    check_box(box);
    solid->finish(box);
    return make_handle<hrbfnpr_model>(context, std::move(solid));
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_csg_node_init(hrbfnpr_csg_node* node, uint32_t struct_size) {
    return api::init_struct(node, struct_size);
}

hrbfnpr_status hrbfnpr_csg_desc_init(hrbfnpr_csg_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_model_create_csg(hrbfnpr_context* context, const hrbfnpr_csg_desc* desc,
                                        hrbfnpr_model** out_model, hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        return api::create(api::deref(context, "context"), api::read_struct(desc, "csg_desc"));
    });
}

hrbfnpr_status hrbfnpr_csg_info_init(hrbfnpr_csg_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_model_get_csg_info(const hrbfnpr_model* model, hrbfnpr_csg_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        api::check_output_struct(info, "csg_info");
        api::write_struct(info, api::describe_csg(handle));
    });
}

} // extern "C"
