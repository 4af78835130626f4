// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/presets.py; do not edit.
namespace HrbfNpr
{
    /// <summary>Named styles.</summary>
    [NativeConstants("HRBFNPR_PRESET_")]
    public enum Preset
    {
        /// <summary>Stipples by light, no contours.</summary>
        Stipple = 0,
        /// <summary>Lines of one width, more of them where it is darker, and contours.</summary>
        Hatch = 1,
        /// <summary>
        /// Up to three sets of such lines, at 0, 35 and -30 degrees, a darker tone each, and contours.
        /// </summary>
        CrossHatch = 2,
        /// <summary>Lines along Stark's combing direction, a second set in the darks, and contours.</summary>
        Combing = 3,
        /// <summary>Contours only, hidden ones attenuated.</summary>
        Silhouette = 4,
        /// <summary>Contours and stipples.</summary>
        ContourAndStipple = 5,
        /// <summary>Contours only, hidden ones shown.</summary>
        Xray = 6,
        /// <summary>Stipples, cross hatching in the darks, contours and halo: Figure 1 (e).</summary>
        Full = 7,
        /// <summary>One set of lines that swell with the tone, and contours; lights are empty.</summary>
        Engraving = 8,
        /// <summary>
        /// Up to three sets of thin lines, at 0, 50 and -40 degrees, a darker tone each, and contours.
        /// </summary>
        Etching = 9,
        /// <summary>Few wide lines, which close up to black, and heavy contours.</summary>
        Woodcut = 10,
        /// <summary>Fine stipples lit from the upper left, empty lights; outlines swell in the shade.</summary>
        ScientificStipple = 11,
        /// <summary>
        /// Pencil on warm paper: two sets of lines that stray and run past their ends, contours drawn twice.
        /// </summary>
        Sketch = 12,
        /// <summary>
        /// Pale lines on blue without tone: contours, borders, creases and lines called "crease", hidden ones dashed.
        /// </summary>
        Blueprint = 13,
        /// <summary>
        /// Lit from the upper left: short lines along curvature that taper to the light, heavy outlines, and the RIDGE
        /// lines of a line set.
        /// </summary>
        Archaeological = 14,
    }
}
