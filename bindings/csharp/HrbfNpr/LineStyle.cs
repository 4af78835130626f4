// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// How the lines of one kind are drawn, for items that have a line set.  Lengths are in pixels unless a property
    /// says otherwise.
    /// </summary>
    /// <remarks><c>Renderer.Draw</c> refuses numbers out of range.</remarks>
    public sealed unsafe class LineStyle : NamedStyle
    {
        /// <summary>Creates a style with all defaults, for lines of one kind.</summary>
        public LineStyle(LineKind kind = LineKind.Contour)
        {
            hrbfnpr_line_style native;
            Errors.Check(NativeMethods.hrbfnpr_line_style_init(&native, (uint)sizeof(hrbfnpr_line_style)));
            Read(&native);
            Kind = kind;
        }

        internal LineStyle(hrbfnpr_line_style* native)
        {
            Read(native);
        }

        /// <summary>Kind of lines that this style is for; default Contour.</summary>
        public LineKind Kind { get; set; }

        /// <summary>How hidden parts are drawn; default None.</summary>
        public HiddenParts Hidden { get; set; }

        /// <summary>Shape of free ends; default Round.</summary>
        public Cap Cap { get; set; }

        /// <summary>Width of a line, in pixels; above 0, up to 16384; default 2.</summary>
        public float Width { get; set; }

        /// <summary>
        /// Length over which a line narrows to a free end, as half an ellipse, in pixels; 0 to 16384; default 12; 0 =
        /// it does not narrow.  A part with a free end that is shorter than two tapers is thinner the shorter it is.
        /// </summary>
        public float Taper { get; set; }

        /// <summary>Width of Attenuated and Dashed parts, in pixels; above 0, up to 16384; default 1.2.</summary>
        public float HiddenWidth { get; set; }

        /// <summary>
        /// Factor of the opacity of Attenuated parts for each layer of surface in front; 0 to 1; default 0.35.
        /// </summary>
        public float HiddenOpacity { get; set; }

        /// <summary>Length of a dash of Dashed parts, in hidden widths; above 0, up to 16384; default 5.</summary>
        public float Dash { get; set; }

        /// <summary>Length of a gap between dashes, in hidden widths; above 0, up to 16384; default 3.</summary>
        public float Gap { get; set; }

        /// <summary>
        /// Length below which parts with a free end, and hidden parts, are not drawn, in pixels; 0 to 16384; default 2.
        /// </summary>
        public float Shortest { get; set; }

        /// <summary>
        /// How much paler a line is where its strength is <see cref="Lower"/> than where it is <see cref="Upper"/>; 0
        /// to 1; default 1; 0 = it does not fade.
        /// </summary>
        public float Fade { get; set; }

        /// <summary>
        /// Least strength at which a line goes on; 0 or more; default 0.  If it and <see cref="Upper"/> are 0, it is 10
        /// for suggestive contours, 12 for apparent ridges, 15 degrees for creases, and 0 for other kinds.
        /// </summary>
        public double Lower { get; set; }

        /// <summary>
        /// Strength that a line must reach somewhere to be drawn; 0 or more; default 0.  If it and <see cref="Lower"/>
        /// are 0, it is 30 for suggestive contours, 25 for apparent ridges, 30 degrees for creases, and 0 for other
        /// kinds.
        /// </summary>
        public double Upper { get; set; }

        /// <summary>
        /// Values of n . l at which an isophote lies; -1 to 1; default null.  Isophotes need at least one.
        /// </summary>
        public double[] Levels { get; set; }

        /// <summary>Colour of the ink; default black.</summary>
        public Color Ink { get; set; }

        /// <summary>
        /// Factor of the width of contours and borders where nothing lies beside the line on its outer side: on the
        /// outline of all items that have lines; 0 to 16; default 1.
        /// </summary>
        public float OutlineFactor { get; set; }

        /// <summary>
        /// Factor of the width at the farthest place of the surfaces in the viewport; 0 to 16; default 1.  It is 1 at the
        /// nearest place, and changes evenly with depth.
        /// </summary>
        public float FarFactor { get; set; }

        /// <summary>
        /// Factor of the width where the surface faces the style's light; 0 to 16; default 1.  It is 1 where the
        /// surface faces away, and changes evenly with n . l.
        /// </summary>
        public float LitFactor { get; set; }

        /// <summary>
        /// Factor of the width where the surface bends sharply; 0 to 16; default 1.  It is 1 where the radius of
        /// curvature is <see cref="CurvatureRadius"/> or more.
        /// </summary>
        /// <remarks>
        /// For contours it is the radial curvature, along the line of sight; for other kinds it is the normal curvature
        /// across the line.
        /// </remarks>
        public float CurvatureFactor { get; set; }

        /// <summary>
        /// Radius of curvature from which on <see cref="CurvatureFactor"/> has no effect, in diagonals; above 0;
        /// default 0.1.
        /// </summary>
        public float CurvatureRadius { get; set; }

        /// <summary>
        /// How far a line strays to either side, as if drawn by an unsteady hand, in widths; 0 to 16; default 0.
        /// </summary>
        public float Wobble { get; set; }

        /// <summary>Share by which the width of a line varies; 0 to 1; default 0.</summary>
        public float WobbleWidth { get; set; }

        /// <summary>Approximate length from swing to swing, in widths; 1 to 16384; default 40.</summary>
        public float WobbleLength { get; set; }

        /// <summary>Seed of the wobble; any number; default 0.</summary>
        public uint WobbleSeed { get; set; }

        /// <summary>The creases that are drawn, for lines of kind Crease; default All.</summary>
        public Creases Creases { get; set; }

        /// <summary>Copies the style.</summary>
        public LineStyle Clone()
        {
            var copy = (LineStyle)MemberwiseClone();
            copy.Levels = Levels == null ? null : (double[])Levels.Clone();
            return copy;
        }

        /// <summary>Writes everything except the name and the levels.</summary>
        internal void Write(hrbfnpr_line_style* native)
        {
            Errors.Check(NativeMethods.hrbfnpr_line_style_init(native, (uint)sizeof(hrbfnpr_line_style)));
            native->kind = (uint)Kind;
            native->hidden = (uint)Hidden;
            native->cap = (uint)Cap;
            native->width = Width;
            native->taper = Taper;
            native->hidden_width = HiddenWidth;
            native->hidden_opacity = HiddenOpacity;
            native->dash = Dash;
            native->gap = Gap;
            native->shortest = Shortest;
            native->fade = Fade;
            native->lower = Lower;
            native->upper = Upper;
            Ink.Write(native->ink);
            native->outline_factor = OutlineFactor;
            native->far_factor = FarFactor;
            native->lit_factor = LitFactor;
            native->curvature_factor = CurvatureFactor;
            native->curvature_radius = CurvatureRadius;
            native->wobble = Wobble;
            native->wobble_width = WobbleWidth;
            native->wobble_length = WobbleLength;
            native->wobble_seed = WobbleSeed;
            native->creases = (uint)Creases;
        }

        private void Read(hrbfnpr_line_style* native)
        {
            Kind = (LineKind)native->kind;
            ReadName(native->name);
            Hidden = (HiddenParts)native->hidden;
            Cap = (Cap)native->cap;
            Width = native->width;
            Taper = native->taper;
            HiddenWidth = native->hidden_width;
            HiddenOpacity = native->hidden_opacity;
            Dash = native->dash;
            Gap = native->gap;
            Shortest = native->shortest;
            Fade = native->fade;
            Lower = native->lower;
            Upper = native->upper;
            if (native->levels.count > 0)
            {
                Levels = new double[native->levels.count];
                Marshal.Copy(native->levels.data, Levels, 0, Levels.Length);
            }
            Ink = Color.Read(native->ink);
            OutlineFactor = native->outline_factor;
            FarFactor = native->far_factor;
            LitFactor = native->lit_factor;
            CurvatureFactor = native->curvature_factor;
            CurvatureRadius = native->curvature_radius;
            Wobble = native->wobble;
            WobbleWidth = native->wobble_width;
            WobbleLength = native->wobble_length;
            WobbleSeed = native->wobble_seed;
            Creases = (Creases)native->creases;
        }
    }
}
