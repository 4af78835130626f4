#include "frame/depth_layers/gather.h"

#include "frame/depth_layers/cover_law.h"
#include "frame/depth_layers/gatherer.h"

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t marks_of_work = 8192;

[[nodiscard]] ClearTable clear_table(const Style& style) noexcept {
    ClearTable table{};
    for (std::size_t i = 0; i <= ClearTable::steps; ++i) {
        const float nu = static_cast<float>(i) / ClearTable::steps;
        table.front[i] = sheet_clear(style, -nu);
        table.back[i] = sheet_clear(style, nu);
    }
    table.halo = sheet_clear(style, halo_angle);
    return table;
}

[[nodiscard]] bool same_sheets(const Style& a, const Style& b) noexcept {
    return a.hidden_lines == b.hidden_lines && a.attenuation_front == b.attenuation_front &&
           a.attenuation_back == b.attenuation_back && a.cover_layers == b.cover_layers;
}

} // namespace

float ItemInk::per_pixel(float ppe) const noexcept {
    float ink = 0.0F;
    for (std::int64_t k = 0; k < terms; ++k) {
        const Term& t = term[k];
        const float radius = t.pen->front_ink(ppe);
        float area = disc_ink(radius);
        // The discs of a stroke overlap, and make a line.
        if (t.step > 0.0F) area = std::min(area, 2.0F * radius * t.step * ppe);
        ink += t.marks_per_area * area;
    }
    return ink / (ppe * ppe);
}

Gather::Gather(const base::Runtime& runtime) noexcept
    : runtime_(runtime), loops_(see_loops(runtime.instruction_set)), sights_(runtime.memory),
      item_inks_(runtime.memory), terms_(runtime.memory), clears_(runtime.memory), clear_of_(runtime.memory), work_(runtime.memory),
      inks_(runtime.memory), covers_(runtime.memory), ink_pieces_(runtime.memory), cover_pieces_(runtime.memory),
      counts_(runtime.memory), tau_(runtime.memory), tone_calls_(runtime.memory) {}

// first: the first run of the item.
ItemInk Gather::ink_of(const Scene& scene, std::int64_t first) noexcept {
    ItemInk ink;
    ink.term = terms_.data() + first;
    bool apart = true;
    float lines = 0.0F;
    for (std::int64_t r = first; r < scene.runs.size() && scene.runs[r].item == scene.runs[first].item; ++r) {
        const Run& run = scene.runs[r];
        if (!run.draws_front) continue;
        const float sets = run.sets == 3U ? 1.0F : 0.5F;
        const Style& style = scene.item_of(run).style;
        ItemInk::Term& term = terms_[first + ink.terms++];
        term = {};
        term.pen = &run.pen;
        term.marks_per_area =
            sets * style.group[static_cast<std::size_t>(run.group)].share / (run.pen.spacing * run.pen.spacing);
        // A set has half of the marks, in lines a separation apart.
        if (run.separation > 0.0F) term.step = 2.0F * run.pen.spacing * run.pen.spacing / run.separation;
        if (run.marks->has_strokes()) lines += run.sets == 3U ? 2.0F : 1.0F;
        apart = apart && run.spread_evenly;
    }
    const Overlap overlap = !apart ? Overlap::random : lines > 0.0F ? Overlap::lines : Overlap::blue_noise;
    const float layers = lines + (ink.terms > 1 ? 1.0F : 0.0F);
    for (std::size_t i = 0; i < ink.needed.size(); ++i)
        ink.needed[i] = ink_for(static_cast<float>(i) / needed_steps, overlap, layers);
    return ink;
}

void Gather::set_up(const Scene& scene) {
    frustum_ = frustum_of(scene.lens);
    resize_scratch(sights_, scene.items.size());
    resize_scratch(item_inks_, scene.items.size());
    resize_scratch(terms_, scene.runs.size());
    resize_scratch(clear_of_, scene.items.size());
    clears_.clear();
    for (std::int64_t i = 0; i < scene.items.size(); ++i) {
        sights_[i] = sight_of(scene.items[i], scene.lens, frustum_);
        if (i == 0 || !same_sheets(scene.items[i].style, scene.items[i - 1].style))
            clears_.push_back(clear_table(scene.items[i].style));
        clear_of_[i] = static_cast<std::int32_t>(clears_.size() - 1);
    }
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const std::int32_t item = scene.runs[r].item;
        if (r == 0 || scene.runs[r - 1].item != item) item_inks_[item] = ink_of(scene, r);
    }
}

void Gather::add_pieces(const Scene& scene) {
    work_.clear();
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const Run& run = scene.runs[r];
        const base::Array<marks::Cluster>& clusters = run.marks->clusters.cluster;
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

void Gather::run(Scene& scene) {
    set_up(scene);
    add_pieces(scene);
    ask_tones(scene);
    const std::int64_t places = scene.place_count();
    resize_scratch(inks_, places);
    resize_scratch(covers_, places);
    resize_scratch(ink_pieces_, work_.size());
    resize_scratch(cover_pieces_, work_.size());
    resize_scratch(counts_, work_.size());
    runtime_.parallel.for_each(work_.size(), [&](std::int64_t i) {
        const Work& work = work_[i];
        const Run& run = scene.runs[work.run];
        Gatherer gatherer(*this, scene, run, work.run, work.first_place);
        for (std::int64_t c = work.begin; c < work.end; ++c) {
            gatherer.expect(c + 4);
            gatherer(run.marks->clusters.cluster[c]);
        }
        ink_pieces_[i] = {work.first_place, gatherer.ink_end()};
        cover_pieces_[i] = {work.first_place, gatherer.cover_end()};
        counts_[i] = gatherer.info();
    });
}

void Gather::ask_tones(Scene& scene) {
    const auto asks = [&](const Run& run) { return scene.item_of(run).style.tone == Tone::callback; };
    if (!std::any_of(scene.runs.begin(), scene.runs.end(), asks)) return;
    resize_scratch(tau_, scene.place_count());
    for (const Run& run : scene.runs) {
        if (!asks(run) || !run.draws_front) continue;
        tone_calls_.begin(scene.item_of(run), tau_);
        for (const marks::Cluster& cluster : run.marks->clusters.cluster) ask_cluster(scene, run, cluster);
        tone_calls_.end();
    }
}

void Gather::ask_cluster(const Scene& scene, const Run& run, const marks::Cluster& cluster) {
    if (run.sets != 3U && (run.sets >> cluster.set & 1U) == 0) return;
    const ItemSight& sight = sights_[run.item];
    const ClusterView view = view_cluster(cluster, sight, scene.lens, frustum_, scene.lens.diagonal);
    if (view.outside || view.nu_min > 0.0F) return;
    const marks::MarkBlock* const blocks = run.marks->clusters.block.data() + cluster.block;
    Seen seen;
    loops_.see(sight.seer, {blocks, cluster.count}, seen);
    for (std::int64_t i = 0; i < cluster.count; ++i) {
        if (!(seen.ppe[i] > 0.0F && seen.nu[i] < 0.0F)) continue;
        const marks::MarkBlock& m = blocks[i / marks::MarkBlock::size];
        const std::int64_t at = i % marks::MarkBlock::size;
        tone_calls_.add({m.x[at], m.y[at], m.z[at]}, {m.nx[at], m.ny[at], m.nz[at]},
                        run.first_place + cluster.block * marks::MarkBlock::size + i);
    }
}

FrameInfo Gather::info() const noexcept {
    FrameInfo info;
    for (const FrameInfo& work : counts_) info += work;
    return info;
}

std::int64_t Gather::bytes() const noexcept {
    return sights_.bytes() + item_inks_.bytes() + terms_.bytes() + clears_.bytes() + clear_of_.bytes() + work_.bytes() + inks_.bytes() +
           covers_.bytes() + ink_pieces_.bytes() + cover_pieces_.bytes() + counts_.bytes() + tau_.bytes() +
           tone_calls_.bytes();
}

} // namespace hrbfnpr::frame
