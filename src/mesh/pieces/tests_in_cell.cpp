// SPDX-License-Identifier: MIT
#include "mesh/pieces/tests_in_cell.h"

#include "base/random.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::mesh {
namespace {

using implicit::PiecesData;

constexpr std::int64_t along = 5;     // places in a cell: so many along each axis
constexpr double beside_step = 0.12;  // half sides of the cell: how far off the surface signs are asked for ...
constexpr double finer_step = 0.03;   // ... and again
constexpr std::size_t looked_at = 24; // faces, whose middles and sides are
constexpr std::uint32_t stream = 78;

} // namespace

struct CellTests::Tests {
    explicit Tests(base::Memory& memory) noexcept : place(memory), distance(memory), slack(memory), own(memory) {}

    void add(const glm::dvec3& p, double d, double may_be_off, std::int32_t sheet) {
        place.push_back(p);
        distance.push_back(d);
        slack.push_back(may_be_off);
        own.push_back(sheet);
    }

    // The sign of all places, where there are some and they have the same and no surface is between.
    [[nodiscard]] double one_side() const noexcept {
        if (distance.empty()) return 0.0;
        const double sign = std::copysign(1.0, distance[0]);
        for (std::int64_t i = 0; i < distance.size(); ++i)
            if (own[i] >= 0 || !(distance[i] * sign > 0.0)) return 0.0;
        return sign;
    }

    geometry::VecArray place;
    base::Array<double> distance;  // signed
    base::Array<double> slack;     // of `own`: by how much it may be something else
    base::Array<std::int32_t> own; // on the surface: the sheet, of those given, that f is to be; else -1
};

double CellTests::slack(std::int64_t face) const noexcept {
    const Triangle& t = mesh_.triangle[face];
    return near_ + 1.5 * std::max({chord_[t[0]], chord_[t[1]], chord_[t[2]]});
}

void CellTests::add_beside(const Beside& beside, double step, Tests& tests) const {
    if (!beside.inner) return;
    const glm::dvec3& normal = sides_.normal(beside.face);
    const double least = slack(beside.face);
    for (const double side : {1.0, -1.0}) {
        const double room = sides_.room(beside.place, side * normal, step);
        if (room > least) tests.add(beside.place + side * room * normal, side * room, 0.0, -1);
    }
}

void CellTests::gather(const CellBox& box, std::uint64_t cell, std::span<const std::int32_t> sheets,
                       Tests& tests) const {
    const double spacing = 2.0 * box.half / static_cast<double>(along);
    for (std::int64_t i = 0; i < along * along * along; ++i) {
        const auto random =
            base::uniform4(seed_, cell * 1024U + static_cast<std::uint64_t>(i), base::Purpose::mesh_sample, stream);
        const glm::dvec3 in(static_cast<double>(i % along) + random[0],
                            static_cast<double>(i / along % along) + random[1],
                            static_cast<double>(i / along / along) + random[2]);
        const glm::dvec3 place = box.centre - box.half + spacing * in;
        const Beside beside = sides_.beside(place);
        const double near = slack(beside.face);
        if (std::abs(beside.distance) > near) tests.add(place, beside.distance, 0.0, -1);
        if (i % 2 == 0) add_on_surface(box, beside, (i % 4 == 0 ? beside_step : finer_step) * box.half, sheets, tests);
    }
}

// Where the mesh is, f is to be the sheet of the patch there, and have its signs beside it.
void CellTests::add_on_surface(const CellBox& box, const Beside& beside, double step,
                               std::span<const std::int32_t> sheets, Tests& tests) const {
    if (!box.contains(beside.place) || !sides_.is_outer(beside)) return;
    const auto own = std::find(sheets.begin(), sheets.end(), patch_[beside.face]) - sheets.begin();
    if (own == static_cast<std::ptrdiff_t>(sheets.size())) return;
    tests.add(beside.place, 0.0, slack(beside.face) - 0.5 * near_, static_cast<std::int32_t>(own));
    add_beside(beside, step, tests);
}

// In the middles of faces, and near to their sides: small ones, and creases, lie between random places.
void CellTests::gather_on_faces(const CellBox& box, std::span<const std::int32_t> faces,
                                std::span<const std::int32_t> sheets, Tests& tests) const {
    const std::size_t step = std::max<std::size_t>(1, faces.size() / looked_at);
    for (std::size_t i = 0; i < faces.size(); i += step) {
        const auto p = mesh_.corners(faces[i]);
        const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
        Beside beside{0.0, faces[i], middle, true};
        add_on_surface(box, beside, finer_step * box.half, sheets, tests);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 side = 0.5 * (p[k] + p[(k + 1) % 3]);
            beside.place = side + std::min(1.0, 0.1 * box.half / glm::distance(side, middle)) * 0.5 * (middle - side);
            add_on_surface(box, beside, finer_step * box.half, sheets, tests);
        }
    }
}

CellTests::Choice CellTests::judge(const Tests& tests, const base::Array<double>& value, std::int32_t sheets,
                                   std::int64_t tree) const noexcept {
    const std::span<const std::int32_t> program = trees_.program(sheets, tree);
    const std::int64_t count = tests.distance.size();
    Choice choice;
    choice.tree = tree;
    for (std::int64_t i = 0; i < count; ++i) {
        double stack[ReadOnceTrees::most + 1];
        std::size_t depth = 0;
        for (const std::int32_t code : program) {
            if (code >= 0) {
                stack[depth++] = value[code * count + i];
                continue;
            }
            const double b = stack[--depth];
            const double a = stack[depth - 1];
            stack[depth - 1] = code == PiecesData::larger ? std::max(a, b) : std::min(a, b);
        }
        const double v = stack[0];
        const double d = tests.distance[i];
        if (tests.own[i] >= 0)
            choice.wrong += std::abs(v - value[tests.own[i] * count + i]) > tests.slack[i] ? 1 : 0;
        else if (!(v * d > 0.0))
            ++choice.wrong;
        else
            choice.off += std::min(1.0, std::abs(v - d) / std::abs(d));
    }
    choice.off /= static_cast<double>(std::max<std::int64_t>(count, 1));
    return choice;
}

CellTests::Choice CellTests::choose(base::InstructionSet set, base::Memory& memory,
                                    const base::List<implicit::HrbfData>& sheet, std::span<const std::int32_t> sheets,
                                    std::span<const std::int32_t> faces, const CellBox& box, std::uint64_t cell) const {
    Tests tests(memory);
    gather(box, cell, sheets, tests);
    gather_on_faces(box, faces, sheets, tests);
    const std::int64_t count = tests.distance.size();
    base::Array<double> value(memory);
    value.resize_for_overwrite(count * static_cast<std::int64_t>(sheets.size()));
    for (std::size_t k = 0; k < sheets.size(); ++k)
        implicit::evaluate(set, sheet[sheets[k]],
                           {tests.place.x.data(), tests.place.y.data(), tests.place.z.data(), count},
                           {value.data() + static_cast<std::int64_t>(k) * count, {}, {}});
    const auto functions = static_cast<std::int32_t>(sheets.size());
    Choice best;
    best.side = tests.one_side();
    if (best.side != 0.0) return best;
    for (std::int64_t tree = 0; tree < trees_.count(functions); ++tree) {
        const Choice choice = judge(tests, value, functions, tree);
        const bool better = choice.wrong < best.wrong || (choice.wrong == best.wrong && choice.off < best.off);
        if (best.tree < 0 || better) best = choice;
    }
    return best;
}

} // namespace hrbfnpr::mesh
