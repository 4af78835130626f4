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
        }
    }
}
