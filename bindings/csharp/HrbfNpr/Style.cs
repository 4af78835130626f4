// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Any illumination model.</summary>
    /// <param name="positions">3 n numbers, world.</param>
    /// <param name="normals">3 n numbers, unit.</param>
    /// <param name="tau">To be filled: n numbers, 1 = light, 0 = dark.</param>
    public delegate void ToneFunction(float[] positions, float[] normals, float[] tau);

    /// <summary>How a point set is drawn.  Plain data: it may be changed at any time, but not while something is drawn.</summary>
    /// <remarks>Numbers out of range are refused by <c>Renderer.Draw</c>.</remarks>
    /// <example>
    /// <code>
    /// var style = Style.Preset(Preset.CrossHatch);
    /// style.Layers[0].Shape = Shape.Strokes;
    /// style.Layers.Insert(0, new LayerStyle(LayerKind.Own) { Name = "seam", Ink = Color.Parse("#a02020") });
    /// </code>
    /// </example>
    public sealed unsafe class Style
    {
        /// <summary>The library's default style.</summary>
        public Style()
        {
            hrbfnpr_style style;
            Errors.Check(NativeMethods.hrbfnpr_style_init(&style, (uint)sizeof(hrbfnpr_style)));
            Layers = new List<LayerStyle>();
            Lines = new List<LineStyle>();
            Read(&style);
        }

        /// <param name="style">A struct of the library's.</param>
        /// <param name="owner">The picture that it belongs to; null of a preset.</param>
        internal Style(hrbfnpr_style* style, SafeHandle owner = null)
        {
            var layers = new List<LayerStyle>();
            byte* layer = (byte*)style->layers;
            for (long i = 0; i < style->layer_count; ++i)
            {
                long stride = style->layer_stride;
                layers.Add(new LayerStyle((hrbfnpr_layer_style*)layer));
                layer += stride != 0 ? stride : ((hrbfnpr_layer_style*)style->layers)->struct_size;
            }
            Layers = layers;
            var lines = new List<LineStyle>();
            byte* line = (byte*)style->lines;
            for (long i = 0; i < style->line_count; ++i)
            {
                long stride = style->line_stride;
                lines.Add(new LineStyle((hrbfnpr_line_style*)line));
                line += stride != 0 ? stride : ((hrbfnpr_line_style*)style->lines)->struct_size;
            }
            Lines = lines;
            Read(style);
            if (style->tone_function == ToneState.Function)
            {
                ToneFunction = CallbackState.From<ToneState>(style->tone_user).Called;
            }
            else
            {
                NativeTone = NativeFunction.Of(style->tone_function, style->tone_user, owner);
            }
        }

        private Style(Style other)
        {
            Layers = new List<LayerStyle>();
            foreach (LayerStyle layer in other.Layers)
            {
                Layers.Add(layer.Clone());
            }
            Lines = new List<LineStyle>();
            foreach (LineStyle line in other.Lines)
            {
                Lines.Add(line.Clone());
            }
            hrbfnpr_style style;
            other.Write(&style);
            Read(&style);
            ToneFunction = other.ToneFunction;
            NativeTone = other.NativeTone;
        }

        /// <summary>
        /// How layers are drawn: a layer of marks takes the first that is for it, or the defaults of a new
        /// <see cref="LayerStyle"/>.
        /// </summary>
        public IList<LayerStyle> Layers { get; }

        /// <summary>
        /// The lines that are drawn, with <see cref="HrbfNpr.Visibility.DepthLayers"/>, of items that have a
        /// <see cref="Item.LineSet"/>.  All presets but Stipple have one; a new style has none.
        /// </summary>
        public IList<LineStyle> Lines { get; }

        /// <summary>What becomes of marks behind nearer surfaces.</summary>
        public HiddenLines HiddenLines { get; set; }

        /// <summary>How it is found what lies in front; one for all styles of a drawing.</summary>
        public Visibility Visibility { get; set; }

        /// <summary>delta in (0, 1): with Visibility.Published marks with |n . v| below it are contours [NPAR 6].</summary>
        public double SilhouetteThreshold { get; set; }

        /// <summary>lambda of alpha_f = nu^2 lambda.</summary>
        public double AttenuationFront { get; set; }

        /// <summary>lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda.</summary>
        public double AttenuationBack { get; set; }

        /// <summary>Of the piece of surface that a mark stands for, pixels; 0 = from the marks' spacing.</summary>
        public float SplatRadius { get; set; }

        /// <summary>How far beyond its contour a surface hides what lies behind, pixels.</summary>
        public float HaloWidth { get; set; }

        /// <summary>n above 0: a depth layer is as opaque as n overlapping splats; 0: as published.</summary>
        public float SplatOverlap { get; set; }

        /// <summary>Where the tone of front marks comes from; a tone function sets it to Callback.</summary>
        public Tone Tone { get; set; }

        /// <summary>How tone, depth, zoom and share are combined.</summary>
        public ToneRule ToneRule { get; set; }

        /// <summary>How many marks a tone takes.</summary>
        public ToneCurve ToneCurve { get; set; }

        /// <summary>0 to 1: marks grow over this share of the marks shown; 0 = they pop.</summary>
        public float ToneFade { get; set; }

        /// <summary>lambda of the tone law, above 0.</summary>
        public double ToneExponent { get; set; }

        /// <summary>
        /// 0 to 1: light from the side opposite to <see cref="Light"/>, so that what is turned away keeps its form.
        /// Not as published.
        /// </summary>
        public float FillLight { get; set; }

        /// <summary>
        /// For <see cref="HrbfNpr.Tone.Callback"/>; called on the thread that draws.  What it throws comes out in a
        /// <see cref="CallbackException"/>.
        /// </summary>
        public ToneFunction ToneFunction { get; set; }

        /// <summary>
        /// The library's own function in place of <see cref="ToneFunction"/>, where a picture is painted; else null.
        /// </summary>
        internal NativeFunction NativeTone { get; private set; }

        /// <summary>What the light moves with.</summary>
        public LightSpace LightSpace { get; set; }

        /// <summary>Towards the light; normalised on use.</summary>
        public Vector3d Light { get; set; }

        /// <summary>Ink of contour marks.</summary>
        public Color SilhouetteInk { get; set; }

        /// <summary>Of contour marks, pixels.</summary>
        public float SilhouetteRadius { get; set; }

        /// <summary>As <see cref="LayerStyle.RadiusZoom"/>.</summary>
        public float SilhouetteRadiusZoom { get; set; }

        /// <summary>Distance from the camera where depth attenuation starts.</summary>
        public double DepthMin { get; set; }

        /// <summary>... and where nothing is shown any more; 0 and 0 = off.</summary>
        public double DepthMax { get; set; }

        /// <summary>Pixels per world unit at which all marks are shown; 0 = off.</summary>
        public double ZoomReference { get; set; }

        /// <summary>How fast marks vanish below it, 0 or more; 2 keeps the ink per area.</summary>
        public double ZoomExponent { get; set; }

        /// <summary>Colour of the paper; alpha 0 = transparent.  One for all styles of a drawing.</summary>
        public Color Paper { get; set; }

        /// <summary>Gives all layers, all lines and the contours one ink.</summary>
        public Color Ink
        {
            set
            {
                SilhouetteInk = value;
                if (Layers.Count == 0)
                {
                    Layers.Add(new LayerStyle());
                }
                foreach (LayerStyle layer in Layers)
                {
                    layer.Ink = value;
                }
                foreach (LineStyle line in Lines)
                {
                    line.Ink = value;
                }
            }
        }

        /// <summary>A named style, to be changed further.</summary>
        /// <remarks><see cref="GenerateOptions.ForPreset"/> makes the layers that it draws.</remarks>
        /// <exception cref="InvalidArgumentException">There is no such preset.</exception>
        public static Style Preset(Preset preset)
        {
            hrbfnpr_style style;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_style_init_preset(
                    &style, (uint)sizeof(hrbfnpr_style), unchecked((uint)preset), &error),
                &error);
            return new Style(&style);
        }

        /// <summary>The name of a preset, such as "cross-hatch"; null for a number that is no preset's.</summary>
        public static string PresetName(Preset preset)
        {
            byte* name = NativeMethods.hrbfnpr_preset_name(unchecked((uint)preset));
            return name == null ? null : Errors.Utf8(name);
        }

        /// <summary>Another style like this one.</summary>
        public Style Clone()
        {
            return new Style(this);
        }

        /// <summary>Everything but the layers, the lines and the tone function.</summary>
        internal void Write(hrbfnpr_style* style)
        {
            Errors.Check(NativeMethods.hrbfnpr_style_init(style, (uint)sizeof(hrbfnpr_style)));
            style->hidden_lines = (uint)HiddenLines;
            style->visibility = (uint)Visibility;
            style->silhouette_threshold = SilhouetteThreshold;
            style->attenuation_front = AttenuationFront;
            style->attenuation_back = AttenuationBack;
            style->splat_radius = SplatRadius;
            style->halo_width = HaloWidth;
            style->splat_overlap = SplatOverlap;
            style->tone = (uint)Tone;
            style->tone_rule = (uint)ToneRule;
            style->tone_curve = (uint)ToneCurve;
            style->tone_fade = ToneFade;
            style->tone_exponent = ToneExponent;
            style->fill_light = FillLight;
            style->light_space = (uint)LightSpace;
            *(Vector3d*)style->light = Light;
            SilhouetteInk.Write(style->silhouette_ink);
            style->silhouette_radius = SilhouetteRadius;
            style->silhouette_radius_zoom = SilhouetteRadiusZoom;
            style->depth_min = DepthMin;
            style->depth_max = DepthMax;
            style->zoom_reference = ZoomReference;
            style->zoom_exponent = ZoomExponent;
            Paper.Write(style->paper);
        }

        private void Read(hrbfnpr_style* style)
        {
            HiddenLines = (HiddenLines)style->hidden_lines;
            Visibility = (Visibility)style->visibility;
            SilhouetteThreshold = style->silhouette_threshold;
            AttenuationFront = style->attenuation_front;
            AttenuationBack = style->attenuation_back;
            SplatRadius = style->splat_radius;
            HaloWidth = style->halo_width;
            SplatOverlap = style->splat_overlap;
            Tone = (Tone)style->tone;
            ToneRule = (ToneRule)style->tone_rule;
            ToneCurve = (ToneCurve)style->tone_curve;
            ToneFade = style->tone_fade;
            ToneExponent = style->tone_exponent;
            FillLight = style->fill_light;
            LightSpace = (LightSpace)style->light_space;
            Light = *(Vector3d*)style->light;
            SilhouetteInk = Color.Read(style->silhouette_ink);
            SilhouetteRadius = style->silhouette_radius;
            SilhouetteRadiusZoom = style->silhouette_radius_zoom;
            DepthMin = style->depth_min;
            DepthMax = style->depth_max;
            ZoomReference = style->zoom_reference;
            ZoomExponent = style->zoom_exponent;
            Paper = Color.Read(style->paper);
        }
    }

    /// <summary>The tone function of one item of a drawing.</summary>
    internal sealed unsafe class ToneState : CallbackState
    {
        internal static readonly IntPtr Function;
        private static readonly NativeCallbacks.Tone FunctionCallback = OnTone;

        static ToneState()
        {
            Function = Marshal.GetFunctionPointerForDelegate(FunctionCallback);
        }

        internal ToneState(ToneFunction function)
        {
            Called = function;
        }

        /// <summary>The program's function.</summary>
        internal ToneFunction Called { get; }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Tone))]
        private static int OnTone(IntPtr user, long count, float* positions, float* normals, float* tau)
        {
            var state = From<ToneState>(user);
            try
            {
                var places = new float[count * 3];
                var directions = new float[count * 3];
                var result = new float[count];
                Marshal.Copy((IntPtr)positions, places, 0, places.Length);
                Marshal.Copy((IntPtr)normals, directions, 0, directions.Length);
                state.Called(places, directions, result);
                Marshal.Copy(result, 0, (IntPtr)tau, result.Length);
                return 0;
            }
            catch (Exception exception)
            {
                state.Keep(exception);
                return 1;
            }
        }
    }
}
