// SPDX-License-Identifier: MIT
// Checks that the nodes from a caller or a file form a tree.
#include "api/checks.h"
#include "api/csg_solid.h"
#include "api/lists.h"

namespace hrbfnpr::api {
namespace {

using implicit::CsgKind;
using implicit::CsgNode;

// The largest allowed ratio of the largest to the smallest stretch factor of a transform.
constexpr double most_stretch = 1e4;

void check_transform(const char* name, const CsgNode& node) {
    const implicit::StretchFactors stretch = implicit::stretch_factors(node.linear);
    if (!(stretch.least > 0.0 && stretch.most <= most_stretch * stretch.least))
        fail(Status::invalid_argument,
             "%s.transform stretches lengths %g to %g times; the least must be above 0, and the most at most %g times "
             "the least",
             name, stretch.least, stretch.most, most_stretch);
}

void check_radii(const Checks& checks, const char* name, const CsgNode& node) {
    if (node.kind != CsgKind::cone) return checks.positive("radius", node.radius);
    checks.at_least("radius", node.radius, 0.0);
    checks.at_least("second_radius", node.second_radius, 0.0);
    if (node.radius == 0.0 && node.second_radius == 0.0)
        fail(Status::invalid_argument, "%s.radius and second_radius are both 0; at least one must be above 0", name);
}

void check_blend(const Checks& checks, const char* name, const CsgNode& node) {
    checks.at_least("blend", node.blend, 0.0);
    constexpr double lowest = 2.0;
    constexpr double highest = 64.0;
    if (node.exponent != 0.0 && !(node.exponent >= lowest && node.exponent <= highest))
        fail(Status::invalid_argument, "%s.exponent is %g; it must be 0, or from %g to %g", name, node.exponent, lowest,
             highest);
}

void check_node(const char* name, const CsgNode& node) {
    const Checks checks(name);
    check_transform(name, node);
    switch (node.kind) {
    case CsgKind::unite:
    case CsgKind::intersect:
    case CsgKind::subtract: return check_blend(checks, name, node);
    case CsgKind::complement:
    case CsgKind::model:
    case CsgKind::half_space: return;
    case CsgKind::offset: return checks.finite("distance", node.distance);
    case CsgKind::shell: return checks.positive("distance", node.distance);
    case CsgKind::box:
        for (int axis = 0; axis < 3; ++axis) checks.positive("size", node.size[axis]);
        return;
    case CsgKind::sphere: return check_radii(checks, name, node);
    case CsgKind::cylinder:
    case CsgKind::cone: check_radii(checks, name, node); return checks.positive("height", node.height);
    case CsgKind::torus: break;
    }
    check_radii(checks, name, node);
    checks.strictly_between("second_radius", node.second_radius, 0.0, node.radius);
}

} // namespace

void check_csg_tree(const char* list, const implicit::CsgTree& tree) {
    base::Array<std::int64_t> children(tree.memory(), tree.size());
    for (std::int64_t i = 0; i < tree.size(); ++i) {
        const ElementName name(list, i);
        const std::int64_t parent = tree[i].parent;
        check_node(name.text, tree[i]);
        if (i == 0 && parent != -1)
            fail(Status::invalid_argument, "%s.parent is %lld; the first node is the root, so its parent must be -1",
                 name.text, static_cast<long long>(parent));
        if (i == 0) continue;
        if (parent < 0 || parent >= i)
            fail(Status::invalid_argument, "%s.parent is %lld; it must be the index of an earlier node, 0 to %lld",
                 name.text, static_cast<long long>(parent), static_cast<long long>(i - 1));
        const std::int64_t most = implicit::children_of(tree[parent].kind);
        if (++children[parent] > most && most >= 0)
            fail(Status::invalid_argument,
                 "%s.parent is %lld, but a node of kind %u takes no more children than %lld; choose another parent",
                 name.text, static_cast<long long>(parent), static_cast<unsigned>(tree[parent].kind),
                 static_cast<long long>(most));
    }
    for (std::int64_t i = 0; i < tree.size(); ++i)
        if (children[i] == 0 && !implicit::is_leaf(tree[i].kind))
            fail(Status::invalid_argument, "%s is of kind %u and has no children; give it at least one",
                 ElementName(list, i).text, static_cast<unsigned>(tree[i].kind));
}

} // namespace hrbfnpr::api
