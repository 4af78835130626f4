// SPDX-License-Identifier: MIT
// From a file or a formula to a surface, and from that to marks and lines: what the worker does.
#pragma once

#include "settings.h"
#include "work.h"

namespace viewer {

struct Surface {
    std::string name;
    Model model;             // none: saved marks
    PointSet marks;          // saved ones
    std::vector<Vec> places; // spread over it
    Vec low{}, high{};       // the bounds of these
    double area = 0;
    double lipschitz = 0; // for rays
    bool is_trimmed = false;
    Vec up{0, 1, 0};
    std::vector<Timing> timings;
    std::vector<std::string> notes;

    Vec centre() const { return 0.5 * (low + high); }
    double diagonal() const { return length(high - low); }
};

// Figure 5: squares of side 2 rho_0 on the surface.
struct Patches {
    std::vector<std::array<Vec, 4>> corners; // counter-clockwise from outside
    double step = 0;                         // rho_0 that they are drawn for
    double estimate = 0;                     // what the library would choose
};

// What is drawn of a surface.
struct Ink {
    PointSet marks;
    LineSet lines;                          // may be none
    std::vector<hrbfnpr_layer_desc> layers; // as they are to be ...
    std::vector<hrbfnpr_layer_desc> made;   // ... and as they are: coarser, of the first of two
    Patches patches;
    std::vector<Timing> timings;
    std::vector<hrbfnpr_layer_info> infos;
};

// Names of models made by formulas; the last ones are fitted to samples of a formula.
const std::vector<std::string>& formulas();
Surface surface_of_formula(const std::string& name, const Settings& settings, Work& work);
// A mesh, points, a saved model or saved marks.
Surface surface_of_file(const std::string& path, const Settings& settings, Work& work);

// Marks for a picture of this size and camera.  `wants_patches`: Figure 5's too.  `coarse`: a few lines of hatching, so
// that there is something to see while the others are traced.
Ink ink_of(const Surface& surface, const Settings& settings, Size size, bool wants_patches, bool coarse, Work& work);
// Whether a coarse one is made so much sooner that it is worth it.
bool has_hatching(const Settings& settings);
Patches patches_of(const Surface& surface, const Settings& settings, Work& work);

// The radius of the pen, pixels.
double pen_of(const Settings& settings, Size size);
// The style with lines and dots for a picture of this size.
Style style_for(const Settings& settings, Size size, const Surface& surface);
// As a set by the published recursion is drawn: dots of one size.
void draw_as_published(Style& style, std::uint32_t preset);

} // namespace viewer
