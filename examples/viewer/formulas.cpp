// SPDX-License-Identifier: MIT
// The built-in surfaces: solids made of primitives, a function of our own, and samples of formulas.
#include "scene.h"

namespace viewer {

namespace {

constexpr double turn = 6.283185307179586;

hrbfnpr_csg_node node(std::uint32_t kind, std::int64_t parent) {
    auto result = defaults<hrbfnpr_csg_node>(hrbfnpr_csg_node_init);
    result.kind = kind;
    result.parent = parent;
    return result;
}

// Sets the axes of a node's own coordinates, as columns, and their origin.
void place(hrbfnpr_csg_node& node, const Vec& x, const Vec& y, const Vec& z, const Vec& origin) {
    const Vec columns[] = {x, y, z, origin};
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t r = 0; r < 3; ++r) node.transform[4 * c + r] = columns[c][r];
}

Model solid(const std::vector<hrbfnpr_csg_node>& nodes, Work& work) {
    auto desc = defaults<hrbfnpr_csg_desc>(hrbfnpr_csg_desc_init);
    desc.nodes = nodes.data();
    desc.node_count = static_cast<std::int64_t>(nodes.size());
    return make<hrbfnpr_model>(hrbfnpr_model_release, [&](auto** out, auto* error) {
        return hrbfnpr_model_create_csg(work.context.get(), &desc, out, error);
    });
}

hrbfnpr_csg_node torus(std::int64_t parent, double tube) {
    auto result = node(HRBFNPR_CSG_TORUS, parent);
    result.second_radius = tube;
    return result;
}

std::vector<hrbfnpr_csg_node> linked_tori() {
    std::vector<hrbfnpr_csg_node> nodes = {node(HRBFNPR_CSG_UNION, -1), torus(0, 0.25), torus(0, 0.25)};
    place(nodes[2], {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {1, 0, 0});
    return nodes;
}

// A rounded cube with holes along its axes.
std::vector<hrbfnpr_csg_node> drilled_cube() {
    std::vector<hrbfnpr_csg_node> nodes = {node(HRBFNPR_CSG_DIFFERENCE, -1), node(HRBFNPR_CSG_INTERSECTION, 0),
                                           node(HRBFNPR_CSG_BOX, 1), node(HRBFNPR_CSG_SPHERE, 1)};
    for (double& side : nodes[2].size) side = 1.5;
    const Vec x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    for (int axis = 0; axis < 3; ++axis) {
        auto hole = node(HRBFNPR_CSG_CYLINDER, 0);
        hole.radius = 0.42;
        hole.height = 3;
        if (axis == 0) place(hole, y, z, x, {});
        if (axis == 1) place(hole, z, x, y, {});
        nodes.push_back(hole);
    }
    return nodes;
}

// x^4 - 5 x^2 + y^4 - 5 y^2 + z^4 - 5 z^2 + 11.8. The division by 12 makes the gradients about 1 long.
std::int32_t tangle(void*, std::int64_t count, const double* points, double* value, double* gradient, double* hessian) {
    constexpr double scale = 12;
    for (std::int64_t i = 0; i < count; ++i) {
        value[i] = 11.8 / scale;
        if (hessian != nullptr)
            for (int k = 0; k < 6; ++k) hessian[6 * i + k] = 0;
        for (int k = 0; k < 3; ++k) {
            const double x = points[3 * i + k];
            value[i] += (x * x * x * x - 5 * x * x) / scale;
            if (gradient != nullptr) gradient[3 * i + k] = (4 * x * x * x - 10 * x) / scale;
            if (hessian != nullptr) hessian[6 * i + (k == 0 ? 0 : k == 1 ? 3 : 5)] = (12 * x * x - 10) / scale;
        }
    }
    return 0;
}

Model tangle_cube(Work& work) {
    auto desc = defaults<hrbfnpr_custom_desc>(hrbfnpr_custom_desc_init);
    desc.function = tangle;
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_HAS_HESSIAN | HRBFNPR_CUSTOM_THREAD_SAFE;
    for (int k = 0; k < 3; ++k) desc.bounds_min[k] = -2.4, desc.bounds_max[k] = 2.4;
    return make<hrbfnpr_model>(hrbfnpr_model_release, [&](auto** out, auto* error) {
        return hrbfnpr_model_create_custom(work.context.get(), &desc, out, error);
    });
}

// A tube about the knot ((2 + cos 3t) cos 2t, (2 + cos 3t) sin 2t, sin 3t).
Shape trefoil() {
    constexpr int along = 128, around = 10;
    const auto line = [](double t) {
        return Vec{(2 + std::cos(3 * t)) * std::cos(2 * t), (2 + std::cos(3 * t)) * std::sin(2 * t), std::sin(3 * t)};
    };
    Shape shape;
    for (int i = 0; i < along * around; ++i) {
        const double t = turn * (i / around) / along, a = turn * (i % around + 0.5 * (i / around % 2)) / around;
        const Vec tangent = unit(line(t + 1e-4) - line(t - 1e-4));
        const Vec side = unit(cross(tangent, {0, 0, 1})), other = cross(tangent, side);
        shape.normals.push_back(std::cos(a) * side + std::sin(a) * other);
        shape.points.push_back(line(t) + 0.4 * shape.normals.back());
    }
    return shape;
}

double heart_value(const Vec& p) {
    const double x = p[0], y = p[1], z = p[2], s = x * x + y * y + 2.25 * z * z - 1;
    return s * s * s - x * x * y * y * y - 0.1125 * z * z * y * y * y;
}

// (x^2 + y^2 + 9/4 z^2 - 1)^3 = x^2 y^3 + 9/80 z^2 y^3 [Taubin 1994]. Each ray from the origin meets it once.
Shape heart() {
    constexpr int count = 900;
    Shape shape;
    for (int i = 0; i < count; ++i) {
        const double y = 1 - 2 * (i + 0.5) / count, r = std::sqrt(1 - y * y), a = turn * 0.381966 * i;
        const Vec direction{r * std::cos(a), y, r * std::sin(a)};
        double low = 0, high = 2;
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (low + high);
            (heart_value(middle * direction) < 0 ? low : high) = middle;
        }
        const Vec p = low * direction;
        Vec gradient;
        for (std::size_t k = 0; k < 3; ++k) {
            Vec step{};
            step[k] = 1e-6;
            gradient[k] = heart_value(p + step) - heart_value(p - step);
        }
        if (length(gradient) < 1e-9) continue; // a singular point
        shape.points.push_back(p);
        shape.normals.push_back(unit(gradient));
    }
    return shape;
}

} // namespace

const std::vector<std::string>& formulas() {
    static const std::vector<std::string> names = {"torus",       "linked tori",  "drilled cube",
                                                   "tangle cube", "trefoil knot", "heart"};
    return names;
}

Source source_of_formula(const std::string& name, Work& work) {
    Source source;
    source.name = name;
    source.has_right_normals = true;
    source.up = name == "torus" || name == "linked tori" || name == "trefoil knot" ? Vec{0, 0, 1} : Vec{0, 1, 0};
    if (name == "torus")
        source.model = solid({torus(-1, 0.4)}, work);
    else if (name == "linked tori")
        source.model = solid(linked_tori(), work);
    else if (name == "drilled cube")
        source.model = solid(drilled_cube(), work);
    else if (name == "tangle cube")
        source.model = tangle_cube(work);
    else if (name == "trefoil knot")
        source.shape = trefoil();
    else if (name == "heart")
        source.shape = heart();
    else
        throw Failure("there is no model \"" + name +
                      "\"; choose torus, linked tori, drilled cube, tangle cube, trefoil knot or heart");
    return source;
}

} // namespace viewer
