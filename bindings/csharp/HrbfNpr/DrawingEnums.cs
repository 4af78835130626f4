// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>Range of window depth from near to far plane.</summary>
    [NativeConstants("HRBFNPR_DEPTH_")]
    public enum DepthConvention
    {
        /// <summary>Clip space of OpenGL; written depth is 0 to 1 (default).</summary>
        NegativeOneToOne = 0,
        /// <summary>Direct3D, Vulkan, Metal.</summary>
        ZeroToOne = 1,
        /// <summary>1 at the near plane, 0 at the far plane.</summary>
        Reversed = 2,
    }

    /// <summary>What becomes of marks behind nearer surfaces [NPAR 6.1].</summary>
    [NativeConstants("HRBFNPR_HIDDEN_LINES_")]
    public enum HiddenLines
    {
        /// <summary>Seen faintly through the surface in front.</summary>
        Attenuate = 0,
        /// <summary>Not drawn.</summary>
        Hide = 1,
        /// <summary>Drawn as if nothing were in front.</summary>
        Show = 2,
    }

    /// <summary>How it is found what lies in front of a mark; one for all styles of a drawing.</summary>
    [NativeConstants("HRBFNPR_VISIBILITY_")]
    public enum Visibility
    {
        /// <summary>Marks are seen through the depth layers of surface in front of them, whatever their number.</summary>
        DepthLayers = 0,
        /// <summary>As published: discs of paper and of ink, from far to near [NPAR 6.1].</summary>
        Published = 1,
    }

    /// <summary>How the front marks of a layer of strokes are drawn.</summary>
    [NativeConstants("HRBFNPR_SHAPE_")]
    public enum Shape
    {
        /// <summary>Each mark is a dot.</summary>
        Dots = 0,
        /// <summary>Marks that follow each other along a stroke, and are shown, are one line.</summary>
        Strokes = 1,
        /// <summary>Strokes are lines whose width makes the tone, drawn where it is dark enough.</summary>
        Hatch = 2,
    }

    /// <summary>What is drawn of the parts of a line that surface hides.</summary>
    [NativeConstants("HRBFNPR_HIDDEN_PARTS_")]
    public enum HiddenParts
    {
        /// <summary>Nothing (default).</summary>
        None = 0,
        /// <summary>Paler with each layer of surface (two sheets) before them.</summary>
        Attenuated = 1,
        /// <summary>Dashes, the shorter the more layers lie before them.</summary>
        Dashed = 2,
        /// <summary>They are drawn like what is visible.</summary>
        Shown = 3,
    }

    /// <summary>
    /// How a line ends where it ends in the picture without meeting another: at a cusp, where it turns behind its own
    /// surface.
    /// </summary>
    [NativeConstants("HRBFNPR_CAP_")]
    public enum Cap
    {
        /// <summary>Half a disc (default).</summary>
        Round = 0,
        /// <summary>Cut off.</summary>
        Flat = 1,
        /// <summary>Narrowing to a tip twice as long as the line is wide there.</summary>
        Pointed = 2,
    }

    /// <summary>Directions of strokes.</summary>
    [Flags]
    public enum StrokeDirections
    {
        /// <summary>None.</summary>
        None = 0,
        /// <summary>The first direction.</summary>
        First = 1,
        /// <summary>The second direction.</summary>
        Second = 2,
        /// <summary>Both.</summary>
        Both = 3,
    }

    /// <summary>How many marks a tone takes; of <see cref="ToneRule.Share"/>.</summary>
    [NativeConstants("HRBFNPR_TONE_CURVE_")]
    public enum ToneCurve
    {
        /// <summary>As many as cover 1 - tau of the paper, at any zoom and number of marks.</summary>
        Coverage = 0,
        /// <summary>The share 1 - tau [NPAR 6.2].</summary>
        Linear = 1,
    }

    /// <summary>Where the tone of front marks comes from.</summary>
    [NativeConstants("HRBFNPR_TONE_")]
    public enum Tone
    {
        /// <summary>All front marks are shown.</summary>
        None = 0,
        /// <summary>tau = max(0, n . l)^exponent [NPAR 6.2].</summary>
        Light = 1,
        /// <summary><see cref="Style.ToneFunction"/>.</summary>
        Callback = 2,
    }

    /// <summary>How tone, depth, zoom and share are combined.</summary>
    [NativeConstants("HRBFNPR_TONE_RULE_")]
    public enum ToneRule
    {
        /// <summary>All effects thin one and the same order of marks.</summary>
        Share = 0,
        /// <summary>As published, test by test.</summary>
        Published = 1,
    }

    /// <summary>What the light of a style moves with.</summary>
    [NativeConstants("HRBFNPR_LIGHT_")]
    public enum LightSpace
    {
        /// <summary>The world.</summary>
        World = 0,
        /// <summary>The camera.</summary>
        Camera = 1,
    }

    /// <summary>Class of what is nearest at a pixel, and of a vertex.</summary>
    [NativeConstants("HRBFNPR_CLASS_")]
    public enum MarkClass : byte
    {
        /// <summary>Nothing.</summary>
        None = 0,
        /// <summary>A mark that faces the eye.</summary>
        Front = 1,
        /// <summary>A mark that faces away.</summary>
        Back = 2,
        /// <summary>A mark of the contour.</summary>
        Silhouette = 3,
    }

    /// <summary>What the vertices of a drawing are.</summary>
    [NativeConstants("HRBFNPR_PRIMITIVE_")]
    public enum Primitive
    {
        /// <summary>The dots: one vertex each.</summary>
        Points = 1,
        /// <summary>The strokes: one vertex for each of their points.</summary>
        LineStrips = 2,
        /// <summary>The strokes: two vertices for each point, on their left and right side.</summary>
        TriangleStrips = 3,
    }

    /// <summary>What a vertex can carry.</summary>
    [NativeConstants("HRBFNPR_VERTEX_ATTRIBUTE_")]
    public enum VertexAttribute
    {
        /// <summary>World, 3 float.</summary>
        Position = 0,
        /// <summary>Pixel x, pixel y, depth; 3 float.</summary>
        Window = 1,
        /// <summary>Pixels; 1 float.</summary>
        Radius = 2,
        /// <summary>Straight RGBA; 4 byte or 4 float.</summary>
        Color = 3,
        /// <summary>World, unit; 3 float.</summary>
        Normal = 4,
        /// <summary>World, unit; 3 float.</summary>
        Direction = 5,
        /// <summary>1 + running number of the mark; 1 uint.</summary>
        Id = 6,
        /// <summary><see cref="MarkClass"/>; 1 byte or 1 uint.</summary>
        Class = 7,
        /// <summary>1 = a disc of paper, 0 = ink; 1 byte or 1 uint.</summary>
        IsPaper = 8,
        /// <summary>Number of the drawing's layer; 1 uint.</summary>
        Layer = 9,
        /// <summary>Along its stroke, pixels from its first point, 0 for a dot; 1 float.</summary>
        Length = 10,
        /// <summary>Layers of surface before that part of a line, 0 = it is visible; 0 of marks; 1 uint.</summary>
        HiddenLayers = 11,
        /// <summary>
        /// Item of the nearest surface before that part of a line; uint.MaxValue = it is visible, or a mark; 1 uint.
        /// </summary>
        HiddenBy = 12,
        /// <summary>Of lines: a number that a line keeps from one drawing of a renderer to the next, where the camera
        /// moves little; 0 of all else; 1 uint.</summary>
        Line = 13,
    }
}
