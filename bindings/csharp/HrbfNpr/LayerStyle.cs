// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How layers of marks are drawn.  Lengths in pixels are those of the picture.</summary>
    public sealed unsafe class LayerStyle : NamedStyle
    {
        private Utf8Name[] fields = new Utf8Name[5];

        /// <summary>Creates a style with all defaults, for layers of one kind or of every kind.</summary>
        public LayerStyle(LayerKind kind = LayerKind.Any)
        {
            hrbfnpr_layer_style native;
            Errors.Check(NativeMethods.hrbfnpr_layer_style_init(&native, (uint)sizeof(hrbfnpr_layer_style)));
            Read(&native);
            Kind = kind;
        }

        internal LayerStyle(hrbfnpr_layer_style* native)
        {
            Read(native);
        }

        /// <summary>Kind of the layers that this style is for; default Any.</summary>
        public LayerKind Kind { get; set; }

        /// <summary>Whether front marks are drawn; default true.</summary>
        public bool Shown { get; set; }

        /// <summary>With Visibility.Published, whether marks near a contour draw it; default true.</summary>
        public bool Contours { get; set; }

        /// <summary>The strokes that are drawn, by their direction; default Both.</summary>
        public StrokeDirections Directions { get; set; }

        /// <summary>Shape of front marks; default Dots.</summary>
        public Shape Shape { get; set; }

        /// <summary>
        /// Share of the layer's marks that is used at all; 0 to 1; default 1.  Less makes the layer paler.
        /// </summary>
        public float Share { get; set; }

        /// <summary>
        /// Radius of a mark, and half the width of a stroke, in pixels; above 0, up to 16384; default 1.
        /// </summary>
        public float Radius { get; set; }

        /// <summary>
        /// How the radius follows the zoom; 0 to 1; default 0 = it stays the same in pixels; 1 = it grows with the
        /// zoom.
        /// </summary>
        public float RadiusZoom { get; set; }

        /// <summary>Colour of the ink; default black.</summary>
        public Color Ink { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: darkness, 1 - tau, at which lines begin; 0 to 1; default 0.15.  Larger:
        /// lights are emptier.
        /// </summary>
        public float HatchToneBegin { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: darkness, 1 - tau, from which on lines get no wider; above
        /// <see cref="HatchToneBegin"/>, up to 1; default 0.95.
        /// </summary>
        public float HatchToneEnd { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: share of the paper that lines cover at <see cref="HatchToneBegin"/>,
        /// times <see cref="Share"/>; above 0, up to 1; default 0.1.
        /// </summary>
        public float HatchCoverageBegin { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: share of the paper that lines cover at <see cref="HatchToneEnd"/>, times
        /// <see cref="Share"/>; above 0, up to 1; default 0.82.
        /// </summary>
        public float HatchCoverageEnd { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: least distance from line to line, in pixels; above 0, up to 16384;
        /// default 4.6.  Larger: fewer, wider lines.
        /// </summary>
        public float HatchSpacing { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: least width of a line, in pixels; above 0, up to 16384; default 0.6.
        /// </summary>
        public float HatchPen { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: least width of the paper between lines, in pixels; 0 to 16384; default
        /// 1.2.
        /// </summary>
        public float HatchWhite { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: length over which a line narrows where its tone ends, in pixels; 0 to
        /// 16384; default 20.
        /// </summary>
        public float HatchTaper { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: length below which a piece of a line is not drawn, in pixels; 0 to 16384;
        /// default 10.  Pieces up to twice as long are thinner.
        /// </summary>
        public float HatchShortest { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: how far a line strays to either side, as if drawn by an unsteady hand, in
        /// multiples of <see cref="HatchPen"/>; 0 to 16; default 0.
        /// </summary>
        public float HatchWobble { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: greatest length by which a line runs on past the end of its tone, in
        /// pixels; 0 to 16384; default 0.  Each end has another length.
        /// </summary>
        public float HatchOvershoot { get; set; }

        /// <summary>
        /// Seed of <see cref="HatchWobble"/>, <see cref="HatchOvershoot"/> and <see cref="HatchFade"/>; any number;
        /// default 0.
        /// </summary>
        public uint HatchSeed { get; set; }

        /// <summary>
        /// <see cref="HrbfNpr.Shape.Hatch"/>: range of darkness below <see cref="HatchToneBegin"/> over which lines become
        /// fewer, break and end; 0 to 1; default 0 = all lines end at <see cref="HatchToneBegin"/>.
        /// </summary>
        public float HatchFade { get; set; }

        /// <summary>
        /// Name of the scalar field of the point set by which the share of marks that is shown is multiplied; default
        /// null = none.
        /// </summary>
        public string DensityField
        {
            get { return fields[0].Text; }
            set { fields[0] = new Utf8Name(value); }
        }

        /// <summary>Name of the scalar field that is the tone, or scales it; default null = none.</summary>
        public string ToneField
        {
            get { return fields[1].Text; }
            set { fields[1] = new Utf8Name(value); }
        }

        /// <summary>
        /// Name of the scalar field by which radii of dots and widths of lines are multiplied; default null = none.
        /// </summary>
        public string WidthField
        {
            get { return fields[2].Text; }
            set { fields[2] = new Utf8Name(value); }
        }

        /// <summary>
        /// Name of the field of colours for which marks take inks of <see cref="Style.Palette"/>; default null = none.
        /// </summary>
        public string InkField
        {
            get { return fields[3].Text; }
            set { fields[3] = new Utf8Name(value); }
        }

        /// <summary>
        /// Name of the scalar field that leaves marks out where it is below 0.5; default null = none.
        /// </summary>
        public string MaskField
        {
            get { return fields[4].Text; }
            set { fields[4] = new Utf8Name(value); }
        }

        /// <summary>What <see cref="ToneField"/> does to the tone; default Replace.</summary>
        public FieldRule ToneFieldRule { get; set; }

        /// <summary>Which inks the marks of an <see cref="InkField"/> take; default Nearest.</summary>
        public PaletteRule PaletteRule { get; set; }

        /// <summary>The names of the fields as UTF-8, in the order of the properties.</summary>
        internal Utf8Name[] Fields
        {
            get { return fields; }
        }

        /// <summary>Copies the style.</summary>
        public LayerStyle Clone()
        {
            var copy = (LayerStyle)MemberwiseClone();
            copy.fields = (Utf8Name[])fields.Clone();
            return copy;
        }

        /// <summary>Writes everything except the names.</summary>
        internal void Write(hrbfnpr_layer_style* native)
        {
            Errors.Check(NativeMethods.hrbfnpr_layer_style_init(native, (uint)sizeof(hrbfnpr_layer_style)));
            native->kind = (uint)Kind;
            native->shown = Shown ? 1u : 0;
            native->contours = Contours ? 1u : 0;
            native->directions = (uint)Directions;
            native->shape = (uint)Shape;
            native->share = Share;
            native->radius = Radius;
            native->radius_zoom = RadiusZoom;
            Ink.Write(native->ink);
            native->hatch_tone_begin = HatchToneBegin;
            native->hatch_tone_end = HatchToneEnd;
            native->hatch_coverage_begin = HatchCoverageBegin;
            native->hatch_coverage_end = HatchCoverageEnd;
            native->hatch_spacing = HatchSpacing;
            native->hatch_pen = HatchPen;
            native->hatch_white = HatchWhite;
            native->hatch_taper = HatchTaper;
            native->hatch_shortest = HatchShortest;
            native->hatch_wobble = HatchWobble;
            native->hatch_overshoot = HatchOvershoot;
            native->hatch_seed = HatchSeed;
            native->hatch_fade = HatchFade;
            native->tone_field_rule = (uint)ToneFieldRule;
            native->palette_rule = (uint)PaletteRule;
        }

        private void Read(hrbfnpr_layer_style* native)
        {
            Kind = (LayerKind)native->kind;
            ReadName(native->name);
            Shown = native->shown != 0;
            Contours = native->contours != 0;
            Directions = (StrokeDirections)native->directions;
            Shape = (Shape)native->shape;
            Share = native->share;
            Radius = native->radius;
            RadiusZoom = native->radius_zoom;
            Ink = Color.Read(native->ink);
            HatchToneBegin = native->hatch_tone_begin;
            HatchToneEnd = native->hatch_tone_end;
            HatchCoverageBegin = native->hatch_coverage_begin;
            HatchCoverageEnd = native->hatch_coverage_end;
            HatchSpacing = native->hatch_spacing;
            HatchPen = native->hatch_pen;
            HatchWhite = native->hatch_white;
            HatchTaper = native->hatch_taper;
            HatchShortest = native->hatch_shortest;
            HatchWobble = native->hatch_wobble;
            HatchOvershoot = native->hatch_overshoot;
            HatchSeed = native->hatch_seed;
            HatchFade = native->hatch_fade;
            ToneFieldRule = (FieldRule)native->tone_field_rule;
            PaletteRule = (PaletteRule)native->palette_rule;
            DensityField = Utf8Name.Read(native->density_field);
            ToneField = Utf8Name.Read(native->tone_field);
            WidthField = Utf8Name.Read(native->width_field);
            InkField = Utf8Name.Read(native->ink_field);
            MaskField = Utf8Name.Read(native->mask_field);
        }
    }
}
