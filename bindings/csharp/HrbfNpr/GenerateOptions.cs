// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>How marks are placed on a surface; a new one holds all defaults.</summary>
    /// <example>
    /// <code>
    /// model.Generate(new GenerateOptions { Layers = { Layer.Stipples(), Layer.Hatch(budget: 60000) } });
    /// model.Generate(GenerateOptions.ForPreset(Preset.Full));
    /// </code>
    /// </example>
    public sealed class GenerateOptions
    {
        /// <summary>The layers to make, in this order; default empty = one layer of stipples.</summary>
        public IList<Layer> Layers { get; } = new List<Layer>();

        /// <summary>How marks are distributed; default BlueNoise.</summary>
        public Distribution Distribution { get; set; }

        /// <summary>
        /// Largest number of marks of all layers together, which they share in proportion to their tone ranges; 0 or
        /// more; default 0 = each layer has its own budget.
        /// </summary>
        public long SharedBudget { get; set; }

        /// <summary>The tones in which layers appear; default Full.</summary>
        public ToneRanges ToneRanges { get; set; }

        /// <summary>The seeds from which marks start; default Auto.</summary>
        public SeedSource SeedSource { get; set; }

        /// <summary>
        /// The seeds of <see cref="HrbfNpr.SeedSource.Points"/>: n points, float or double, within 1e4 diagonals of the
        /// bounds.
        /// </summary>
        public ArrayView SeedPoints { get; set; }

        /// <summary>
        /// Number of cells of the box along the longest side of the bounds; 1 to 256; default 8 [NPAR 4.2].  More cells
        /// give more seeds and miss fewer sheets.
        /// </summary>
        public int BoxResolution { get; set; } = 8;

        /// <summary>
        /// Largest random shift of the grid points of the box, in cell sides; 0 to 0.5; default 0.25.
        /// </summary>
        public double BoxJitter { get; set; } = 0.25;

        /// <summary>
        /// rho_0: first step of <see cref="Distribution.Published"/>, in the unit of the samples; 1e-12 to 1e9
        /// diagonals; default 0 = estimated from the seeds [NPAR 5.1].
        /// </summary>
        public double InitialStep { get; set; }

        /// <summary>
        /// Largest distance of a mark from the surface, as <see cref="ProjectOptions.Tolerance"/>, in diagonals; above
        /// 0; default 1e-7.
        /// </summary>
        public double ProjectionTolerance { get; set; } = 1e-7;

        /// <summary>Start of the random numbers; any number; default 1.  Another number gives other marks.</summary>
        public ulong RandomSeed { get; set; } = 1;

        /// <summary>Makes the options for the layers that a preset draws.</summary>
        /// <param name="preset">The preset, as for <see cref="Style.Preset"/>.</param>
        /// <param name="budget">The largest number of marks of each layer.</param>
        /// <exception cref="InvalidArgumentException">There is no such preset.</exception>
        public static unsafe GenerateOptions ForPreset(Preset preset, long budget = Layer.DefaultBudget)
        {
            long count;
            hrbfnpr_layer_desc* layers = NativeMethods.hrbfnpr_preset_layers(unchecked((uint)preset), &count);
            if (layers == null)
            {
                throw new InvalidArgumentException("there is no preset " + (int)preset + "; use a value of Preset");
            }
            var options = new GenerateOptions();
            for (long i = 0; i < count; ++i)
            {
                Layer layer = Layer.Read((hrbfnpr_layer_desc*)((byte*)layers + i * layers->struct_size));
                layer.Budget = budget;
                options.Layers.Add(layer);
            }
            return options;
        }

        /// <param name="desc">A descriptor that belongs to a picture.</param>
        /// <param name="owner">The picture.</param>
        internal static unsafe GenerateOptions Read(hrbfnpr_generate_desc* desc, SafeHandle owner)
        {
            var options = new GenerateOptions
            {
                Distribution = (Distribution)desc->distribution,
                SharedBudget = desc->shared_budget,
                ToneRanges = (ToneRanges)desc->tone_ranges,
                SeedSource = (SeedSource)desc->seed_source,
                BoxJitter = desc->box_jitter,
                BoxResolution = (int)desc->box_resolution,
                InitialStep = desc->initial_step,
                ProjectionTolerance = desc->projection_tolerance,
                RandomSeed = desc->random_seed,
            };
            if (desc->seed_points.count > 0)
            {
                var seeds = new double[3 * desc->seed_points.count];
                Marshal.Copy(desc->seed_points.data, seeds, 0, seeds.Length);
                options.SeedPoints = seeds;
            }
            byte* layer = (byte*)desc->layers;
            for (long i = 0; i < desc->layer_count; ++i)
            {
                options.Layers.Add(Layer.Read((hrbfnpr_layer_desc*)layer, owner));
                long stride = desc->layer_stride;
                layer += stride != 0 ? stride : ((hrbfnpr_layer_desc*)desc->layers)->struct_size;
            }
            return options;
        }
    }

    /// <summary>The descriptor of one call, and everything that it points to.</summary>
    internal sealed unsafe class GenerateCall : IDisposable
    {
        internal hrbfnpr_generate_desc Desc;
        private readonly Pins pins = new Pins();
        private readonly HeldHandles held = new HeldHandles();
        private readonly List<PlaceState> states = new List<PlaceState>();
        private readonly List<UserHandle> users = new List<UserHandle>();
        private readonly List<CallbackState> functions = new List<CallbackState>(); // fields without a function have null

        internal GenerateCall(GenerateOptions options)
        {
            try
            {
                Describe(options ?? new GenerateOptions());
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public void Dispose()
        {
            pins.Dispose();
            held.Dispose();
            foreach (UserHandle user in users)
            {
                user.Dispose();
            }
            users.Clear();
        }

        /// <summary>Throws what a function of the program threw, or the failure of the call.</summary>
        internal void Check(LongCall call, int status, hrbfnpr_error* error, Model model)
        {
            foreach (PlaceState state in states)
            {
                Exception thrown = state.TakeException();
                if (thrown != null)
                {
                    throw new CallbackException("the " + state.Name + " function threw: " + thrown.Message, thrown);
                }
            }
            foreach (CallbackState function in functions)
            {
                if (status != 0 && function?.LastException != null)
                {
                    call.Check(status, error, function);
                }
            }
            call.Check(status, error, model.Function);
        }

        private void Describe(GenerateOptions options)
        {
            fixed (hrbfnpr_generate_desc* desc = &Desc)
            {
                Errors.Check(NativeMethods.hrbfnpr_generate_desc_init(desc, (uint)sizeof(hrbfnpr_generate_desc)));
            }
            Desc.distribution = (uint)options.Distribution;
            Desc.shared_budget = options.SharedBudget;
            Desc.tone_ranges = (uint)options.ToneRanges;
            Desc.seed_source = (uint)options.SeedSource;
            Desc.seed_points = options.SeedPoints.ToNative(pins, 3, nameof(options.SeedPoints));
            Desc.box_jitter = options.BoxJitter;
            Desc.box_resolution = unchecked((uint)options.BoxResolution);
            Desc.initial_step = options.InitialStep;
            Desc.projection_tolerance = options.ProjectionTolerance;
            Desc.random_seed = options.RandomSeed;
            if (options.Layers.Count == 0)
            {
                return;
            }
            var layers = new hrbfnpr_layer_desc[options.Layers.Count];
            var first = (hrbfnpr_layer_desc*)pins.Pin(layers);
            for (int i = 0; i < layers.Length; ++i)
            {
                Layer layer = options.Layers[i] ?? throw new ArgumentNullException(nameof(options.Layers));
                layer.Write(first + i, pins);
                Use(layer, first + i);
                if (layer.DensityFunction != null)
                {
                    first[i].density_function = PlaceState.Density;
                    first[i].density_user = Add(new PlaceState(layer.DensityFunction));
                }
                else if (layer.NativeDensity != null)
                {
                    first[i].density_function = layer.NativeDensity.Function;
                    first[i].density_user = layer.NativeDensity.Hold(held);
                }
                if (layer.DirectionFunction != null)
                {
                    first[i].direction_function = PlaceState.Direction;
                    first[i].direction_user = Add(new PlaceState(layer.DirectionFunction));
                }
                else if (layer.NativeDirection != null)
                {
                    first[i].direction_function = layer.NativeDirection.Function;
                    first[i].direction_user = layer.NativeDirection.Hold(held);
                }
            }
            Desc.layers = (IntPtr)first;
            Desc.layer_count = layers.Length;
        }

        private void Use(Layer layer, hrbfnpr_layer_desc* desc)
        {
            if (layer.DensityField != null)
            {
                desc->density_field = held.Hold(layer.DensityField.Handle);
                functions.Add(layer.DensityField.Function);
            }
            if (layer.DirectionField != null)
            {
                desc->direction_field = held.Hold(layer.DirectionField.Handle);
                functions.Add(layer.DirectionField.Function);
            }
        }

        private IntPtr Add(PlaceState state)
        {
            states.Add(state);
            users.Add(new UserHandle(state));
            return users[users.Count - 1].Pointer;
        }
    }
}
