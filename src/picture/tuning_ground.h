// SPDX-License-Identifier: MIT
// Constants for the ground of a picture. Lengths are in diagonals of the object, unless they have another unit.
#pragma once

namespace hrbfnpr::picture {

struct GroundTuning {
    // The ground is below the lowest place of the object by this. Larger: a gap between the object and its shadow.
    // Smaller: the object's lowest lines may be hidden by the ground.
    double sink = 5e-4;
    // The picture shows shadows up to this far beyond the object. Larger: the object gets smaller beside its shadow.
    double framed = 0.5;
    // Marks are placed up to this far beyond the object, for shadows of low lights. Larger: more marks.
    double longest_shadow = 3.0;
    // Marks are placed up to this far beyond a shadow. Larger: more marks that stay white.
    double margin = 0.02;
    // A light whose direction has less than this along the up direction counts as if it had this. Larger: shadows of
    // low lights end too early.
    double lowest_light = 0.02;
    // The box of the ground is this high. Larger: less exact positions of marks.
    double thickness = 0.01;
    // The ambient light of the ground, in shares of all other light, if the style has none, and at most. Larger:
    // shadows that are paler, and darker beside the object than elsewhere.
    double ambient = 0.3;
    // The ground draws light as black as the picture does, up to this share of the light of open ground. Larger:
    // shadows may be darker.
    float most_black = 0.5F;
    // The light of open ground is at least this, so that the ground is white if all lights are below it. Larger: dim
    // grounds are grey.
    double least_light = 1e-3;
    // The softness of the first light, in radians, if no light casts shadows. Larger: softer borders.
    float softness = 0.06F;
    // Light that is less than this share below that of open ground is white. Larger: fewer marks at the rims of
    // shadows.
    double white_share = 0.005;
    // The darkness at which the first stipples of the ground are drawn, and at which its lines of hatching end, at
    // least. Larger: lights are emptier.
    float first_marks = 0.08F;
    // Marks on a ground that is seen at a low angle are spread as if its foreshortening were this. Larger: fewer lines
    // and stipples, seen from above.
    double least_foreshortening = 0.2;
    // The distance of the marks along a line of hatching, in pixels. Larger: borders of shadows are less exact.
    double step = 2.5;
    // The number of places on the rim of the ground that lie between the planes of the camera.
    int rim = 16;
    // The number of cells along the diagonal of the ground's mesh, on which borders of shadows are drawn. Larger: more
    // time.
    double cells = 100.0;
};
inline constexpr GroundTuning ground_tuning;

} // namespace hrbfnpr::picture
