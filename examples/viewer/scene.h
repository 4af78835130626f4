// SPDX-License-Identifier: MIT
// Makes a picture from a file or a formula, and new pictures of it from other choices. The worker runs this.
#pragma once

#include "choices.h"
#include "readers/shape.h"
#include "work.h"

namespace viewer {

// The model to draw: a shape, a model or saved marks.
struct Source {
    std::string name;
    Shape shape;
    Model model;                    // may be null
    PointSet marks;                 // may be null
    Vec up{};                       // 0: the library finds it
    bool has_right_normals = false; // true if a formula gives them
};

// Returns the names of models made by formulas. The last ones are fitted to samples of a formula.
const std::vector<std::string>& formulas();
Source source_of_formula(const std::string& name, Work& work);
// Loads a mesh, points, a saved model or saved marks.
Source source_of_file(const std::string& path, Work& work);

// The squares of side 2 rho_0 on the surface, as in Figure 5.
struct Patches {
    std::vector<std::array<Vec, 4>> corners; // counter-clockwise from outside, for the estimate
    double estimate = 0;                     // the library's estimate of rho_0; 0: it has none
};

// The style and the marks of a picture, copied so that panels can change them.
struct Sheet {
    hrbfnpr_style style{};
    std::vector<hrbfnpr_layer_style> layers;
    std::vector<hrbfnpr_line_style> lines;
    hrbfnpr_generate_desc marks{};
    std::vector<hrbfnpr_layer_desc> mark_layers; // empty: the marks were given
};

struct Timing {
    std::string stage;
    double milliseconds;
};

// A picture and the data about it.
struct Scene {
    std::string name;
    Picture picture;
    hrbfnpr_picture_info info{};
    std::vector<hrbfnpr_picture_part> parts;
    std::vector<double> lipschitz; // one for each part's model, for rays
    Sheet sheet;                   // its names and levels live as long as the picture
    hrbfnpr_camera camera{};       // the planned one
    Size size;
    Patches patches;
    std::vector<Timing> timings;
    std::vector<std::string> surface_notes, notes; // the library's notes about the surfaces, and about the picture

    Vec centre() const;
    double diagonal() const;
    bool has_model() const { return !parts.empty() && parts.front().model != nullptr; }
    bool has_edges() const;                         // true if lines of the kind CREASE can be drawn
    std::vector<hrbfnpr_layer_info> layers() const; // layers of the picture's marks
};

Scene scene_of(const Source& source, const Choices& choices, Size size, Work& work);
// Draws the same surfaces with other choices. view: null means the one that the library plans.
Scene restyled(const Scene& scene, const Choices& choices, Size size, const View* view, bool wants_patches, Work& work);
// Makes only the picture.
Picture restyled_picture(const Picture& picture, const Choices& choices, Size size, const View* view, Work& work);

std::string settings_of(const Picture& picture);

} // namespace viewer
