// SPDX-License-Identifier: MIT
// Made by bindings/generate from bindings/presets.py; do not edit.
namespace HrbfNpr
{
    /// <summary>Named styles.</summary>
    [NativeConstants("HRBFNPR_PRESET_")]
    public enum Preset
    {
        /// <summary>Stipples, denser where it is darker, without contours.</summary>
        Stipple = 0,
        /// <summary>Lines of one width, denser where it is darker, and contours.</summary>
        Hatch = 1,
        /// <summary>
        /// Up to three sets of lines of one width, at 0, 35 and -30 degrees, each for a darker tone, and contours.
        /// </summary>
        CrossHatch = 2,
        /// <summary>Lines along Stark's combing direction, with a second set in the darks, and contours.</summary>
        Combing = 3,
        /// <summary>Contours only; hidden ones are paler.</summary>
        Silhouette = 4,
        /// <summary>Contours and stipples.</summary>
        ContourAndStipple = 5,
        /// <summary>Contours only; hidden ones are dashed.</summary>
        Xray = 6,
        /// <summary>Stipples, cross hatching in the darks, contours and halos [NPAR, Figure 1 (e)].</summary>
        Full = 7,
        /// <summary>One set of lines that swell with the tone, and contours; lights have a few broken lines.</summary>
        Engraving = 8,
        /// <summary>
        /// Up to three sets of thin lines, at 0, 50 and -40 degrees, each for a darker tone, and contours.
        /// </summary>
        Etching = 9,
        /// <summary>Few wide lines, which close up to black, and heavy contours.</summary>
        Woodcut = 10,
        /// <summary>
        /// Fine stipples lit from the upper left, and outlines that swell in the shade; lights stay empty.
        /// </summary>
        ScientificStipple = 11,
        /// <summary>
        /// Pencil on warm paper: two sets of lines that stray and run past their ends, and contours drawn twice.
        /// </summary>
        Sketch = 12,
        /// <summary>
        /// Pale lines on blue without tone: contours, borders, creases and lines called "crease"; hidden ones are
        /// dashed.
        /// </summary>
        Blueprint = 13,
        /// <summary>
        /// Short lines along the curvature that taper to the light from the upper left, heavy outlines, and the RIDGE
        /// lines of a line set.
        /// </summary>
        Archaeological = 14,
    }
}
