// SPDX-License-Identifier: MIT
#include "implicit/pieces.h"

#include "implicit/pieces_block.h"
#include "implicit/prepared.h"

#include <algorithm>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t slice_size = 256;
constexpr double points_a_cell = 40.0; // from which on zones are worth it
// Sheets that are fewer have enough points each in any slice.
constexpr std::int64_t few_sheets = 8;

// Points of a slice that are evaluated together, in their order, and what they are.
class GatheredPoints {
public:
    // visit: called with the function that takes a point's index.
    template <class ForPoints>
    PointBatch points(const PointBatch& from, ForPoints&& for_points) noexcept {
        std::int64_t count = 0;
        for_points([&](std::int32_t i) {
            x_[count] = from.x[i];
            y_[count] = from.y[i];
            z_[count] = from.z[i];
            index_[count++] = i;
        });
        return {x_, y_, z_, count};
    }
    [[nodiscard]] FieldBatch fields(const FieldBatch& wanted) noexcept {
        FieldBatch fields;
        if (wanted.value != nullptr) fields.value = field_[0];
        for (std::size_t c = 0; wanted.wants_gradient() && c < 3; ++c) fields.gradient[c] = field_[1 + c];
        for (std::size_t c = 0; wanted.wants_hessian() && c < 6; ++c) fields.hessian[c] = field_[4 + c];
        return fields;
    }
    void scatter(std::int64_t count, const FieldBatch& to) const noexcept {
        scatter(field_[0], count, to.value);
        for (std::size_t c = 0; c < 3; ++c) scatter(field_[1 + c], count, to.gradient[c]);
        for (std::size_t c = 0; c < 6; ++c) scatter(field_[4 + c], count, to.hessian[c]);
    }
    [[nodiscard]] std::int32_t index(std::int64_t i) const noexcept { return index_[i]; }

private:
    void scatter(const double* from, std::int64_t count, double* to) const noexcept {
        for (std::int64_t i = 0; to != nullptr && i < count; ++i) to[index_[i]] = from[i];
    }

    double x_[slice_size], y_[slice_size], z_[slice_size];
    double field_[10][slice_size];
    std::int32_t index_[slice_size];
};

// The points of a slice, by the one sheet that rules them: others are the group of -1.
class Groups {
public:
    void find(const PiecesZones& zones, const PointBatch& points) noexcept {
        count_ = 0;
        for (std::int32_t i = 0; i < points.count; ++i) {
            const glm::dvec3 place(points.x[i], points.y[i], points.z[i]);
            const std::int32_t zone = zones.at(place);
            const PiecesZones::Part* const alone = zone >= 0 ? zones.alone_at(zones[zone], place) : nullptr;
            at_[i] = {zone, alone};
            if (alone == nullptr)
                add(zone >= 0 || zone == PiecesZones::nowhere ? -1 : -1 - zone, i);
            else
                add(zones.sheet_of(*alone), i);
        }
    }
    [[nodiscard]] std::int64_t count() const noexcept { return count_; }
    [[nodiscard]] std::int32_t sheet(std::int64_t group) const noexcept { return group_[group].sheet; }
    [[nodiscard]] const PiecesBlock::At& at(std::int32_t point) const noexcept { return at_[point]; }
    template <class Visit>
    void for_points(std::int64_t group, Visit&& visit) const {
        for (std::int32_t i = group_[group].first; i >= 0; i = next_[i]) visit(i);
    }

private:
    struct Group {
        std::int32_t sheet, first, last;
    };

    void add(std::int32_t sheet, std::int32_t point) noexcept {
        next_[point] = -1;
        for (std::int64_t g = count_ - 1; g >= 0; --g) {
            if (group_[g].sheet != sheet) continue;
            next_[group_[g].last] = point;
            group_[g].last = point;
            return;
        }
        group_[count_++] = {sheet, point, point};
    }

    std::int64_t count_ = 0;
    Group group_[slice_size];
    std::int32_t next_[slice_size];
    PiecesBlock::At at_[slice_size];
};

// What evaluating works in.
class Work {
public:
    explicit Work(const PiecesParts& parts) noexcept : parts_(parts), block_(parts) {}

    void evaluate(const PointBatch& points, const FieldBatch& fields) {
        for_groups(points, [&](const PointBatch& some, std::int32_t sheet, const PiecesBlock::At* at) {
            const FieldBatch here = gathered_.fields(fields);
            if (sheet >= 0) parts_.evaluate_sheet(sheet, some, here);
            for (std::int64_t begin = 0; sheet < 0 && begin < some.count;) {
                const std::int64_t taken = block_.take(slice(some, begin, some.count), at + begin);
                block_.evaluate(here.from(begin));
                begin += taken;
            }
            gathered_.scatter(some.count, fields);
        });
    }

    void active(const PointBatch& points, std::int32_t* active) {
        for_groups(points, [&](const PointBatch& some, std::int32_t sheet, const PiecesBlock::At* at) {
            std::fill_n(active_, some.count, sheet);
            for (std::int64_t begin = 0; sheet < 0 && begin < some.count;) {
                const std::int64_t taken = block_.take(slice(some, begin, some.count), at + begin);
                block_.active(active_ + begin);
                begin += taken;
            }
            for (std::int64_t i = 0; i < some.count; ++i) active[gathered_.index(i)] = active_[i];
        });
    }

private:
    template <class Visit>
    void for_groups(const PointBatch& points, Visit&& visit) {
        groups_.find(*parts_.zones, points);
        for (std::int64_t g = 0; g < groups_.count(); ++g) {
            const PointBatch some = gathered_.points(points, [&](auto&& add) { groups_.for_points(g, add); });
            for (std::int64_t i = 0; i < some.count; ++i) at_[i] = groups_.at(gathered_.index(i));
            visit(some, groups_.sheet(g), at_);
        }
    }

    const PiecesParts& parts_;
    PiecesBlock block_;
    Groups groups_;
    GatheredPoints gathered_;
    PiecesBlock::At at_[slice_size];
    std::int32_t active_[slice_size];
};

} // namespace

void PiecesParts::evaluate_sheet(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const {
    if (prepared != nullptr && prepared[sheet] != nullptr)
        prepared[sheet]->evaluate(points, fields);
    else
        implicit::evaluate(set, data.sheet[sheet], points, fields);
}

void PiecesOf::evaluate(const PointBatch& points, const FieldBatch& fields) const {
    if (parts_.zones == nullptr) {
        base::Boxed<PiecesBlock> block(data().child.memory(), parts_);
        for (std::int64_t begin = 0; begin < points.count;) {
            const std::int64_t count = block->take(slice(points, begin, points.count), nullptr);
            block->evaluate(fields.from(begin));
            begin += count;
        }
        return;
    }
    base::Boxed<Work> work(data().child.memory(), parts_);
    for (std::int64_t begin = 0; begin < points.count; begin += slice_size)
        work->evaluate(slice(points, begin, std::min(points.count, begin + slice_size)), fields.from(begin));
}

void PiecesOf::active(const PointBatch& points, std::int32_t* sheet) const {
    if (parts_.zones == nullptr) {
        base::Boxed<PiecesBlock> block(data().child.memory(), parts_);
        for (std::int64_t begin = 0; begin < points.count;) {
            const std::int64_t count = block->take(slice(points, begin, points.count), nullptr);
            block->active(sheet + begin);
            begin += count;
        }
        return;
    }
    base::Boxed<Work> work(data().child.memory(), parts_);
    for (std::int64_t begin = 0; begin < points.count; begin += slice_size)
        work->active(slice(points, begin, std::min(points.count, begin + slice_size)), sheet + begin);
}

std::int64_t PiecesOf::cells() const noexcept {
    if (parts_.zones == nullptr) return data().leaves();
    bool order = data().sheet.size() > few_sheets;
    for (std::int64_t i = 0; !order && i < data().sheet.size(); ++i) order = parts_.prepared[i] != nullptr;
    return order ? parts_.zones->cells() : 0;
}

void PiecesOf::evaluate(std::int32_t sheet, const PointBatch& points, const FieldBatch& fields) const {
    if (sheet < data().sheet.size())
        parts_.evaluate_sheet(sheet, points, fields);
    else
        evaluate(points, fields);
}

// Measured on two cores: zones take some 20 us a cell, and save some 0.5 us a point.
std::optional<PreparedPieces::Scope> PreparedPieces::pays(const PiecesData& data, double points) noexcept {
    if (points < points_a_cell * static_cast<double>(data.leaves())) return std::nullopt;
    const auto all = static_cast<double>(data.centres());
    for (const HrbfData& one : data.sheet) // asked for as often as its centres are of all
        if (Prepared::pays(one, points * static_cast<double>(one.count()) / all)) return Scope::sheets;
    return Scope::zones;
}

PreparedPieces::PreparedPieces(const base::Runtime& runtime, const PiecesOf& of, Scope scope,
                               const base::Progress& progress)
    : ReadyPieces{{},
                  {runtime, of.data(), progress},
                  base::List<std::unique_ptr<Prepared>>(runtime.memory),
                  base::Array<const Prepared*>(runtime.memory, of.data().sheet.size())},
      PiecesOf({of.instruction_set(), of.data(), &zones, pointer.data()}) {
    runtime.log(base::LogLevel::info, "cells of %lld sheets prepared in %.3f s, %.1f MB",
                static_cast<long long>(data().sheet.size()), watch.seconds(), static_cast<double>(zones.bytes()) / 1e6);
    for (std::int64_t i = 0; scope == Scope::sheets && i < data().sheet.size(); ++i) {
        sheet.add(Prepared::make(runtime, data().sheet[i], progress));
        pointer[i] = sheet.back().get();
    }
}

PreparedPieces::~PreparedPieces() = default;

std::int64_t PreparedPieces::bytes() const noexcept {
    std::int64_t sum = zones.bytes();
    for (const std::unique_ptr<Prepared>& one : sheet) sum += one != nullptr ? one->bytes() : 0;
    return sum;
}

} // namespace hrbfnpr::implicit
