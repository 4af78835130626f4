// SPDX-License-Identifier: MIT
#include "frame/depth_layers/gather.h"

#include "frame/depth_layers/gatherer.h"
#include "frame/scene/splat_law.h"

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t marks_of_work = 8192;

[[nodiscard]] TransmittanceTable transmittance_table(const ItemView& item) noexcept {
    TransmittanceTable table{};
    for (std::size_t i = 0; i <= TransmittanceTable::steps; ++i) {
        const float nu = static_cast<float>(i) / TransmittanceTable::steps;
        table.front[i] = layer_transmittance(item.style, -nu, item.both_sides);
        table.back[i] = layer_transmittance(item.style, nu, item.both_sides);
    }
    table.halo = layer_transmittance(item.style, halo_angle, false);
    return table;
}

// Hatching sees its marks itself: neither dots nor splats come from them.
[[nodiscard]] bool is_unused(const Run& run) noexcept { return run.as_hatch && !run.splats; }

[[nodiscard]] bool same_layers(const ItemView& one, const ItemView& other) noexcept {
    const Style& a = one.style;
    const Style& b = other.style;
    return one.both_sides == other.both_sides && a.hidden_lines == b.hidden_lines &&
           a.attenuation_front == b.attenuation_front && a.attenuation_back == b.attenuation_back &&
           a.splat_overlap == b.splat_overlap;
}

} // namespace

float Gather::ink_per_pixel(const ItemInk& item, float pixels_per_unit) const noexcept {
    float ink = 0.0F;
    for (std::int64_t k = item.first; k < item.end; ++k) {
        const ItemInk::Term& t = terms_[k];
        const float radius = t.pen->front_ink(pixels_per_unit);
        float area = disc_ink(radius);
        // The discs of a stroke overlap, and make a line.
        if (t.step > 0.0F) area = std::min(area, 2.0F * radius * t.step * pixels_per_unit);
        ink += t.marks_per_area * area;
    }
    return ink / (pixels_per_unit * pixels_per_unit);
}

Gather::Gather(const base::Runtime& runtime) noexcept
    : runtime_(runtime), loops_(see_loops(runtime.instruction_set)), sights_(runtime.memory),
      item_inks_(runtime.memory), terms_(runtime.memory), transmittances_(runtime.memory),
      transmittance_of_(runtime.memory), work_(runtime.memory), counts_(runtime.memory), tau_(runtime.memory),
      tone_calls_(runtime.memory) {}

// first: the first run of the item.
ItemInk Gather::ink_of(const Scene& scene, std::int64_t first) {
    ItemInk ink;
    ink.first = terms_.size();
    bool apart = true;
    float lines = 0.0F;
    for (std::int64_t r = first; r < scene.runs.size() && scene.runs[r].item == scene.runs[first].item; ++r) {
        const Run& run = scene.runs[r];
        if (!run.draws_front || !run.makes_tone || run.as_hatch) continue; // hatching makes a tone of its own
        // Lines of blue-noise hatching have one direction, other strokes two with half of the marks each.
        const bool has_one = run.scattered || (run.marks->progressive && run.marks->kind == marks::Kind::hatch);
        const float directions = has_one || run.directions == 3U ? 1.0F : 0.5F;
        ItemInk::Term term;
        term.pen = &run.pen;
        term.marks_per_area = directions * run.style->share / (run.pen.spacing * run.pen.spacing);
        // Lines of one direction are a separation apart.
        if (run.separation > 0.0F)
            term.step = (has_one ? 1.0F : 2.0F) * run.pen.spacing * run.pen.spacing / run.separation;
        if (!run.scattered) lines += has_one || run.directions != 3U ? 1.0F : 2.0F;
        terms_.push_back(term);
        apart = apart && run.spread_evenly;
    }
    ink.end = terms_.size();
    const Overlap overlap = !apart ? Overlap::random : lines > 0.0F ? Overlap::lines : Overlap::blue_noise;
    const float layers = lines + (ink.end - ink.first > 1 ? 1.0F : 0.0F);
    for (std::size_t i = 0; i < ink.needed.size(); ++i)
        ink.needed[i] = ink_for(static_cast<float>(i) / needed_steps, overlap, layers);
    return ink;
}

void Gather::set_up(const Scene& scene) {
    frustum_ = frustum_of(scene.lens);
    base::resize_scratch(sights_, scene.items.size());
    base::resize_scratch(item_inks_, scene.items.size());
    terms_.clear();
    base::resize_scratch(transmittance_of_, scene.items.size());
    transmittances_.clear();
    for (std::int64_t i = 0; i < scene.items.size(); ++i) {
        sights_[i] = sight_of(scene.items[i], scene.lens, frustum_);
        if (i == 0 || !same_layers(scene.items[i], scene.items[i - 1]))
            transmittances_.push_back(transmittance_table(scene.items[i]));
        transmittance_of_[i] = static_cast<std::int32_t>(transmittances_.size() - 1);
    }
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const std::int32_t item = scene.runs[r].item;
        if (r == 0 || scene.runs[r - 1].item != item) item_inks_[item] = ink_of(scene, r);
    }
}

void Gather::add_pieces(const Scene& scene) {
    work_.clear();
    unused_ = 0;
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const Run& run = scene.runs[r];
        if (is_unused(run)) {
            unused_ += run.count;
            continue;
        }
        const base::Array<marks::Cluster>& clusters = run.clusters->cluster;
        Work work{static_cast<std::int32_t>(r), 0, 0, run.first_place};
        std::int64_t marks = 0;
        for (std::int64_t c = 0; c < clusters.size(); ++c) {
            work.end = static_cast<std::int32_t>(c + 1);
            const bool last = c + 1 == clusters.size();
            marks += clusters[c].count;
            if (!last && marks < marks_of_work) continue;
            work_.push_back(work);
            work.begin = work.end;
            work.first_place = run.first_place + (last ? 0 : clusters[c + 1].block * marks::MarkBlock::size);
            marks = 0;
        }
    }
}

void Gather::run(Scene& scene, drawing::Drawing& drawing) {
    set_up(scene);
    add_pieces(scene);
    ask_tones(scene);
    const std::int64_t places = scene.place_count();
    base::resize_scratch(drawing.dots, places);
    base::resize_scratch(drawing.splats, places);
    base::resize_scratch(drawing.dot_pieces, work_.size());
    base::resize_scratch(drawing.splat_pieces, work_.size());
    base::resize_scratch(counts_, work_.size());
    runtime_.parallel.for_each(work_.size(), [&](std::int64_t i) {
        const Work& work = work_[i];
        const Run& run = scene.runs[work.run];
        Gatherer gatherer(*this, scene, run, work.run, drawing.dots.data() + work.first_place,
                          drawing.splats.data() + work.first_place);
        for (std::int64_t c = work.begin; c < work.end; ++c) {
            gatherer.expect(c + 4);
            gatherer(run.clusters->cluster[c]);
        }
        drawing.dot_pieces[i] = {work.first_place, gatherer.dots_end() - drawing.dots.data()};
        drawing.splat_pieces[i] = {work.first_place, gatherer.splats_end() - drawing.splats.data()};
        counts_[i] = gatherer.info();
    });
}

void Gather::ask_tones(Scene& scene) {
    const auto asks = [&](const Run& run) { return scene.item_of(run).style.tone == Tone::callback; };
    if (!std::any_of(scene.runs.begin(), scene.runs.end(), asks)) return;
    base::resize_scratch(tau_, scene.place_count());
    std::fill(tau_.begin(), tau_.end(), 0.0F); // of marks that are not asked for, which loops read and do not use
    for (const Run& run : scene.runs) {
        if (!asks(run) || !run.draws_front) continue;
        tone_calls_.begin(scene.item_of(run), tau_);
        for (const marks::Cluster& cluster : run.clusters->cluster) ask_cluster(scene, run, cluster);
        tone_calls_.end();
    }
}

void Gather::ask_cluster(const Scene& scene, const Run& run, const marks::Cluster& cluster) {
    if (run.directions != 3U && (run.directions >> cluster.set & 1U) == 0) return;
    const ItemSight& sight = sights_[run.item];
    const ClusterView view = view_cluster(cluster, sight, scene.lens, frustum_, scene.lens.diagonal);
    if (view.outside || view.nu_min > 0.0F) return;
    const marks::MarkBlock* const blocks = run.clusters->block.data() + cluster.block;
    Seen seen;
    loops_.see(sight.seer, {blocks, cluster.count}, seen);
    for (std::int64_t i = 0; i < cluster.count; ++i) {
        if (!(seen.pixels_per_unit[i] > 0.0F && seen.nu[i] < 0.0F)) continue;
        const marks::MarkBlock& m = blocks[i / marks::MarkBlock::size];
        const std::int64_t at = i % marks::MarkBlock::size;
        tone_calls_.add({m.x[at], m.y[at], m.z[at]}, run.tone_normal_of(m.mark[at]),
                        run.first_place + cluster.block * marks::MarkBlock::size + i);
    }
}

Counts Gather::info() const noexcept {
    Counts info;
    info.marks = info.culled = unused_;
    for (const Counts& work : counts_) info += work;
    return info;
}

std::int64_t Gather::bytes() const noexcept {
    return sights_.bytes() + item_inks_.bytes() + terms_.bytes() + transmittances_.bytes() + transmittance_of_.bytes() +
           work_.bytes() + counts_.bytes() + tau_.bytes() + tone_calls_.bytes();
}

} // namespace hrbfnpr::frame
