// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Gives a density on the surface.</summary>
    /// <param name="positions">3 n numbers: absolute positions.</param>
    /// <param name="normals">3 n numbers: unit normals.</param>
    /// <param name="density">Receives n numbers: 1 where marks lie closest, 0 where no mark lies.</param>
    public delegate void DensityFunction(double[] positions, double[] normals, double[] density);

    /// <summary>Gives a field of directions on the surface.</summary>
    /// <param name="positions">3 n numbers: absolute positions.</param>
    /// <param name="normals">3 n numbers: unit normals.</param>
    /// <param name="directions">Receives 3 n numbers.  Only the tangent part of a direction counts; its sign and length
    /// do not.  (0, 0, 0) means no direction: lines follow the smoothest field between the others.</param>
    public delegate void DirectionFunction(double[] positions, double[] normals, double[] directions);

    /// <summary>How one layer of marks is made; a new one holds all defaults.</summary>
    /// <remarks>
    /// The functions run on the thread that generates, with some thousand places at a time.  If one of them throws, the
    /// call throws a <see cref="CallbackException"/>.
    /// </remarks>
    public sealed class Layer
    {
        /// <summary>The budget of a layer whose budget is not set.</summary>
        public const long DefaultBudget = 40000;

        /// <summary>Creates a layer with all defaults.</summary>
        /// <param name="kind">The kind of the layer: Stipples or Hatch.</param>
        public Layer(LayerKind kind = LayerKind.Stipples)
        {
            Kind = kind;
        }

        /// <summary>Creates a layer of stipples.</summary>
        /// <param name="budget">The largest number of marks.</param>
        /// <param name="name">The name for styles; null = "stipples".</param>
        public static Layer Stipples(long budget = DefaultBudget, string name = null)
        {
            return new Layer(LayerKind.Stipples) { Budget = budget, Name = name };
        }

        /// <summary>
        /// Creates a layer of evenly spaced, nested lines; with <see cref="Distribution.Published"/>, of strokes in
        /// both directions.
        /// </summary>
        /// <param name="separation">The mean distance of neighbouring lines, in the unit of the samples; 0 = by the
        /// budget.</param>
        /// <param name="angle">The angle by which lines are turned in the tangent plane, in degrees.</param>
        /// <param name="name">The name for styles; null = "hatch".</param>
        /// <param name="budget">The largest number of marks; null = 40000, or no limit with a separation.</param>
        public static Layer Hatch(double separation = 0, double angle = 0, string name = null, long? budget = null)
        {
            return new Layer(LayerKind.Hatch)
            {
                Separation = separation,
                Angle = angle,
                Name = name,
                Budget = budget ?? (separation > 0 ? 0 : DefaultBudget),
            };
        }

        /// <summary>The kind of the layer's marks: Stipples or Hatch; default Stipples.</summary>
        public LayerKind Kind { get; set; }

        /// <summary>Name for styles, 1 to 63 bytes of UTF-8; default null = "stipples" or "hatch".</summary>
        public string Name { get; set; }

        /// <summary>
        /// Largest number of marks; 0 or more; default 40000; 0 = no limit, for <see cref="Distribution.Published"/>
        /// and for lines with a separation.
        /// </summary>
        public long Budget { get; set; } = DefaultBudget;

        /// <summary>
        /// Darkness, 1 - tau, at which the first mark is shown; 0 to 1; default 0.  If <see cref="ToneEnd"/> is 0, too,
        /// <see cref="GenerateOptions.ToneRanges"/> decides.
        /// </summary>
        /// <remarks>For published strokes, it applies to the first direction.</remarks>
        public float ToneBegin { get; set; }

        /// <summary>
        /// Darkness, 1 - tau, at which all marks are shown; above <see cref="ToneBegin"/>, at most 1; default 0.
        /// </summary>
        public float ToneEnd { get; set; }

        /// <summary>
        /// The same as <see cref="ToneBegin"/>, for published strokes of the second direction; default 0.
        /// </summary>
        public float SecondToneBegin { get; set; }

        /// <summary>
        /// The same as <see cref="ToneEnd"/>, for published strokes of the second direction; default 0.
        /// </summary>
        public float SecondToneEnd { get; set; }

        /// <summary>
        /// Whether marks get curvatures; default false.  Published strokes along curvature always have them.
        /// </summary>
        public bool WithCurvature { get; set; }

        /// <summary>How densely blue-noise stipples lie; default Uniform.</summary>
        public Density Density { get; set; }

        /// <summary>
        /// Strength of <see cref="HrbfNpr.Density.Curvature"/>; 0 to 1; default 0.5; 0 = uniform.  Larger values put
        /// more stipples where the surface bends.
        /// </summary>
        public double DensityStrength { get; set; } = 0.5;

        /// <summary>The function of <see cref="HrbfNpr.Density.Callback"/>; default null.</summary>
        public DensityFunction DensityFunction { get; set; }

        /// <summary>
        /// The scalar field of <see cref="HrbfNpr.Density.Field"/>: 1 where marks lie closest, 0 where no mark lies;
        /// default null.
        /// </summary>
        public Field DensityField { get; set; }

        /// <summary>
        /// Hatch: mean distance of neighbouring lines, in the unit of the samples; 1e-12 to 1e9 diagonals; default 0 =
        /// by the budget.  Smaller values give more lines.
        /// </summary>
        public double Separation { get; set; }

        /// <summary>
        /// Hatch: distance between the marks of a line, in the unit of the samples; default 0 = 0.4 of the separation.
        /// </summary>
        public double Step { get; set; }

        /// <summary>Hatch: the directions that lines follow; default null = those of <see cref="Guide"/>.</summary>
        public DirectionFunction DirectionFunction { get; set; }

        /// <summary>
        /// Hatch: a field of directions that lines follow; default null.  It excludes <see cref="DirectionFunction"/>.
        /// Where its weight is below 0.5, lines follow the smoothest field between.
        /// </summary>
        public Field DirectionField { get; set; }

        /// <summary>Where the strokes of <see cref="Distribution.Published"/> start; default Seeds.</summary>
        public StrokeStart Start { get; set; }

        /// <summary>
        /// Last level of stipples at which strokes start, with <see cref="StrokeStart.Stipples"/>; 0 to 12; default 0.
        /// </summary>
        public int StartLevel { get; set; }

        /// <summary>
        /// Number of refinement steps of <see cref="Distribution.Published"/>; 0 to 12; default -1 = 4 for stipples, 3
        /// for strokes.  Each step makes five times as many stipples, or three times as many marks in each stroke.
        /// </summary>
        public int Levels { get; set; } = -1;

        /// <summary>
        /// Hatch: angle by which lines are turned in the tangent plane, counter-clockwise as seen from outside, in
        /// degrees; -360 to 360; default 0.
        /// </summary>
        public double Angle { get; set; }

        /// <summary>
        /// Hatch: length over which directions are smoothed, in diagonals; 1e-6 to 1; default 0.04.  Larger values give
        /// calmer lines that follow the form less.
        /// </summary>
        public double Smoothing { get; set; } = 0.04;

        /// <summary>
        /// Hatch: axis around which lines run where curvature has a low confidence; not 0; default (0, 1, 0).
        /// </summary>
        public Vector3d Axis { get; set; } = (0, 1, 0);

        /// <summary>
        /// Hatch: weight of the axis against curvature; 0 to 1000; default 0.06.  Larger values make more lines run
        /// around the axis.
        /// </summary>
        public double AxisWeight { get; set; } = 0.06;

        /// <summary>
        /// Length over which the normals that set the tone are averaged, in diagonals; 0 to 0.1; 0 = none; default -1 =
        /// 0.006 for blue-noise Hatch, 0 for others.  Larger values keep the grain of a rough surface out of the tone.
        /// </summary>
        public double ToneSmoothing { get; set; } = -1;

        /// <summary>
        /// Hatch: the directions that lines follow without a <see cref="DirectionFunction"/>; default Curvature.
        /// </summary>
        public HatchGuide Guide { get; set; }

        /// <summary>
        /// Hatch: direction to the light (Light) or to the eye (Silhouette), in the model's coordinates; not 0; default
        /// (0, 0, 1).
        /// </summary>
        public Vector3d GuideDirection { get; set; } = (0, 0, 1);

        /// <summary>Hatch: weight of a guide other than Curvature; curvature has the rest; 0 to 1; default 1.</summary>
        public double GuideWeight { get; set; } = 1;

        /// <summary>
        /// The library's function in place of <see cref="DensityFunction"/>, if a picture is painted; else null.
        /// </summary>
        internal NativeFunction NativeDensity { get; private set; }

        /// <summary>
        /// The library's function in place of <see cref="DirectionFunction"/>, if a picture is painted; else null.
        /// </summary>
        internal NativeFunction NativeDirection { get; private set; }

        /// <param name="desc">A descriptor of the library.</param>
        /// <param name="owner">The picture that it belongs to; null for a preset.</param>
        internal static unsafe Layer Read(hrbfnpr_layer_desc* desc, SafeHandle owner = null)
        {
            return new Layer((LayerKind)desc->kind)
            {
                Name = desc->name == IntPtr.Zero ? null : Errors.Utf8((byte*)desc->name),
                Budget = desc->budget,
                ToneBegin = desc->tone_begin,
                ToneEnd = desc->tone_end,
                SecondToneBegin = desc->second_tone_begin,
                SecondToneEnd = desc->second_tone_end,
                WithCurvature = (desc->flags & 1) != 0,
                Density = (Density)desc->density,
                DensityStrength = desc->density_strength,
                Separation = desc->separation,
                Step = desc->step,
                Start = (StrokeStart)desc->start,
                StartLevel = desc->start_level,
                Levels = desc->levels,
                Angle = desc->angle,
                Smoothing = desc->smoothing,
                Axis = *(Vector3d*)desc->axis,
                AxisWeight = desc->axis_weight,
                ToneSmoothing = desc->tone_smoothing,
                Guide = (HatchGuide)desc->guide,
                GuideDirection = *(Vector3d*)desc->guide_direction,
                GuideWeight = desc->guide_weight,
                DensityField = Field.Of(desc->density_field, FieldKind.Scalar, owner),
                DirectionField = Field.Of(desc->direction_field, FieldKind.Direction, owner),
                NativeDensity = NativeFunction.Of(desc->density_function, desc->density_user, owner),
                NativeDirection = NativeFunction.Of(desc->direction_function, desc->direction_user, owner),
            };
        }

        /// <summary>Writes everything except the functions.</summary>
        internal unsafe void Write(hrbfnpr_layer_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_layer_desc_init(desc, (uint)sizeof(hrbfnpr_layer_desc)));
            desc->kind = (uint)Kind;
            desc->name = pins.Text(Name);
            desc->budget = Budget;
            desc->tone_begin = ToneBegin;
            desc->tone_end = ToneEnd;
            desc->second_tone_begin = SecondToneBegin;
            desc->second_tone_end = SecondToneEnd;
            desc->flags = WithCurvature ? 1u : 0;
            desc->density = (uint)Density;
            desc->density_strength = DensityStrength;
            desc->separation = Separation;
            desc->step = Step;
            desc->start = (uint)Start;
            desc->start_level = StartLevel;
            desc->levels = Levels;
            desc->angle = Angle;
            desc->smoothing = Smoothing;
            *(Vector3d*)desc->axis = Axis;
            desc->axis_weight = AxisWeight;
            desc->tone_smoothing = ToneSmoothing;
            desc->guide = (uint)Guide;
            *(Vector3d*)desc->guide_direction = GuideDirection;
            desc->guide_weight = GuideWeight;
        }
    }

    /// <summary>A function of one call that fills an array from positions and normals.</summary>
    internal sealed unsafe class PlaceState : CallbackState
    {
        internal static readonly IntPtr Density;
        internal static readonly IntPtr Direction;
        private static readonly NativeCallbacks.Density DensityCallback = OnDensity;
        private static readonly NativeCallbacks.Direction DirectionCallback = OnDirection;
        private readonly DensityFunction density;
        private readonly DirectionFunction direction;

        static PlaceState()
        {
            Density = Marshal.GetFunctionPointerForDelegate(DensityCallback);
            Direction = Marshal.GetFunctionPointerForDelegate(DirectionCallback);
        }

        internal PlaceState(DensityFunction function)
        {
            density = function;
        }

        internal PlaceState(DirectionFunction function)
        {
            direction = function;
        }

        internal string Name
        {
            get { return density != null ? "density" : "direction"; }
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Density))]
        private static int OnDensity(IntPtr user, long count, double* positions, double* normals, double* density)
        {
            return From<PlaceState>(user).Call(count, positions, normals, density, 1);
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Direction))]
        private static int OnDirection(IntPtr user, long count, double* positions, double* normals, double* directions)
        {
            return From<PlaceState>(user).Call(count, positions, normals, directions, 3);
        }

        private int Call(long count, double* positions, double* normals, double* target, int components)
        {
            try
            {
                var places = new double[count * 3];
                var upward = new double[count * 3];
                var result = new double[count * components];
                Marshal.Copy((IntPtr)positions, places, 0, places.Length);
                Marshal.Copy((IntPtr)normals, upward, 0, upward.Length);
                if (density != null)
                {
                    density(places, upward, result);
                }
                else
                {
                    direction(places, upward, result);
                }
                Marshal.Copy(result, 0, (IntPtr)target, result.Length);
                return 0;
            }
            catch (Exception exception)
            {
                Keep(exception);
                return 1;
            }
        }
    }
}
