using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Any illumination model.</summary>
    /// <param name="positions">3 n numbers, world.</param>
    /// <param name="normals">3 n numbers, unit.</param>
    /// <param name="tau">To be filled: n numbers, 1 = light, 0 = dark.</param>
    public delegate void ToneFunction(float[] positions, float[] normals, float[] tau);

    /// <summary>One group's ink.</summary>
    public sealed unsafe class GroupStyle
    {
        internal GroupStyle(hrbfnpr_group_style* native)
        {
            Shown = native->shown != 0;
            Sets = (int)native->sets;
            Share = native->share;
            Radius = native->radius;
            RadiusZoom = native->radius_zoom;
            Ink = Color.Read(native->ink);
        }

        /// <summary>Whether its front marks are drawn.</summary>
        public bool Shown { get; set; }

        /// <summary>Bit 0: first directions, bit 1: second.</summary>
        public int Sets { get; set; }

        /// <summary>Share of the group's marks that is used at all, 0 to 1.</summary>
        public float Share { get; set; }

        /// <summary>Of a mark, pixels, above 0.</summary>
        public float Radius { get; set; }

        /// <summary>0: the radius is in pixels at any zoom; 1: it grows with the zoom; or between.</summary>
        public float RadiusZoom { get; set; }

        /// <summary>Colour of the marks.</summary>
        public Color Ink { get; set; }

        internal void Write(hrbfnpr_group_style* native)
        {
            native->shown = Shown ? 1u : 0;
            native->sets = unchecked((uint)Sets);
            native->share = Share;
            native->radius = Radius;
            native->radius_zoom = RadiusZoom;
            Ink.Write(native->ink);
        }

        internal void CopyTo(GroupStyle other)
        {
            other.Shown = Shown;
            other.Sets = Sets;
            other.Share = Share;
            other.Radius = Radius;
            other.RadiusZoom = RadiusZoom;
            other.Ink = Ink;
        }
    }

    /// <summary>How a point set is drawn.  Plain data: it may be changed at any time, but not while a frame is prepared.</summary>
    /// <remarks>Numbers out of range are refused by <see cref="Renderer.Prepare"/>.</remarks>
    public sealed unsafe class Style
    {
        private readonly hrbfnpr_style initial;

        /// <summary>The library's default style.</summary>
        public Style()
        {
            hrbfnpr_style style;
            Errors.Check(NativeMethods.hrbfnpr_style_init(&style, (uint)sizeof(hrbfnpr_style)));
            initial = style;
            Groups = Groups.All;
            Stipple = new GroupStyle(&style.group0);
            Curvature = new GroupStyle(&style.group1);
            Combing = new GroupStyle(&style.group2);
            Read(&style);
        }

        /// <summary>A named style, to be changed further.</summary>
        /// <exception cref="InvalidArgumentException">There is no such preset.</exception>
        public Style(StylePreset preset)
        {
            hrbfnpr_style style;
            uint groups;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_style_init_preset(
                    &style, (uint)sizeof(hrbfnpr_style), unchecked((uint)preset), &groups, &error),
                &error);
            initial = style;
            Groups = (Groups)groups;
            Stipple = new GroupStyle(&style.group0);
            Curvature = new GroupStyle(&style.group1);
            Combing = new GroupStyle(&style.group2);
            Read(&style);
        }

        private Style(Style other)
        {
            initial = other.initial;
            Groups = other.Groups;
            ToneFunction = other.ToneFunction;
            hrbfnpr_style style = other.initial;
            other.Write(&style);
            Stipple = new GroupStyle(&style.group0);
            Curvature = new GroupStyle(&style.group1);
            Combing = new GroupStyle(&style.group2);
            Read(&style);
        }

        /// <summary>The groups of marks that the preset draws: for <see cref="GenerateOptions.Groups"/>.</summary>
        public Groups Groups { get; }

        /// <summary>Ink of the stipples.</summary>
        public GroupStyle Stipple { get; }

        /// <summary>Ink of the strokes along principal directions.</summary>
        public GroupStyle Curvature { get; }

        /// <summary>Ink of the combing strokes.</summary>
        public GroupStyle Combing { get; }

        /// <summary>What becomes of marks behind nearer surfaces.</summary>
        public HiddenLines HiddenLines { get; set; }

        /// <summary>How it is found what lies in front; one for all styles of a frame.</summary>
        public Visibility Visibility { get; set; }

        /// <summary>delta in (0, 1): marks with |n . v| below it are contours [NPAR 6].</summary>
        public double SilhouetteThreshold { get; set; }

        /// <summary>Which marks belong to the contour.</summary>
        public SilhouetteLaw SilhouetteLaw { get; set; }

        /// <summary>Of the law Width: pixels on either side of the contour.</summary>
        public float SilhouetteWidth { get; set; }

        /// <summary>lambda of alpha_f = nu^2 lambda.</summary>
        public double AttenuationFront { get; set; }

        /// <summary>lambda of alpha_b = 0.2 (ln(nu - 0.05) + 5) lambda.</summary>
        public double AttenuationBack { get; set; }

        /// <summary>Of the paper that front marks paint, pixels; 0 = from the marks' spacing.</summary>
        public float CoverRadius { get; set; }

        /// <summary>How far beyond its contour a surface hides what lies behind, pixels.</summary>
        public float HaloWidth { get; set; }

        /// <summary>n above 0: a sheet is as opaque as n overlapping marks; 0: as published.</summary>
        public float CoverLayers { get; set; }

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
        /// For <see cref="HrbfNpr.Tone.Callback"/>; called on the thread that prepares.  What it throws comes out in a
        /// <see cref="CallbackException"/>.
        /// </summary>
        public ToneFunction ToneFunction { get; set; }

        /// <summary>What the light moves with.</summary>
        public LightSpace LightSpace { get; set; }

        /// <summary>Towards the light; normalised on use.</summary>
        public Vector3d Light { get; set; }

        /// <summary>Groups whose contour marks are drawn.</summary>
        public Groups SilhouetteGroups { get; set; }

        /// <summary>Ink of contour marks.</summary>
        public Color SilhouetteInk { get; set; }

        /// <summary>Of contour marks, pixels.</summary>
        public float SilhouetteRadius { get; set; }

        /// <summary>As <see cref="GroupStyle.RadiusZoom"/>.</summary>
        public float SilhouetteRadiusZoom { get; set; }

        /// <summary>Distance from the camera where depth attenuation starts.</summary>
        public double DepthMin { get; set; }

        /// <summary>... and where nothing is shown any more; 0 and 0 = off.</summary>
        public double DepthMax { get; set; }

        /// <summary>Pixels per world unit at which all marks are shown; 0 = off.</summary>
        public double ZoomReference { get; set; }

        /// <summary>How fast marks vanish below it, 0 or more; 2 keeps the ink per area.</summary>
        public double ZoomExponent { get; set; }

        /// <summary>Colour of the paper; alpha 0 = transparent.  One for all styles of a frame.</summary>
        public Color Paper { get; set; }

        /// <summary>Gives all groups and the contours one ink.</summary>
        public Color Ink
        {
            set
            {
                SilhouetteInk = value;
                Stipple.Ink = value;
                Curvature.Ink = value;
                Combing.Ink = value;
            }
        }

        /// <summary>The name of a preset, such as "cross-hatch"; null for a number out of range.</summary>
        public static string PresetName(StylePreset preset)
        {
            byte* name = NativeMethods.hrbfnpr_style_preset_name(unchecked((uint)preset));
            return name == null ? null : Errors.Utf8(name);
        }

        /// <summary>Another style like this one.</summary>
        public Style Clone()
        {
            return new Style(this);
        }

        internal void Write(hrbfnpr_style* style)
        {
            *style = initial;
            style->hidden_lines = (uint)HiddenLines;
            style->visibility = (uint)Visibility;
            style->silhouette_threshold = SilhouetteThreshold;
            style->silhouette_law = (uint)SilhouetteLaw;
            style->silhouette_width = SilhouetteWidth;
            style->attenuation_front = AttenuationFront;
            style->attenuation_back = AttenuationBack;
            style->cover_radius = CoverRadius;
            style->halo_width = HaloWidth;
            style->cover_layers = CoverLayers;
            style->tone = (uint)Tone;
            style->tone_rule = (uint)ToneRule;
            style->tone_curve = (uint)ToneCurve;
            style->tone_fade = ToneFade;
            style->tone_exponent = ToneExponent;
            style->light_space = (uint)LightSpace;
            *(Vector3d*)style->light = Light;
            style->silhouette_groups = (uint)SilhouetteGroups;
            SilhouetteInk.Write(style->silhouette_ink);
            style->silhouette_radius = SilhouetteRadius;
            style->silhouette_radius_zoom = SilhouetteRadiusZoom;
            style->depth_min = DepthMin;
            style->depth_max = DepthMax;
            style->zoom_reference = ZoomReference;
            style->zoom_exponent = ZoomExponent;
            Paper.Write(style->paper);
            Stipple.Write(&style->group0);
            Curvature.Write(&style->group1);
            Combing.Write(&style->group2);
        }

        private void Read(hrbfnpr_style* style)
        {
            HiddenLines = (HiddenLines)style->hidden_lines;
            Visibility = (Visibility)style->visibility;
            SilhouetteThreshold = style->silhouette_threshold;
            SilhouetteLaw = (SilhouetteLaw)style->silhouette_law;
            SilhouetteWidth = style->silhouette_width;
            AttenuationFront = style->attenuation_front;
            AttenuationBack = style->attenuation_back;
            CoverRadius = style->cover_radius;
            HaloWidth = style->halo_width;
            CoverLayers = style->cover_layers;
            Tone = (Tone)style->tone;
            ToneRule = (ToneRule)style->tone_rule;
            ToneCurve = (ToneCurve)style->tone_curve;
            ToneFade = style->tone_fade;
            ToneExponent = style->tone_exponent;
            LightSpace = (LightSpace)style->light_space;
            Light = *(Vector3d*)style->light;
            SilhouetteGroups = (Groups)style->silhouette_groups;
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

    /// <summary>The tone function of one item of a frame.</summary>
    internal sealed unsafe class ToneState : CallbackState
    {
        internal static readonly IntPtr Function;
        private static readonly NativeCallbacks.Tone FunctionCallback = OnTone;
        private readonly ToneFunction function;

        static ToneState()
        {
            Function = Marshal.GetFunctionPointerForDelegate(FunctionCallback);
        }

        internal ToneState(ToneFunction function)
        {
            this.function = function;
        }

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
                state.function(places, directions, result);
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
