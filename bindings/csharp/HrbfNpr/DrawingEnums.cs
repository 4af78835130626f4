// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>How depth runs from the near plane to the far plane.</summary>
    [NativeConstants("HRBFNPR_DEPTH_")]
    public enum DepthConvention
    {
        /// <summary>Clip depth from -1 to 1, as in OpenGL; window depth from 0 to 1 (default).</summary>
        NegativeOneToOne = 0,
        /// <summary>Clip and window depth from 0 to 1, as in Direct3D, Vulkan and Metal.</summary>
        ZeroToOne = 1,
        /// <summary>Clip and window depth from 1 at the near plane to 0 at the far plane.</summary>
        Reversed = 2,
    }

    /// <summary>How ink is drawn that lies behind a depth layer of surface [NPAR 6.1].</summary>
    [NativeConstants("HRBFNPR_HIDDEN_LINES_")]
    public enum HiddenLines
    {
        /// <summary>Ink is seen faintly through the surface in front of it (default).</summary>
        Attenuate = 0,
        /// <summary>Ink behind a nearer depth layer is not drawn.</summary>
        Hide = 1,
        /// <summary>Ink is drawn as if nothing were in front of it.</summary>
        Show = 2,
    }

    /// <summary>How the marks that a surface hides are found.  It is the same in all styles of a drawing.</summary>
    [NativeConstants("HRBFNPR_VISIBILITY_")]
    public enum Visibility
    {
        /// <summary>
        /// The ink of each mark is multiplied by the transmittance of the depth layers in front of it, whatever the
        /// number of marks (default).
        /// </summary>
        DepthLayers = 0,
        /// <summary>Marks paint discs of paper and of ink from far to near, as published [NPAR 6.1].</summary>
        Published = 1,
    }

    /// <summary>
    /// How the front marks of a layer of strokes are drawn.  Layers without strokes are always dots, and so is
    /// everything with Visibility.Published.
    /// </summary>
    [NativeConstants("HRBFNPR_SHAPE_")]
    public enum Shape
    {
        /// <summary>Each mark is a dot (default).</summary>
        Dots = 0,
        /// <summary>Consecutive marks of a stroke that are shown form one line.</summary>
        Strokes = 1,
        /// <summary>
        /// Strokes are lines that are drawn where the tone is dark enough, and whose width makes the tone.
        /// </summary>
        Hatch = 2,
    }

    /// <summary>How the parts of a line that surface hides are drawn.</summary>
    [NativeConstants("HRBFNPR_HIDDEN_PARTS_")]
    public enum HiddenParts
    {
        /// <summary>Hidden parts are not drawn (default).</summary>
        None = 0,
        /// <summary>Hidden parts get paler with each layer of surface (two sheets) in front of them.</summary>
        Attenuated = 1,
        /// <summary>Hidden parts are dashed; the more layers lie in front, the shorter the dashes.</summary>
        Dashed = 2,
        /// <summary>Hidden parts are drawn like visible ones.</summary>
        Shown = 3,
    }

    /// <summary>
    /// The shape of a free end of a line: one that meets no other line in the picture, such as a cusp, where a contour
    /// turns behind its own surface.
    /// </summary>
    [NativeConstants("HRBFNPR_CAP_")]
    public enum Cap
    {
        /// <summary>Half a disc beyond the end (default).</summary>
        Round = 0,
        /// <summary>Cut off straight at the end.</summary>
        Flat = 1,
        /// <summary>A tip, twice as long as the line is wide there.</summary>
        Pointed = 2,
    }

    /// <summary>Which strokes of a layer are drawn, by their direction.</summary>
    [Flags]
    public enum StrokeDirections
    {
        /// <summary>No strokes.</summary>
        None = 0,
        /// <summary>Strokes of the first direction.</summary>
        First = 1,
        /// <summary>Strokes of the second direction.</summary>
        Second = 2,
        /// <summary>Strokes of both directions (default).</summary>
        Both = 3,
    }

    /// <summary>How many marks a tone shows, with <see cref="ToneRule.Share"/>.</summary>
    [NativeConstants("HRBFNPR_TONE_CURVE_")]
    public enum ToneCurve
    {
        /// <summary>
        /// Enough marks to cover the share 1 - tau of the paper, at any zoom and for any number of marks (default).
        /// </summary>
        Coverage = 0,
        /// <summary>The share 1 - tau of the marks [NPAR 6.2].</summary>
        Linear = 1,
    }

    /// <summary>
    /// Where stipples are evenly spread, with <see cref="ToneRule.Share"/>, <see cref="ToneCurve.Coverage"/> and
    /// <see cref="Visibility.DepthLayers"/>.
    /// </summary>
    [NativeConstants("HRBFNPR_EVENNESS_")]
    public enum Evenness
    {
        /// <summary>
        /// In the picture (default). Where the surface turns away, marks get smaller as far as an earlier mark is too
        /// near in the picture. They change smoothly as the camera moves.
        /// </summary>
        Picture = 0,
        /// <summary>On the surface: the first marks of the order are shown.</summary>
        Surface = 1,
    }

    /// <summary>The source of the tone tau of front marks: 1 = light, 0 = dark.</summary>
    [NativeConstants("HRBFNPR_TONE_")]
    public enum Tone
    {
        /// <summary>tau = 0: all front marks are shown.</summary>
        None = 0,
        /// <summary>
        /// tau = max(0, n . l)^exponent [NPAR 6.2], and <see cref="Style.FillLight"/> on the unlit side (default).
        /// </summary>
        Light = 1,
        /// <summary>The result of <see cref="Style.ToneFunction"/>.</summary>
        Callback = 2,
    }

    /// <summary>How tone, distance, zoom and share together decide which front marks are shown.</summary>
    [NativeConstants("HRBFNPR_TONE_RULE_")]
    public enum ToneRule
    {
        /// <summary>All effects thin the same order of marks (default).</summary>
        Share = 0,
        /// <summary>A mark must pass each test separately, as published [NPAR 6.2].</summary>
        Published = 1,
    }

    /// <summary>What <see cref="LayerStyle.ToneField"/> does to the tone.</summary>
    [NativeConstants("HRBFNPR_FIELD_RULE_")]
    public enum FieldRule
    {
        /// <summary>The tone becomes the value (default).</summary>
        Replace = 0,
        /// <summary>The tone is multiplied by the value.</summary>
        Scale = 1,
    }

    /// <summary>Which inks of a palette marks take.</summary>
    [NativeConstants("HRBFNPR_PALETTE_")]
    public enum PaletteRule
    {
        /// <summary>Each mark takes the ink that is nearest to its colour (default).</summary>
        Nearest = 0,
        /// <summary>Neighbouring marks take the two or three inks whose mean is the colour.</summary>
        Mixed = 1,
    }

    /// <summary>Where a light comes from.</summary>
    [NativeConstants("HRBFNPR_LIGHT_KIND_")]
    public enum LightKind
    {
        /// <summary>From far away, everywhere from the same direction (default).</summary>
        Directional = 0,
        /// <summary>From a place.  The strength of the light does not fall with the distance.</summary>
        Place = 1,
    }

    /// <summary>The space in which the direction to a light, or its place, is given.</summary>
    [NativeConstants("HRBFNPR_LIGHT_")]
    public enum LightSpace
    {
        /// <summary>World space: the light stays where it is when the camera moves.</summary>
        World = 0,
        /// <summary>Eye space: the light moves with the camera (default).</summary>
        Camera = 1,
        /// <summary>Object space: the light moves with the item.</summary>
        Item = 2,
    }

    /// <summary>How a mark faces the camera [NPAR 6].</summary>
    [NativeConstants("HRBFNPR_CLASS_")]
    public enum MarkClass : byte
    {
        /// <summary>No mark, or a mark that is not drawn.</summary>
        None = 0,
        /// <summary>A mark whose normal points towards the eye.</summary>
        Front = 1,
        /// <summary>A mark whose normal points away from the eye.</summary>
        Back = 2,
        /// <summary>A mark near a contour, with Visibility.Published.</summary>
        Silhouette = 3,
    }

    /// <summary>What vertices of a drawing are written for.</summary>
    [NativeConstants("HRBFNPR_PRIMITIVE_")]
    public enum Primitive
    {
        /// <summary>Dots, with one vertex each.</summary>
        Points = 1,
        /// <summary>Strokes, with one vertex for each of their points.</summary>
        LineStrips = 2,
        /// <summary>Strokes, with two vertices for each point, on its left and right side.</summary>
        TriangleStrips = 3,
    }

    /// <summary>What a vertex can carry, and the types it can have.</summary>
    [NativeConstants("HRBFNPR_VERTEX_ATTRIBUTE_")]
    public enum VertexAttribute
    {
        /// <summary>World position; 3 float.</summary>
        Position = 0,
        /// <summary>Pixel x, pixel y and depth; 3 float.</summary>
        Window = 1,
        /// <summary>Radius of a dot or half the width of a stroke, in pixels; 1 float.</summary>
        Radius = 2,
        /// <summary>Colour, straight RGBA; 4 byte or 4 float.</summary>
        Color = 3,
        /// <summary>Unit normal in the world, 0 for lines; 3 float.</summary>
        Normal = 4,
        /// <summary>Unit direction in the world, 0 for lines; 3 float.</summary>
        Direction = 5,
        /// <summary>Id of the mark, which is 1 + its number over all items and layers, 0 for lines; 1 uint.</summary>
        Id = 6,
        /// <summary>Class of the mark (<see cref="MarkClass"/>); 1 byte or 1 uint.</summary>
        Class = 7,
        /// <summary>1 = a disc of paper, 0 = ink; 1 byte or 1 uint.</summary>
        IsPaper = 8,
        /// <summary>Number of the layer in the drawing; 1 uint.</summary>
        Layer = 9,
        /// <summary>Length along the stroke from its first point, in pixels, 0 for a dot; 1 float.</summary>
        Length = 10,
        /// <summary>
        /// Number of layers of surface in front of this part of a line, 0 if it is visible or a mark; 1 uint.
        /// </summary>
        HiddenLayers = 11,
        /// <summary>
        /// Number of the item whose surface is nearest in front of this part of a line, uint.MaxValue if it is visible
        /// or a mark; 1 uint.
        /// </summary>
        HiddenBy = 12,
        /// <summary>
        /// Number of the line, 0 for all else; 1 uint.  A line keeps its number from one drawing of a renderer to the
        /// next where the camera moves little.
        /// </summary>
        Line = 13,
    }
}
