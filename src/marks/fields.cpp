// SPDX-License-Identifier: MIT
#include "marks/fields.h"

#include <algorithm>
#include <limits>

namespace hrbfnpr::marks {
namespace {

template <class Owner, class... Members>
void lend_arrays(const Owner& from, Owner& to, Members... member) {
    ((to.*member = (from.*member).lent()), ...);
}

void lend(const MarkClusters& from, MarkClusters& to) {
    lend_arrays(from, to, &MarkClusters::block, &MarkClusters::width, &MarkClusters::cluster, &MarkClusters::piece,
                &MarkClusters::gap);
}

void lend(const LayerReport& from, LayerReport& to) {
    to.full_count = from.full_count;
    to.levels = from.levels;
    to.step = from.step;
    to.seconds = from.seconds;
    to.level = from.level.lent();
}

void lend(const Layer& from, Layer& to) {
    to.name = from.name;
    to.progressive = from.progressive;
    to.whole = from.whole;
    to.tone_begin = from.tone_begin;
    lend_arrays(from, to, &Layer::position, &Layer::normal, &Layer::direction, &Layer::curvature, &Layer::rank,
                &Layer::level, &Layer::stroke, &Layer::width, &Layer::tone_normal, &Layer::stroke_first,
                &Layer::stroke_order);
    lend(from.clusters, to.clusters);
    lend(from.report, to.report);
}

// Calls visit(field) for the first field of each name, in the order of numbers, until it returns true.
template <class Visit>
void for_fields(const PointSet& set, Visit&& visit) {
    for (std::int64_t k = 0; k < set.layers.size(); ++k)
        for (const MarkField& field : set.layers[k].fields) {
            const auto has_it = [&](const Layer& layer) { return layer.field_of(field.name.data()) != nullptr; };
            if (!std::any_of(set.layers.begin(), set.layers.begin() + k, has_it) && visit(field)) return;
        }
}

} // namespace

MarkField copy_of(const MarkField& field, base::Memory& memory) {
    MarkField copy(memory);
    copy.name = field.name;
    copy.kind = field.kind;
    copy_array(field.value, copy.value);
    copy_array(field.weight, copy.weight);
    return copy;
}

PointSet sharing_marks(base::Memory& memory, const PointSet& set, std::span<const LayerName> replaced) {
    PointSet shared(memory);
    shared.distribution = set.distribution;
    shared.seed_source = set.seed_source;
    shared.origin = set.origin;
    shared.bounds = set.bounds;
    shared.spacing = set.spacing;
    shared.unit = set.unit;
    shared.seeds = set.seeds;
    shared.seconds_seeds = set.seconds_seeds;
    shared.seconds_total = set.seconds_total;
    shared.still = set.still.lent();
    for (const Layer& layer : set.layers) {
        Layer& own = shared.layers.add(memory, layer.kind);
        lend(layer, own);
        for (const MarkField& field : layer.fields)
            if (std::find(replaced.begin(), replaced.end(), field.name) == replaced.end())
                own.fields.add(copy_of(field, memory));
    }
    return shared;
}

const MarkField* field_at(const PointSet& set, std::int64_t number) noexcept {
    const MarkField* found = nullptr;
    for_fields(set, [&](const MarkField& field) {
        if (number-- == 0) found = &field;
        return found != nullptr;
    });
    return found;
}

std::int64_t field_count(const PointSet& set) noexcept {
    std::int64_t count = 0;
    for_fields(set, [&](const MarkField& /*field*/) {
        ++count;
        return false;
    });
    return count;
}

const MarkField* field_of(const PointSet& set, const char* name) noexcept {
    for (const Layer& layer : set.layers)
        if (const MarkField* const field = layer.field_of(name)) return field;
    return nullptr;
}

} // namespace hrbfnpr::marks
