// SPDX-License-Identifier: MIT
#include "visibility/events.h"

namespace hrbfnpr::visibility {

Lengths::Lengths(base::Memory& memory, const ImageLines& lines) : length_(memory, lines.pieces.size() + 1) {
    for (const Line& line : lines.lines)
        for (std::int64_t p = line.first_point; p + 1 < line.first_point + line.points; ++p)
            length_[lines.points[p].piece + 1] += glm::distance(lines.points[p].place, lines.points[p + 1].place);
    for (std::int64_t i = 0; i + 1 < length_.size(); ++i) length_[i + 1] += length_[i];
}

// At a cusp the curve goes on behind its own surface where it turns away from the eye, and comes out where it turns
// to it.
Events collect_events(base::Memory& memory, std::span<const Subject> subjects, const ImageLines& lines,
                      const base::Array<Crossing>& crossings, const Lengths& lengths) {
    Events events(memory);
    std::int64_t c = 0;
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
            for (; c < crossings.size() && crossings[c].far_piece == piece; ++c)
                events.event.push_back({piece, crossings[c].far_share, crossings[c].change, crossings[c].near_piece,
                                        lengths.at(line, piece, crossings[c].far_share),
                                        static_cast<float>(crossings[c].sine)});
        }
    }
    events.first.push_back(events.event.size());
    return events;
}

} // namespace hrbfnpr::visibility
