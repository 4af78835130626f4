// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>The format of a file.</summary>
    [NativeConstants("HRBFNPR_PAGE_FORMAT_")]
    public enum PageFormat
    {
        /// <summary>SVG 1.1, with groups as layers of Inkscape (default).</summary>
        Svg = 0,
        /// <summary>PDF 1.5, with groups as optional content, which viewers list as layers.</summary>
        Pdf = 1,
        /// <summary>
        /// HPGL for plotters: absolute coordinates, 40 units per mm, y up from the lower left corner.
        /// </summary>
        Hpgl = 2,
        /// <summary>G-code for plotters: G0 to G3 in mm, y up from the lower left corner.</summary>
        Gcode = 3,
        /// <summary>
        /// DXF of AutoCAD 2004 in mm, y up from the lower left corner, with groups as layers.  There is no paper.
        /// Strokes of varying width become polylines with a width at each point, and dots become circles.
        /// </summary>
        Dxf = 4,
    }

    /// <summary>How strokes are written whose width varies.</summary>
    [NativeConstants("HRBFNPR_WIDTHS_")]
    public enum Widths
    {
        /// <summary>Filled outlines, in SVG and PDF (default).</summary>
        Outlines = 0,
        /// <summary>Lines of even widths, whose ratios are powers of <see cref="PageOptions.WidthStep"/>.</summary>
        Classes = 1,
    }

    /// <summary>How dots are written.</summary>
    [NativeConstants("HRBFNPR_DOT_SHAPE_")]
    public enum DotShape
    {
        /// <summary>
        /// Circles (default).  Plotters fill them, or with <see cref="PageOptions.SinglePass"/> draw their outline.
        /// </summary>
        Circles = 0,
        /// <summary>Lines of length 0 with round ends, at which a plotter touches the paper.</summary>
        Lines = 1,
        /// <summary>Spirals with which a pen fills the dot, if the dot is wider than the pen.</summary>
        Spirals = 2,
    }

    /// <summary>How the curves of lines of one width are written.  Hpgl has straight lines only.</summary>
    [NativeConstants("HRBFNPR_CURVES_")]
    public enum Curves
    {
        /// <summary>
        /// Arcs of circles where lines consist of them, else splines (default).  Gcode has arcs and straight lines
        /// only, and Pdf has no arcs.
        /// </summary>
        Arcs = 0,
        /// <summary>Cubic Bezier curves: SPLINE in Dxf, G5 in Gcode.</summary>
        Splines = 1,
        /// <summary>Straight lines, for programs and machines that have neither arcs nor splines.</summary>
        Lines = 2,
    }

    /// <summary>Types of lines, by the numbers of ISO 128-2.</summary>
    /// <remarks>
    /// Lengths in line widths: a dot is 0.5, dashes of the three kinds are 6, 12 and 24, a gap is 3, a space is 18.
    /// They are stretched a little, so that each line begins and ends with a dash.
    /// </remarks>
    [NativeConstants("HRBFNPR_LINE_TYPE_")]
    public enum LineType
    {
        /// <summary>Lines as the drawing has them.</summary>
        AsDrawn = 0,
        /// <summary>A continuous line.</summary>
        Continuous = 1,
        /// <summary>Dashes, for hidden edges.</summary>
        Dashed = 2,
        /// <summary>Dashes with spaces between.</summary>
        DashedSpaced = 3,
        /// <summary>A long dash, then a dot; for axes.</summary>
        LongDashedDotted = 4,
        /// <summary>A long dash, then two dots.</summary>
        LongDashedDoubleDotted = 5,
        /// <summary>A long dash, then three dots.</summary>
        LongDashedTripleDotted = 6,
        /// <summary>Dots.</summary>
        Dotted = 7,
        /// <summary>A long dash, then a short dash.</summary>
        LongDashedShortDashed = 8,
        /// <summary>A long dash, then two short dashes.</summary>
        LongDashedDoubleShortDashed = 9,
        /// <summary>A dash, then a dot.</summary>
        DashedDotted = 10,
        /// <summary>Two dashes, then a dot.</summary>
        DoubleDashedDotted = 11,
        /// <summary>A dash, then two dots.</summary>
        DashedDoubleDotted = 12,
        /// <summary>Two dashes, then two dots.</summary>
        DoubleDashedDoubleDotted = 13,
        /// <summary>A dash, then three dots.</summary>
        DashedTripleDotted = 14,
        /// <summary>Two dashes, then three dots.</summary>
        DoubleDashedTripleDotted = 15,
    }
}
