// SPDX-License-Identifier: MIT
// Waves at places that have neighbours: what these say of the wave at each.
#pragma once

#include "hatching/sample_graph.h"

namespace hrbfnpr::hatching {

// A wave as another line sees it: turned round if that points the other way.
[[nodiscard]] inline Complex seen(const Complex& z, bool turned) noexcept { return turned ? std::conj(z) : z; }

struct WaveLink {
    Complex factor; // from what stands at its end to what that means at its begin
    std::int32_t to;
    float sense; // -1 where the lines of both point to opposite ways, else 1
};

class WaveLinks {
public:
    // first: of each place's links, and the end; it must outlive these.  links_of(i)(k): link k, one of place i.
    template <class LinksOf>
    WaveLinks(const base::Runtime& runtime, const base::Array<std::int64_t>& first, const base::Progress& progress,
              LinksOf&& links_of)
        : first_(first), link_(runtime.memory) {
        link_.resize_for_overwrite(first[first.size() - 1]);
        runtime.parallel.for_chunks(places(), places_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                const auto link = links_of(i);
                for (std::int64_t k = first[i]; k < first[i + 1]; ++k) link_[k] = link(k);
            }
        });
    }

    // From now on for waves of half the period: along each link the phase grows by twice as much.  An error in the last
    // digits doubles, too.
    void halve(const base::Runtime& runtime, const base::Progress& progress) {
        runtime.parallel.for_chunks(link_.size(), links_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t k = begin; k < end; ++k) link_[k].factor = product(link_[k].factor, link_[k].factor);
        });
    }

    [[nodiscard]] std::int64_t places() const noexcept { return first_.size() - 1; }
    [[nodiscard]] double count(std::int64_t i) const noexcept { return static_cast<double>(first_[i + 1] - first_[i]); }
    // What the neighbours say, all together.
    [[nodiscard]] Complex around(std::int64_t i, const base::Array<Complex>& z) const noexcept {
        Complex sum(0.0);
        for (std::int64_t k = first_[i]; k < first_[i + 1]; ++k) {
            const WaveLink& link = link_[k];
            const Complex& there = z[link.to];
            sum += product(link.factor, {there.real(), static_cast<double>(link.sense) * there.imag()});
        }
        return sum;
    }
    // With what stands there; as high as that where all of them agree.
    [[nodiscard]] Complex mean(std::int64_t i, const base::Array<Complex>& z) const noexcept {
        return (around(i, z) + z[i]) / (1.0 + count(i));
    }

private:
    static constexpr std::int64_t places_a_task = 2048;
    static constexpr std::int64_t links_a_task = 16384;

    const base::Array<std::int64_t>& first_;
    base::Array<WaveLink> link_;
};

} // namespace hrbfnpr::hatching
