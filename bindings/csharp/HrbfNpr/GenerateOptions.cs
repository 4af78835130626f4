using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>A density on the surface.</summary>
    /// <param name="positions">3 n numbers, absolute.</param>
    /// <param name="normals">3 n numbers, unit.</param>
    /// <param name="density">To be filled: n numbers, 1 where marks are to be densest, 0 where none are wanted.</param>
    public delegate void DensityFunction(double[] positions, double[] normals, double[] density);

    /// <summary>How one group of marks grows.</summary>
    public sealed class GroupOptions
    {
        /// <summary>Refinement steps of <see cref="Distribution.Paper"/>, 0 to 12; stipples 4, strokes 3.</summary>
        public int Levels { get; set; }

        /// <summary>What strokes of <see cref="Distribution.Paper"/> start from; not for stipples.</summary>
        public StrokeSeeds Seeds { get; set; }

        /// <summary>With Stipples, the last stippling level used; 0.</summary>
        public int SeedLevel { get; set; }

        /// <summary>
        /// The most marks, of both sets of strokes together; 0 (default) = 40000, or no limit with
        /// <see cref="Distribution.Paper"/> and for strokes with a separation.
        /// </summary>
        public long Budget { get; set; }

        internal hrbfnpr_group_desc ToNative()
        {
            return new hrbfnpr_group_desc
            {
                levels = Levels,
                seeds = (uint)Seeds,
                seed_level = SeedLevel,
                budget = Budget,
            };
        }
    }

    /// <summary>How marks are placed on a surface; a new one holds all defaults.</summary>
    public sealed class GenerateOptions
    {
        private readonly float[] begins = new float[5];
        private readonly float[] ends = new float[5];

        /// <summary>The groups to make; stipples only.  A style says which it needs: <see cref="Style.Groups"/>.</summary>
        public Groups Groups { get; set; } = Groups.Stipple;

        /// <summary>How marks are spread.</summary>
        public Distribution Distribution { get; set; }

        /// <summary>Where marks start from.</summary>
        public SeedSource SeedSource { get; set; }

        /// <summary>For <see cref="HrbfNpr.SeedSource.Points"/>: n points, float or double.</summary>
        public ArrayView SeedPoints { get; set; }

        /// <summary>Cells along the box's longest side, 1 to 256; 8 [NPAR 4.2].</summary>
        public int BoxResolution { get; set; } = 8;

        /// <summary>Jitter of the box's seeds in cell sides, 0 to 0.5; 0.25.</summary>
        public double BoxJitter { get; set; } = 0.25;

        /// <summary>rho_0 of <see cref="Distribution.Paper"/>, in the unit of the model; 0 = estimated [NPAR 5.1].</summary>
        public double InitialStep { get; set; }

        /// <summary>As <see cref="ProjectOptions.Tolerance"/>; 1e-7.</summary>
        public double ProjectionTolerance { get; set; } = 1e-7;

        /// <summary>Any number; 1.</summary>
        public ulong RandomSeed { get; set; } = 1;

        /// <summary>Whether stipples get curvatures too; false.</summary>
        public bool CurvatureOfStipples { get; set; }

        /// <summary>Whether combing marks get curvatures too; false.</summary>
        public bool CurvatureOfCombing { get; set; }

        /// <summary>The stipples.</summary>
        public GroupOptions Stipple { get; } = new GroupOptions { Levels = 4 };

        /// <summary>The strokes along principal directions.</summary>
        public GroupOptions Curvature { get; } = new GroupOptions { Levels = 3 };

        /// <summary>The combing strokes.</summary>
        public GroupOptions Combing { get; } = new GroupOptions { Levels = 3 };

        /// <summary>Sets the budget of all three groups.</summary>
        public long Budget
        {
            set
            {
                Stipple.Budget = value;
                Curvature.Budget = value;
                Combing.Budget = value;
            }
        }

        /// <summary>
        /// Mean distance of neighbouring blue-noise strokes of one set, in the unit of the model; 0 = such that they
        /// have as many marks as the budget.
        /// </summary>
        public double StrokeSeparation { get; set; }

        /// <summary>Distance of the marks of such a stroke; 0 = a fifth of the separation.</summary>
        public double StrokeStep { get; set; }

        /// <summary>The longest such stroke; 0 = no limit.</summary>
        public double StrokeLength { get; set; }

        /// <summary>Whether such strokes go straight on where directions change places, or turn.</summary>
        public StrokeField StrokeField { get; set; } = StrokeField.Cross;

        /// <summary>How dense blue-noise stipples are over the surface.</summary>
        public Density Density { get; set; }

        /// <summary>Of <see cref="HrbfNpr.Density.Curvature"/>, 0 to 1; 0.5.</summary>
        public double DensityStrength { get; set; } = 0.5;

        /// <summary>
        /// For <see cref="HrbfNpr.Density.Callback"/>; called on the thread that generates.  What it throws comes out
        /// in a <see cref="CallbackException"/>.
        /// </summary>
        public DensityFunction DensityFunction { get; set; }

        /// <summary>In which order layers appear from light to dark.</summary>
        public LayerOrder Order { get; set; }

        /// <summary>The most marks of all groups together; 0 = each has its own budget (default).</summary>
        public long SharedBudget { get; set; }

        /// <summary>
        /// The darkness 1 - tau at which the first mark of a layer is shown, and that at which all are: 0 to 1, both 0
        /// (default) = as <see cref="Order"/> says.
        /// </summary>
        public void SetLayer(Layer layer, float begin, float end)
        {
            begins[(int)layer] = begin;
            ends[(int)layer] = end;
        }

        internal unsafe void Write(hrbfnpr_generate_desc* desc, Pins pins, DensityState density, UserHandle user)
        {
            desc->groups = (uint)Groups;
            desc->distribution = (uint)Distribution;
            desc->seed_source = (uint)SeedSource;
            desc->flags = (CurvatureOfStipples ? 1u : 0) | (CurvatureOfCombing ? 2u : 0);
            desc->box_resolution = unchecked((uint)BoxResolution);
            desc->box_jitter = BoxJitter;
            desc->initial_step = InitialStep;
            desc->projection_tolerance = ProjectionTolerance;
            desc->random_seed = RandomSeed;
            desc->seed_points = SeedPoints.ToNative(pins, 3, nameof(SeedPoints));
            desc->group0 = Stipple.ToNative();
            desc->group1 = Curvature.ToNative();
            desc->group2 = Combing.ToNative();
            desc->stroke_separation = StrokeSeparation;
            desc->stroke_step = StrokeStep;
            desc->stroke_length = StrokeLength;
            desc->stroke_field = (uint)StrokeField;
            desc->density = (uint)Density;
            desc->density_strength = DensityStrength;
            if (density != null)
            {
                desc->density_function = DensityState.Function;
                desc->density_user = user.Pointer;
            }
            desc->order = (uint)Order;
            desc->shared_budget = SharedBudget;
            hrbfnpr_layer* layer = &desc->layer0;
            for (int i = 0; i < begins.Length; ++i)
            {
                layer[i].begin = begins[i];
                layer[i].end = ends[i];
            }
        }
    }

    /// <summary>The density function of one call.</summary>
    internal sealed unsafe class DensityState : CallbackState
    {
        internal static readonly IntPtr Function;
        private static readonly NativeCallbacks.Density FunctionCallback = OnDensity;
        private readonly DensityFunction function;

        static DensityState()
        {
            Function = Marshal.GetFunctionPointerForDelegate(FunctionCallback);
        }

        internal DensityState(DensityFunction function)
        {
            this.function = function;
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Density))]
        private static int OnDensity(IntPtr user, long count, double* positions, double* normals, double* density)
        {
            var state = From<DensityState>(user);
            try
            {
                var places = new double[count * 3];
                var directions = new double[count * 3];
                var result = new double[count];
                Marshal.Copy((IntPtr)positions, places, 0, places.Length);
                Marshal.Copy((IntPtr)normals, directions, 0, directions.Length);
                state.function(places, directions, result);
                Marshal.Copy(result, 0, (IntPtr)density, result.Length);
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
