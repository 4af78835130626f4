// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>How the lines of one kind are drawn, of items that have a line set.  Lengths are in pixels.</summary>
    /// <remarks>Numbers out of range are refused by <c>Renderer.Draw</c>.</remarks>
    public sealed unsafe class LineStyle : NamedStyle
    {
        /// <summary>With all defaults: for lines of one kind.</summary>
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

        /// <summary>The lines that this is for.</summary>
        public LineKind Kind { get; set; }

        /// <summary>What is drawn of parts that surface hides; None.</summary>
        public HiddenParts Hidden { get; set; }

        /// <summary>How free ends look; Round.</summary>
        public Cap Cap { get; set; }

        /// <summary>Pixels, above 0; 2.</summary>
        public float Width { get; set; }

        /// <summary>
        /// Pixels, 0 or more, over which a line narrows to a free end, half an ellipse; 0 = not at all; 12. A part with a
        /// free end that is shorter than two tapers is the thinner, the shorter it is.
        /// </summary>
        public float Taper { get; set; }

        /// <summary>Of hidden parts that are Attenuated or Dashed: pixels, above 0; 1.2.</summary>
        public float HiddenWidth { get; set; }

        /// <summary>Of hidden parts that are Attenuated: 0 to 1, for each layer of surface; 0.35.</summary>
        public float HiddenOpacity { get; set; }

        /// <summary>Of hidden parts that are Dashed: length of a dash in hidden widths, above 0; 5.</summary>
        public float Dash { get; set; }

        /// <summary>Between dashes, in hidden widths, above 0; 3.</summary>
        public float Gap { get; set; }

        /// <summary>Parts with a free end, and hidden ones, that are shorter are not drawn; pixels, 0 or more; 2.</summary>
        public float Shortest { get; set; }

        /// <summary>
        /// 0 to 1: how much paler a line is where its strength is <see cref="Lower"/> than where it is
        /// <see cref="Upper"/>; 1.
        /// </summary>
        public float Fade { get; set; }

        /// <summary>Lines go on while their strength, of no unit, is at least this, 0 or more ...</summary>
        public double Lower { get; set; }

        /// <summary>
        /// ... and are drawn if it is this somewhere.  0 and 0 = those of the kind: 10 and 30 of suggestive contours,
        /// 12 and 25 of apparent ridges, 15 and 30 (degrees) of creases; 0 and 0.
        /// </summary>
        public double Upper { get; set; }

        /// <summary>Of isophotes, and needed there: n . l, numbers from -1 to 1; null.</summary>
        public double[] Levels { get; set; }

        /// <summary>Colour of the lines; black.</summary>
        public Color Ink { get; set; }

        /// <summary>
        /// Of the width of contours and borders where nothing lies beside them, the outline of the drawing: 0 to 16; 1.
        /// </summary>
        public float OutlineFactor { get; set; }

        /// <summary>
        /// Of the width at the farthest place of all lines in the viewport, 1 at the nearest: 0 to 16; 1.
        /// </summary>
        public float FarFactor { get; set; }

        /// <summary>
        /// Of the width where the surface faces the style's light, 1 where it faces away: 0 to 16; 1.
        /// </summary>
        public float LitFactor { get; set; }

        /// <summary>
        /// Of the width where the surface bends sharply, of contours along the line of sight, of others across the
        /// line: 0 to 16; 1.
        /// </summary>
        public float CurvatureFactor { get; set; }

        /// <summary>
        /// Diagonals, above 0: the radius of curvature from which on <see cref="CurvatureFactor"/> has no effect; 0.1.
        /// </summary>
        public float CurvatureRadius { get; set; }

        /// <summary>How far an unsteady hand may stray to either side, in widths: 0 to 16; 0.</summary>
        public float Wobble { get; set; }

        /// <summary>0 to 1: the share by which its width may vary; 0.</summary>
        public float WobbleWidth { get; set; }

        /// <summary>From swing to swing, about, in widths, 1 or more; 40.</summary>
        public float WobbleLength { get; set; }

        /// <summary>Which of many wobbles; 0.</summary>
        public uint WobbleSeed { get; set; }

        /// <summary>Of creases: which of them; All.</summary>
        public Creases Creases { get; set; }

        /// <summary>Another one like this.</summary>
        public LineStyle Clone()
        {
            var copy = (LineStyle)MemberwiseClone();
            copy.Levels = Levels == null ? null : (double[])Levels.Clone();
            return copy;
        }

        /// <summary>Everything but the name and the levels.</summary>
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
