// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Computes the tone of n places, by any illumination model.</summary>
    /// <param name="positions">3 n numbers: world positions.</param>
    /// <param name="normals">3 n numbers: unit normals.</param>
    /// <param name="tau">Receives n numbers: 1 = light, 0 = dark.  Numbers outside 0 to 1 are clamped.</param>
    public delegate void ToneFunction(float[] positions, float[] normals, float[] tau);

    /// <summary>
    /// How an item is drawn.  A style is plain data: it may be changed at any time, except while something is drawn
    /// with it.
    /// </summary>
    /// <remarks><c>Renderer.Draw</c> refuses numbers out of range.</remarks>
    /// <example>
    /// <code>
    /// var style = Style.Preset(Preset.CrossHatch);
    /// style.Layers[0].Shape = Shape.Strokes;
    /// style.Layers.Insert(0, new LayerStyle(LayerKind.Own) { Name = "seam", Ink = Color.Parse("#a02020") });
    /// </code>
    /// </example>
    public sealed unsafe class Style
    {
        /// <summary>Creates the library's default style.</summary>
        public Style()
        {
            hrbfnpr_style style;
            Errors.Check(NativeMethods.hrbfnpr_style_init(&style, (uint)sizeof(hrbfnpr_style)));
            Layers = new List<LayerStyle>();
            Lines = new List<LineStyle>();
            Lights = new List<Light>();
            Palette = new List<Color>();
            Read(&style);
        }

        /// <param name="style">A style of the library.</param>
        /// <param name="owner">The picture that it belongs to; null for a preset.</param>
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
            var lights = new List<Light>();
            byte* light = (byte*)style->lights;
            for (long i = 0; i < style->light_count; ++i)
            {
                long stride = style->light_stride;
                lights.Add(new Light((hrbfnpr_light*)light));
                light += stride != 0 ? stride : ((hrbfnpr_light*)style->lights)->struct_size;
            }
            Lights = lights;
            Palette = new List<Color>();
            for (long i = 0; i < style->palette_count; ++i)
            {
                Palette.Add(Color.Read((float*)style->palette + 4 * i));
            }
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
            Lights = new List<Light>();
            foreach (Light light in other.Lights)
            {
                Lights.Add(light.Clone());
            }
            Palette = new List<Color>(other.Palette);
            hrbfnpr_style style;
            other.Write(&style);
            Read(&style);
            ToneFunction = other.ToneFunction;
            NativeTone = other.NativeTone;
        }

        /// <summary>
        /// Styles of layers.  A layer of marks takes the first that is for it, or else the defaults of a new
        /// <see cref="LayerStyle"/>.
        /// </summary>
        public IList<LayerStyle> Layers { get; }

        /// <summary>
        /// Styles of lines, for items that have a <see cref="Item.LineSet"/>; default empty = no lines.  Used with
        /// <see cref="HrbfNpr.Visibility.DepthLayers"/>; all presets except Stipple have some.
        /// </summary>
        public IList<LineStyle> Lines { get; }

        /// <summary>
        /// Up to 8 lights, whose sum is the light of a mark; default empty = one directional light with
        /// <see cref="Light"/>, <see cref="LightSpace"/>, <see cref="LightIntensity"/>, <see cref="LightShadow"/> and
        /// <see cref="LightSoftness"/>, which the list replaces.  The first one is the light of isophotes and of
        /// <see cref="LineStyle.LitFactor"/>.
        /// </summary>
        /// <remarks>
        /// For Tone.Light with Visibility.DepthLayers and ToneRule.Share.  The tone law makes tau of the light s: tau =
        /// t^<see cref="ToneGamma"/>, where t = (s - <see cref="ToneBlack"/>) / (<see cref="ToneWhite"/> -
        /// <see cref="ToneBlack"/>), clamped to 0 to 1.
        /// </remarks>
        public IList<Light> Lights { get; }

        /// <summary>The inks for layers with a <see cref="LayerStyle.InkField"/>; up to 8; default none.</summary>
        public IList<Color> Palette { get; }

        /// <summary>How ink behind a nearer surface is drawn; default Attenuate.</summary>
        public HiddenLines HiddenLines { get; set; }

        /// <summary>
        /// How hidden marks are found; default DepthLayers.  It must be the same in all styles of a drawing.
        /// </summary>
        public Visibility Visibility { get; set; }

        /// <summary>
        /// delta, which separates front, back and silhouette marks with Visibility.Published; in (0, 1); default 0.2.
        /// Larger: wider contours [NPAR 6].
        /// </summary>
        public double SilhouetteThreshold { get; set; }

        /// <summary>
        /// lambda of alpha_f = nu^2 lambda, the opacity of surface that faces the eye; 0 or more; default 1.  Larger:
        /// hidden ink is paler.
        /// </summary>
        public double AttenuationFront { get; set; }

        /// <summary>
        /// lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda, the opacity of surface that faces away; 0 or more;
        /// default 1.  Larger: hidden ink is paler.
        /// </summary>
        public double AttenuationBack { get; set; }

        /// <summary>
        /// Radius of the splat, the disc of surface around a mark, in pixels; 0 to 16384; default 0 = from the marks'
        /// spacing in the picture.
        /// </summary>
        public float SplatRadius { get; set; }

        /// <summary>
        /// Width of the halo, in pixels at any zoom; 0 to 16384; default 2.  A surface hides what lies behind it up to
        /// this far beyond its contour.  If it is above 0, lines that run beside others, nearer than a pen, are thinned.
        /// </summary>
        public float HaloWidth { get; set; }

        /// <summary>
        /// Whether rays from the eye are compared with all parts of the item's lines, so that wrong parts are repaired;
        /// default false.  <see cref="DrawingInfo"/> has the counts.
        /// </summary>
        public bool VerifyLines { get; set; }

        /// <summary>
        /// Number n of splats that overlap in a depth layer, whose opacity is 1 - (1 - alpha)^n; 0 to 1e6; default 8; 0
        /// = each mark paints with alpha itself, as published.  Larger: hidden ink is paler.
        /// </summary>
        public float SplatOverlap { get; set; }

        /// <summary>
        /// Source of the tone of front marks; default Light.  Setting <see cref="ToneFunction"/> sets it to Callback.
        /// </summary>
        public Tone Tone { get; set; }

        /// <summary>Which front marks are shown; default Share.</summary>
        public ToneRule ToneRule { get; set; }

        /// <summary>How many marks a tone shows, with <see cref="HrbfNpr.ToneRule.Share"/>; default Coverage.</summary>
        public ToneCurve ToneCurve { get; set; }

        /// <summary>Where stipples are evenly spread; default Picture.</summary>
        public Evenness Evenness { get; set; }

        /// <summary>
        /// Share of the shown marks over which a mark grows from nothing to its full area; 0 to 1; default 0.25; 0 =
        /// marks pop in.
        /// </summary>
        public float ToneFade { get; set; }

        /// <summary>
        /// lambda, the exponent of the tone law; above 0; default 1.  Larger: the picture gets darker.
        /// </summary>
        public double ToneExponent { get; set; }

        /// <summary>
        /// Strength of a light from the side opposite to <see cref="Light"/>, or to the first of <see cref="Lights"/>,
        /// which lets the unlit side keep its form; 0 to 1; default 0.25.
        /// </summary>
        public float FillLight { get; set; }

        /// <summary>Direction to the sky, in world space, of any length but 0; default (0, 1, 0).</summary>
        public Vector3d AmbientUp { get; set; }

        /// <summary>
        /// Light where the surface faces the sky; 0 to 16; default 0.  Ambient light is a mean of the light from the
        /// sky, weighted by (1 + n . up) / 2, and that from the ground.
        /// </summary>
        public float AmbientSky { get; set; }

        /// <summary>Light where the surface faces the ground; 0 to 16; default 0.</summary>
        public float AmbientGround { get; set; }

        /// <summary>
        /// Share of the ambient light that is lost where no sky is seen; 0 to 1; default 1.
        /// </summary>
        /// <remarks>It has an effect on items with an <see cref="Item.Shading"/>.</remarks>
        public float Occlusion { get; set; }

        /// <summary>
        /// Ambient light is multiplied by the share of the sky that is seen to this power; above 0, up to 16; default
        /// 1.5.  Larger: hollows are darker.
        /// </summary>
        public float OcclusionExponent { get; set; }

        /// <summary>
        /// Strength of a light on contours, which adds RimLight * (1 - |n . v|)^<see cref="RimExponent"/>, where v
        /// points to the eye; 0 to 16; default 0.
        /// </summary>
        public float RimLight { get; set; }

        /// <summary>
        /// Exponent of the rim light; above 0, up to 64; default 3.  Larger: the light rim is narrower.
        /// </summary>
        public float RimExponent { get; set; }

        /// <summary>Light that is drawn as black; -16 to 16; default 0.</summary>
        public float ToneBlack { get; set; }

        /// <summary>
        /// Light that is drawn as white; above <see cref="ToneBlack"/>, up to 16; default 1.
        /// </summary>
        public float ToneWhite { get; set; }

        /// <summary>
        /// Exponent of the tone law; above 0, up to 16; default 1.  Larger: mid-tones are darker.
        /// </summary>
        public float ToneGamma { get; set; }

        /// <summary>
        /// Number of flat tones, from black to white; 2 to 6; default 0 = continuous tones.  All steps have the same
        /// size.
        /// </summary>
        public uint ToneSteps { get; set; }

        /// <summary>
        /// Light that ridges and hills add, and that hollows take away; 0 to 16; default 0.  It has an effect on items
        /// whose shading was made with it (<see cref="ShadingOptions.CurvatureScale"/>).
        /// </summary>
        public float CurvatureContrast { get; set; }

        /// <summary>
        /// Share of the light of all lights and of the fill light that is lost where no sky is seen, 0 to 1; default 0.
        /// Hollows get darker, and the rest stays as it is.  It has an effect on items with a <see cref="Shading"/>.
        /// </summary>
        public float OcclusionLights { get; set; }

        /// <summary>
        /// The function of <see cref="HrbfNpr.Tone.Callback"/>, which runs on the thread that draws; default null.  If
        /// it throws, the drawing throws a <see cref="CallbackException"/>.
        /// </summary>
        public ToneFunction ToneFunction { get; set; }

        /// <summary>
        /// The library's function in place of <see cref="ToneFunction"/>, if a picture is painted; else null.
        /// </summary>
        internal NativeFunction NativeTone { get; private set; }

        /// <summary>Space of <see cref="Light"/>; default Camera.</summary>
        public LightSpace LightSpace { get; set; }

        /// <summary>
        /// Direction to the light, of any length but 0; default (-0.4, 0.6, 0.7).  <see cref="Lights"/> replace it.
        /// </summary>
        public Vector3d Light { get; set; }

        /// <summary>
        /// Strength of the light; 0 to 16; default 1 = a surface that faces the light is white.
        /// </summary>
        public float LightIntensity { get; set; }

        /// <summary>
        /// Share of its light that its cast shadows take away; 0 to 1; default 0 = it casts none.
        /// </summary>
        /// <remarks>It has an effect on items with an <see cref="Item.Shading"/>.</remarks>
        public float LightShadow { get; set; }

        /// <summary>
        /// Radius of the light as it is seen from the surface, in radians; 0 to 0.5; default 0 = shadows with sharp
        /// borders.
        /// </summary>
        public float LightSoftness { get; set; }

        /// <summary>Colour of silhouette marks, with Visibility.Published; default black.</summary>
        public Color SilhouetteInk { get; set; }

        /// <summary>
        /// Radius of a silhouette mark, in pixels, with Visibility.Published; above 0, up to 16384; default 1.
        /// </summary>
        public float SilhouetteRadius { get; set; }

        /// <summary>
        /// How <see cref="SilhouetteRadius"/> follows the zoom, as <see cref="LayerStyle.RadiusZoom"/>; 0 to 1; default
        /// 0.
        /// </summary>
        public float SilhouetteRadiusZoom { get; set; }

        /// <summary>
        /// Distance from the camera at which marks begin to vanish, in world units; default 0.  If it and
        /// <see cref="DepthMax"/> are 0, distance has no effect.
        /// </summary>
        public double DepthMin { get; set; }

        /// <summary>
        /// Distance from the camera from which on nothing is shown, in world units; above <see cref="DepthMin"/>;
        /// default 0 = no effect.
        /// </summary>
        public double DepthMax { get; set; }

        /// <summary>
        /// Pixels per world unit from which on all marks are shown; 0 or more; default 0 = no effect.
        /// </summary>
        public double ZoomReference { get; set; }

        /// <summary>
        /// Exponent of the zoom, by which the share of shown marks falls below <see cref="ZoomReference"/>; 0 or more;
        /// default 2, which keeps the ink per area.
        /// </summary>
        public double ZoomExponent { get; set; }

        /// <summary>
        /// Colour of the paper; default white; alpha 0 = transparent.  It must be the same in all styles of a drawing.
        /// </summary>
        public Color Paper { get; set; }

        /// <summary>Sets the ink of all layers, all lines and the contours.</summary>
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

        /// <summary>Makes a named style, which can be changed.</summary>
        /// <remarks><see cref="GenerateOptions.ForPreset"/> makes the layers of marks that it draws.</remarks>
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

        /// <summary>
        /// Returns the name of a preset, such as "cross-hatch"; null for a number that no preset has.
        /// </summary>
        public static string PresetName(Preset preset)
        {
            byte* name = NativeMethods.hrbfnpr_preset_name(unchecked((uint)preset));
            return name == null ? null : Errors.Utf8(name);
        }

        /// <summary>Copies the style.</summary>
        public Style Clone()
        {
            return new Style(this);
        }

        /// <summary>Writes everything except the layers, the lines, the lights and the tone function.</summary>
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
            style->verify_lines = VerifyLines ? 1u : 0;
            style->splat_overlap = SplatOverlap;
            style->tone = (uint)Tone;
            style->tone_rule = (uint)ToneRule;
            style->tone_curve = (uint)ToneCurve;
            style->evenness = (uint)Evenness;
            style->tone_fade = ToneFade;
            style->tone_exponent = ToneExponent;
            style->fill_light = FillLight;
            *(Vector3d*)style->ambient_up = AmbientUp;
            style->ambient_sky = AmbientSky;
            style->ambient_ground = AmbientGround;
            style->occlusion = Occlusion;
            style->occlusion_exponent = OcclusionExponent;
            style->rim_light = RimLight;
            style->rim_exponent = RimExponent;
            style->tone_black = ToneBlack;
            style->tone_white = ToneWhite;
            style->tone_gamma = ToneGamma;
            style->tone_steps = ToneSteps;
            style->curvature_contrast = CurvatureContrast;
            style->occlusion_lights = OcclusionLights;
            style->light_space = (uint)LightSpace;
            *(Vector3d*)style->light = Light;
            style->light_intensity = LightIntensity;
            style->light_shadow = LightShadow;
            style->light_softness = LightSoftness;
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
            VerifyLines = style->verify_lines != 0;
            SplatOverlap = style->splat_overlap;
            Tone = (Tone)style->tone;
            ToneRule = (ToneRule)style->tone_rule;
            ToneCurve = (ToneCurve)style->tone_curve;
            Evenness = (Evenness)style->evenness;
            ToneFade = style->tone_fade;
            ToneExponent = style->tone_exponent;
            FillLight = style->fill_light;
            AmbientUp = *(Vector3d*)style->ambient_up;
            AmbientSky = style->ambient_sky;
            AmbientGround = style->ambient_ground;
            Occlusion = style->occlusion;
            OcclusionExponent = style->occlusion_exponent;
            RimLight = style->rim_light;
            RimExponent = style->rim_exponent;
            ToneBlack = style->tone_black;
            ToneWhite = style->tone_white;
            ToneGamma = style->tone_gamma;
            ToneSteps = style->tone_steps;
            CurvatureContrast = style->curvature_contrast;
            OcclusionLights = style->occlusion_lights;
            LightSpace = (LightSpace)style->light_space;
            Light = *(Vector3d*)style->light;
            LightIntensity = style->light_intensity;
            LightShadow = style->light_shadow;
            LightSoftness = style->light_softness;
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

        /// <summary>The function of the program.</summary>
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
