// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>A density on the surface.</summary>
    /// <param name="positions">3 n numbers, absolute.</param>
    /// <param name="normals">3 n numbers, unit.</param>
    /// <param name="density">To be filled: n numbers, 1 where marks are to be densest, 0 where none are wanted.</param>
    public delegate void DensityFunction(double[] positions, double[] normals, double[] density);

    /// <summary>A field of directions on the surface.</summary>
    /// <param name="positions">3 n numbers, absolute.</param>
    /// <param name="normals">3 n numbers, unit.</param>
    /// <param name="directions">
    /// To be filled: 3 n numbers.  A direction is taken into the tangent plane; its sign and length count nothing, and
    /// 0, 0, 0 means that there is none.
    /// </param>
    public delegate void DirectionFunction(double[] positions, double[] normals, double[] directions);

    /// <summary>How one layer of marks is made.</summary>
    /// <remarks>
    /// The functions are called on the thread that generates, with some thousand places at a time; what they throw
    /// comes out in a <see cref="CallbackException"/>.
    /// </remarks>
    public sealed class Layer
    {
        /// <summary>The most marks where a layer names no number of its own.</summary>
        public const long DefaultBudget = 40000;

        /// <summary>A layer with all defaults of its kind.</summary>
        /// <param name="kind">Stipples or Hatch.</param>
        public Layer(LayerKind kind = LayerKind.Stipples)
        {
            Kind = kind;
        }

        /// <summary>A layer of scattered marks.</summary>
        /// <param name="budget">The most marks.</param>
        /// <param name="name">"stipples" if null.</param>
        public static Layer Stipples(long budget = DefaultBudget, string name = null)
        {
            return new Layer(LayerKind.Stipples) { Budget = budget, Name = name };
        }

        /// <summary>
        /// A layer of evenly spaced, nested lines along one smooth field of directions; with
        /// <see cref="Distribution.Published"/> of strokes in both directions.
        /// </summary>
        /// <param name="separation">Of all lines together, in the unit of the model; 0 = by the budget.</param>
        /// <param name="angle">By which lines are turned in the tangent plane; degrees.</param>
        /// <param name="name">"hatch" if null.</param>
        /// <param name="budget">The most marks; null: 40000, or no limit with a separation.</param>
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

        /// <summary>What its marks are.</summary>
        public LayerKind Kind { get; set; }

        /// <summary>1 to 63 bytes of UTF-8; the kind's name if null.</summary>
        public string Name { get; set; }

        /// <summary>
        /// The most marks; 40000.  0 = no limit, with <see cref="Distribution.Published"/> and for lines with a
        /// separation.
        /// </summary>
        public long Budget { get; set; } = DefaultBudget;

        /// <summary>
        /// The darkness 1 - tau at which the first mark is shown (of published strokes: of the first direction), 0 to 1.  Both 0
        /// (default): as <see cref="GenerateOptions.ToneRanges"/> says.
        /// </summary>
        public float ToneBegin { get; set; }

        /// <summary>... and that at which all are shown.</summary>
        public float ToneEnd { get; set; }

        /// <summary>As <see cref="ToneBegin"/>, for published strokes of the second direction.</summary>
        public float SecondToneBegin { get; set; }

        /// <summary>As <see cref="ToneEnd"/>, for published strokes of the second direction.</summary>
        public float SecondToneEnd { get; set; }

        /// <summary>Whether marks get curvatures; published strokes along curvature always do.</summary>
        public bool WithCurvature { get; set; }

        /// <summary>How dense blue-noise stipples are over the surface.</summary>
        public Density Density { get; set; }

        /// <summary>Of <see cref="HrbfNpr.Density.Curvature"/>, 0 to 1; 0.5.</summary>
        public double DensityStrength { get; set; } = 0.5;

        /// <summary>For <see cref="HrbfNpr.Density.Callback"/>.</summary>
        public DensityFunction DensityFunction { get; set; }

        /// <summary>
        /// Of Hatch: mean distance of neighbouring lines, in the unit of the model; 0 = as many lines as make about the
        /// budget's marks.
        /// </summary>
        public double Separation { get; set; }

        /// <summary>Distance of the marks of a line; 0 = 0.4 of the separation.</summary>
        public double Step { get; set; }

        /// <summary>Of Hatch: what lines follow, in place of <see cref="Guide"/>.</summary>
        public DirectionFunction DirectionFunction { get; set; }

        /// <summary>What strokes of <see cref="Distribution.Published"/> start from.</summary>
        public StrokeStart Start { get; set; }

        /// <summary>With Stipples, the last stippling level used; 0.</summary>
        public int StartLevel { get; set; }

        /// <summary>
        /// Refinement steps of <see cref="Distribution.Published"/>, 0 to 12; -1 = 4 for stipples, 3 for strokes.
        /// </summary>
        public int Levels { get; set; } = -1;

        /// <summary>
        /// Of Hatch: by which lines are turned in the tangent plane, counter-clockwise as seen from outside; degrees.
        /// </summary>
        public double Angle { get; set; }

        /// <summary>Of Hatch: over so long a way directions are smoothed; diagonals, 1 at most; 0.04.</summary>
        public double Smoothing { get; set; } = 0.04;

        /// <summary>Of Hatch: where curvature says little lines run around this; (0, 1, 0).</summary>
        public Vector3d Axis { get; set; } = (0, 1, 0);

        /// <summary>Of Hatch: how much the axis counts against curvature; 0.06.</summary>
        public double AxisWeight { get; set; } = 0.06;

        /// <summary>
        /// Over so much of the surface the normals that tone goes by are averaged, so that the grain of a rough one
        /// makes no islands of light; diagonals, 0.1 at most, 0 = not; -1 = 0.006 for blue-noise Hatch, 0 for others.
        /// </summary>
        public double ToneSmoothing { get; set; } = -1;

        /// <summary>Of Hatch: what lines follow where there is no <see cref="DirectionFunction"/>.</summary>
        public HatchGuide Guide { get; set; }

        /// <summary>Of Hatch: towards the light, or the eye, of a guide that asks for it; (0, 0, 1).</summary>
        public Vector3d GuideDirection { get; set; } = (0, 0, 1);

        /// <summary>Of Hatch: of a guide other than Curvature; what is left of 1 is curvature's; 1.</summary>
        public double GuideWeight { get; set; } = 1;

        /// <summary>
        /// The library's own function in place of <see cref="DensityFunction"/>, where a picture is painted; else null.
        /// </summary>
        internal NativeFunction NativeDensity { get; private set; }

        /// <summary>
        /// The library's own function in place of <see cref="DirectionFunction"/>, where a picture is painted; else null.
        /// </summary>
        internal NativeFunction NativeDirection { get; private set; }

        /// <param name="desc">A struct of the library's.</param>
        /// <param name="owner">The picture that it belongs to; null of a preset.</param>
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
                NativeDensity = NativeFunction.Of(desc->density_function, desc->density_user, owner),
                NativeDirection = NativeFunction.Of(desc->direction_function, desc->direction_user, owner),
            };
        }

        /// <summary>Everything but the functions.</summary>
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

    /// <summary>A function of one call that fills an array from places and normals.</summary>
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
