// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>What a page is written as.</summary>
    [NativeConstants("HRBFNPR_PAGE_FORMAT_")]
    public enum PageFormat
    {
        /// <summary>SVG 1.1; groups are layers of Inkscape (default).</summary>
        Svg = 0,
        /// <summary>PDF 1.5; groups are optional content, which viewers list as layers.</summary>
        Pdf = 1,
        /// <summary>For plotters: absolute, 40 units a millimetre, y up from the lower left corner.</summary>
        Hpgl = 2,
        /// <summary>For plotters: G0 and G1, millimetres, y up from the lower left corner.</summary>
        Gcode = 3,
    }

    /// <summary>How strokes are written whose width varies.</summary>
    [NativeConstants("HRBFNPR_WIDTHS_")]
    public enum Widths
    {
        /// <summary>Filled outlines; SVG and PDF (default).</summary>
        Outlines = 0,
        /// <summary>Lines of even widths, <see cref="PageOptions.WidthStep"/> apart.</summary>
        Classes = 1,
    }

    /// <summary>How dots are written.</summary>
    [NativeConstants("HRBFNPR_DOT_SHAPE_")]
    public enum DotShape
    {
        /// <summary>Circles; plotters fill them, or draw round them in a single pass (default).</summary>
        Circles = 0,
        /// <summary>Lines of no length with round ends; plotters touch the paper.</summary>
        Lines = 1,
        /// <summary>Spirals that a pen fills the disc with, if it is wider than the pen.</summary>
        Spirals = 2,
    }

    /// <summary>
    /// Kinds of lines by the numbers of ISO 128-2.  In line widths a dot is 0.5, the three kinds of dashes 6, 12 and
    /// 24, a gap 3, a space 18; a little more or less, so that lines begin and end with a dash.
    /// </summary>
    [NativeConstants("HRBFNPR_LINE_TYPE_")]
    public enum LineType
    {
        /// <summary>As the drawing has them.</summary>
        AsDrawn = 0,
        /// <summary>Without gaps.</summary>
        Continuous = 1,
        /// <summary>For hidden edges.</summary>
        Dashed = 2,
        /// <summary>Dashes with a space between them.</summary>
        DashedSpaced = 3,
        /// <summary>For axes.</summary>
        LongDashedDotted = 4,
        /// <summary>A long dash and two dots.</summary>
        LongDashedDoubleDotted = 5,
        /// <summary>A long dash and three dots.</summary>
        LongDashedTripleDotted = 6,
        /// <summary>Dots alone.</summary>
        Dotted = 7,
        /// <summary>A long dash and a short one.</summary>
        LongDashedShortDashed = 8,
        /// <summary>A long dash and two short ones.</summary>
        LongDashedDoubleShortDashed = 9,
        /// <summary>A dash and a dot.</summary>
        DashedDotted = 10,
        /// <summary>Two dashes and a dot.</summary>
        DoubleDashedDotted = 11,
        /// <summary>A dash and two dots.</summary>
        DashedDoubleDotted = 12,
        /// <summary>Two dashes and two dots.</summary>
        DoubleDashedDoubleDotted = 13,
        /// <summary>A dash and three dots.</summary>
        DashedTripleDotted = 14,
        /// <summary>Two dashes and three dots.</summary>
        DoubleDashedTripleDotted = 15,
    }
}
