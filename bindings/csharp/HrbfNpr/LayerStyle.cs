// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How layers of marks are drawn.</summary>
    public sealed unsafe class LayerStyle : NamedStyle
    {
        /// <summary>With all defaults: for layers of one kind, or of every kind.</summary>
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

        /// <summary>The layers that this is for.</summary>
        public LayerKind Kind { get; set; }

        /// <summary>Whether front marks are drawn.</summary>
        public bool Shown { get; set; }

        /// <summary>Whether marks near a contour draw it.</summary>
        public bool Contours { get; set; }

        /// <summary>The directions of strokes that are drawn.</summary>
        public StrokeDirections Directions { get; set; }

        /// <summary>Whether strokes are drawn as dots or as lines.</summary>
        public Shape Shape { get; set; }

        /// <summary>Share of the layer's marks that is used at all, 0 to 1.</summary>
        public float Share { get; set; }

        /// <summary>Of a mark, half the width of a stroke; pixels, above 0.</summary>
        public float Radius { get; set; }

        /// <summary>0: the radius is in pixels at any zoom; 1: it grows with the zoom; or between.</summary>
        public float RadiusZoom { get; set; }

        /// <summary>Colour of the marks.</summary>
        public Color Ink { get; set; }

        /// <summary>Of <see cref="Shape.Hatch"/>: darkness from which on there are lines, 0 to 1; 0.15.</summary>
        public float HatchToneBegin { get; set; }

        /// <summary>
        /// Darkness from which on they get no wider, above <see cref="HatchToneBegin"/>, to 1; 0.95.
        /// </summary>
        public float HatchToneEnd { get; set; }

        /// <summary>Share of the paper covered at <see cref="HatchToneBegin"/>, above 0, to 1; 0.1.</summary>
        public float HatchCoverageBegin { get; set; }

        /// <summary>Share of the paper covered at <see cref="HatchToneEnd"/>, above 0, to 1; 0.82.</summary>
        public float HatchCoverageEnd { get; set; }

        /// <summary>Least from line to line; pixels, above 0; 4.6.</summary>
        public float HatchSpacing { get; set; }

        /// <summary>Least width of a line; pixels, above 0; 0.6.</summary>
        public float HatchPen { get; set; }

        /// <summary>Left between lines at least; pixels, 0 or more; 1.2.</summary>
        public float HatchWhite { get; set; }

        /// <summary>Over which a line narrows where it ends by its tone; pixels, 0 or more; 20.</summary>
        public float HatchTaper { get; set; }

        /// <summary>
        /// Shorter pieces are not drawn, those up to twice as long are thinner; pixels, 0 or more; 10.
        /// </summary>
        public float HatchShortest { get; set; }

        /// <summary>
        /// How far a line may stray to either side, as of an unsteady hand, in <see cref="HatchPen"/>s, 0 to 16; 0.
        /// </summary>
        public float HatchWobble { get; set; }

        /// <summary>
        /// Lines run on past the tone that they end at by up to this, each by another length; pixels; 0.
        /// </summary>
        public float HatchOvershoot { get; set; }

        /// <summary>Of these two: any number; 0.</summary>
        public uint HatchSeed { get; set; }

        /// <summary>Another one like this.</summary>
        public LayerStyle Clone()
        {
            return (LayerStyle)MemberwiseClone();
        }

        /// <summary>Everything but the name.</summary>
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
        }
    }
}
