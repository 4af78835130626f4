// SPDX-License-Identifier: MIT
#include "visibility/events.h"

#include <algorithm>

namespace hrbfnpr::visibility {

Lengths::Lengths(base::Memory& memory, const ImageLines& lines)
    : lines_(lines), length_(memory, lines.points.size()), first_(memory, lines.pieces.size()) {
    for (const Line& line : lines.lines) {
        double all = 0.0;
        const std::int64_t end = line.first_point + line.points;
        for (std::int64_t p = line.first_point; p < end; ++p) {
            if (p > line.first_point) all += glm::distance(lines.points[p - 1].place, lines.points[p].place);
            length_[p] = all;
        }
        for (std::int64_t p = end - 2; p >= line.first_point; --p) first_[lines.points[p].piece] = p;
    }
}

// Along the chord that the share lies on: the image of a cubic is not passed at one speed, least of all at a cusp.
double Lengths::at(const Line& line, std::int64_t piece, double share) const noexcept {
    const bool last = piece + 1 == line.first_piece + line.pieces;
    const std::int64_t end = last ? line.first_point + line.points - 1 : first_[piece + 1];
    const ImagePoint* const begin = lines_.points.data() + first_[piece];
    const ImagePoint* const next = std::upper_bound(begin + 1, lines_.points.data() + end, share,
                                                    [](double s, const ImagePoint& p) { return s < p.share; });
    const std::int64_t p = next - 1 - lines_.points.data();
    const double from = lines_.points[p].share;
    const double to = p + 1 == end ? 1.0 : lines_.points[p + 1].share;
    const double on_chord = to > from ? std::clamp((share - from) / (to - from), 0.0, 1.0) : 0.0;
    return length_[p] + on_chord * (length_[p + 1] - length_[p]);
}

Events collect_events(base::Memory& memory, std::span<const Subject> subjects, const ImageLines& lines,
                      const base::Array<Crossing>& crossings, std::span<const Pierced> pierced,
                      const Lengths& lengths) {
    Events events(memory);
    std::int64_t c = 0;
    std::size_t next = 0;
    for (const Line& line : lines.lines) {
        events.first.push_back(events.event.size());
        const Subject& subject = subjects[static_cast<std::size_t>(line.subject)];
        const curves::Curves& curves = *subject.curves;
        for (std::int64_t k = 0; k < line.pieces; ++k) {
            const auto piece = static_cast<std::int32_t>(line.first_piece + k);
            const std::int64_t a = lines.pieces[piece].a;
            if (!curves.cusp.empty() && curves.cusp[a] != 0 && (k > 0 || line.closed)) {
                const curves::CurvePoint& p = curves.point[a];
                const bool away = glm::dot(p.direction(), subject.view.sight(p.position)) > 0.0;
                events.event.push_back({piece, 0.0, away ? 1 : -1, -1, lengths.at(line, piece, 0.0), 0.0F});
                ++events.cusps;
            }
            const auto add_pierced = [&](double up_to) {
                for (; next < pierced.size() && pierced[next].piece == piece && pierced[next].share < up_to; ++next)
                    events.event.push_back({piece, pierced[next].share, pierced[next].change, no_line,
                                            lengths.at(line, piece, pierced[next].share), 0.0F});
            };
            for (; c < crossings.size() && crossings[c].far_piece == piece; ++c) {
                add_pierced(crossings[c].far_share);
                events.event.push_back({piece, crossings[c].far_share, crossings[c].change, crossings[c].near_piece,
                                        lengths.at(line, piece, crossings[c].far_share),
                                        static_cast<float>(crossings[c].sine), crossings[c].near_share});
            }
            add_pierced(2.0);
        }
    }
    events.first.push_back(events.event.size());
    return events;
}

} // namespace hrbfnpr::visibility
