using System;
using System.IO;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// One group of ready-made marks for <see cref="PointSet.FromArrays"/>: position and normal are needed.
    /// </summary>
    public sealed class GroupArrays
    {
        /// <summary>n points, absolute; float or double.</summary>
        public ArrayView Position { get; set; }

        /// <summary>n unit normals; float or double.</summary>
        public ArrayView Normal { get; set; }

        /// <summary>n unit tangents; by default the stipple's basis.</summary>
        public ArrayView Direction { get; set; }

        /// <summary>n times k1, k2, confidence; absent by default.</summary>
        public ArrayView Curvature { get; set; }

        /// <summary>n numbers in [0, 1); random by default.</summary>
        public ArrayView Rank { get; set; }

        /// <summary>n bytes; 0 by default.</summary>
        public ArrayView Level { get; set; }

        /// <summary>n pairs of uint; one stroke for each mark by default.</summary>
        public ArrayView Stroke { get; set; }

        /// <summary>n numbers in (0, 1]; 1 by default.</summary>
        public ArrayView Width { get; set; }

        internal hrbfnpr_group_arrays ToNative(Pins pins)
        {
            return new hrbfnpr_group_arrays
            {
                position = Position.ToNative(pins, 3, nameof(Position)),
                normal = Normal.ToNative(pins, 3, nameof(Normal)),
                direction = Direction.ToNative(pins, 3, nameof(Direction)),
                curvature = Curvature.ToNative(pins, 3, nameof(Curvature)),
                rank = Rank.ToNative(pins, 1, nameof(Rank)),
                level = Level.ToNative(pins, 1, nameof(Level)),
                stroke = Stroke.ToNative(pins, 2, nameof(Stroke)),
                width = Width.ToNative(pins, 1, nameof(Width)),
            };
        }
    }

    /// <summary>Result of <see cref="PointSet.StepPatches"/>.</summary>
    public sealed class StepPatches
    {
        internal StepPatches(double[] corners, double step)
        {
            Corners = corners;
            Step = step;
        }

        /// <summary>Four corners of each patch, counter-clockwise seen from outside: 12 n numbers, absolute.</summary>
        public double[] Corners { get; }

        /// <summary>The initial step.</summary>
        public double Step { get; }
    }

    /// <summary>Marks on a surface: stipples, and strokes along principal or combed directions [NPAR 5].</summary>
    /// <remarks>
    /// Immutable: any number of threads may use a set at a time.  A set that is disposed of or finalised goes on
    /// living where it is still needed.  Positions are float, relative to <see cref="PointSetInfo.Origin"/>.
    /// </remarks>
    public sealed unsafe class PointSet : IDisposable
    {
        private readonly PointSetHandle handle;

        private PointSet(PointSetHandle handle)
        {
            this.handle = handle;
        }

        /// <summary>Counts, steps and seconds, per group and level.</summary>
        public PointSetInfo Info
        {
            get
            {
                PointSetInfo info;
                Errors.Check(NativeMethods.hrbfnpr_point_set_info_init(&info, (uint)sizeof(PointSetInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_point_set_get_info(handle, &info, &error), &error);
                return info;
            }
        }

        /// <summary>Marks in all groups.</summary>
        public long Count
        {
            get { return Info.Count; }
        }

        internal PointSetHandle Handle
        {
            get { return handle; }
        }

        /// <summary>Places marks on the surface of a model.</summary>
        /// <param name="model">The surface.</param>
        /// <param name="options">All defaults, stipples, if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null; called on this thread with a number in [0, 1].</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or does not go with another.</exception>
        /// <exception cref="NotConvergedException">All seeds were dropped.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        /// <exception cref="CallbackException">A function of the program threw.</exception>
        public static PointSet Generate(
            Model model, GenerateOptions options = null, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            if (model == null)
            {
                throw new ArgumentNullException(nameof(model));
            }
            context = Context.Resolve(context);
            options = options ?? new GenerateOptions();
            DensityState density = options.DensityFunction == null ? null : new DensityState(options.DensityFunction);
            using (var pins = new Pins())
            using (var user = new UserHandle(density))
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_generate_desc desc = Describe(options, pins, density, user);
                hrbfnpr_error error = Errors.New();
                var made = new PointSetHandle();
                int status = NativeMethods.hrbfnpr_point_set_generate(
                    context.Handle, model.Handle, &desc, call.Operation, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                try
                {
                    Check(call, status, &error, density, model);
                    return new PointSet(made);
                }
                catch
                {
                    made.Dispose();
                    throw;
                }
            }
        }

        /// <summary>Marks from arrays, which are copied.</summary>
        /// <param name="stipple">Null for none.</param>
        /// <param name="curvature">Null for none.</param>
        /// <param name="combing">Null for none.</param>
        /// <param name="randomSeed">For ranks that are not given.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="InvalidArgumentException">The message names the array and the index.</exception>
        public static PointSet FromArrays(
            GroupArrays stipple, GroupArrays curvature = null, GroupArrays combing = null, ulong randomSeed = 1,
            Context context = null)
        {
            context = Context.Resolve(context);
            hrbfnpr_point_set_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_point_set_desc_init(&desc, (uint)sizeof(hrbfnpr_point_set_desc)));
            desc.random_seed = randomSeed;
            using (var pins = new Pins())
            {
                desc.group0 = (stipple ?? new GroupArrays()).ToNative(pins);
                desc.group1 = (curvature ?? new GroupArrays()).ToNative(pins);
                desc.group2 = (combing ?? new GroupArrays()).ToNative(pins);
                hrbfnpr_error error = Errors.New();
                var made = new PointSetHandle();
                int status = NativeMethods.hrbfnpr_point_set_create_from_arrays(
                    context.Handle, &desc, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                Errors.Check(status, &error);
                return new PointSet(made);
            }
        }

        /// <summary>The visual feedback for choosing the initial step [NPAR 5.1, Figure 5].</summary>
        /// <param name="model">The surface.</param>
        /// <param name="count">Squares of side 2 steps, in tangent planes of random seeds.</param>
        /// <param name="options">As for <see cref="Generate"/>, whose seeds and estimate they are.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        public static StepPatches StepPatches(
            Model model, int count, GenerateOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            if (model == null)
            {
                throw new ArgumentNullException(nameof(model));
            }
            context = Context.Resolve(context);
            options = options ?? new GenerateOptions();
            DensityState density = options.DensityFunction == null ? null : new DensityState(options.DensityFunction);
            var corners = new double[count * 12];
            double step;
            using (var pins = new Pins())
            using (var user = new UserHandle(density))
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_generate_desc desc = Describe(options, pins, density, user);
                hrbfnpr_array target = ((ArrayView)corners).ToNative(pins, 12, nameof(corners));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_point_set_step_patches(
                    context.Handle, model.Handle, &desc, &target, &step, call.Operation, &error);
                Check(call, status, &error, density, model);
            }
            return new StepPatches(corners, step);
        }

        /// <summary>One attribute of one group, in the set's own memory, without a copy.</summary>
        /// <remarks>Empty for an empty group, and for curvatures or widths where there are none.</remarks>
        public NativeView View(Group group, MarkAttribute attribute)
        {
            hrbfnpr_array view;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_point_set_view(handle, (uint)group, (uint)attribute, &view, &error), &error);
            return new NativeView(handle.Share(), view);
        }

        /// <summary>A copy of an attribute of float numbers.</summary>
        public float[] Floats(Group group, MarkAttribute attribute)
        {
            using (NativeView view = View(group, attribute))
            {
                return view.ToArray<float>();
            }
        }

        /// <summary>A copy of the positions, 3 n numbers, relative to <see cref="PointSetInfo.Origin"/>.</summary>
        public float[] Positions(Group group)
        {
            return Floats(group, MarkAttribute.Position);
        }

        /// <summary>A copy of the unit normals, 3 n numbers.</summary>
        public float[] Normals(Group group)
        {
            return Floats(group, MarkAttribute.Normal);
        }

        /// <summary>Saves the set; the data is versioned and checksummed.</summary>
        /// <param name="stream">Written to on this thread, and not closed.</param>
        /// <exception cref="StreamException">The stream failed.</exception>
        public void Save(Stream stream)
        {
            var state = new StreamState(stream);
            using (var user = new UserHandle(state))
            {
                hrbfnpr_error error = Errors.New();
                state.Check(
                    NativeMethods.hrbfnpr_point_set_save(handle, StreamState.Write, user.Pointer, &error), &error);
            }
        }

        /// <summary>What <see cref="Save"/> writes.</summary>
        public byte[] ToBytes()
        {
            long size = 0;
            hrbfnpr_error error = Errors.New();
            int status = NativeMethods.hrbfnpr_point_set_save_memory(handle, null, 0, &size, &error);
            if (status != (int)Status.BufferTooSmall)
            {
                Errors.Check(status, &error);
            }
            var data = new byte[size];
            fixed (byte* destination = data)
            {
                Errors.Check(
                    NativeMethods.hrbfnpr_point_set_save_memory(handle, destination, size, &size, &error), &error);
            }
            return data;
        }

        /// <summary>Loads a saved set.</summary>
        /// <param name="stream">Read from on this thread, not beyond the set's end, and not closed.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="CorruptDataException">It is not a saved set, or is cut short or damaged.</exception>
        /// <exception cref="VersionMismatchException">It was written by a newer library.</exception>
        /// <exception cref="StreamException">The stream failed.</exception>
        public static PointSet Load(Stream stream, Context context = null)
        {
            context = Context.Resolve(context);
            var state = new StreamState(stream);
            using (var user = new UserHandle(state))
            {
                hrbfnpr_error error = Errors.New();
                var made = new PointSetHandle();
                int status = NativeMethods.hrbfnpr_point_set_load(
                    context.Handle, StreamState.Read, user.Pointer, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                state.Check(status, &error);
                return new PointSet(made);
            }
        }

        /// <summary>Loads what <see cref="ToBytes"/> returned.</summary>
        /// <param name="data">All of it.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="CorruptDataException">It is not a saved set, or is cut short or damaged.</exception>
        /// <exception cref="VersionMismatchException">It was written by a newer library.</exception>
        public static PointSet Load(byte[] data, Context context = null)
        {
            if (data == null)
            {
                throw new ArgumentNullException(nameof(data));
            }
            fixed (byte* start = data)
            {
                return Load(start, data.LongLength, context);
            }
        }

#if NET7_0_OR_GREATER
        /// <summary>As the other <c>Load</c>.</summary>
        /// <param name="data">All of a saved set.</param>
        /// <param name="context">The default context if null.</param>
        public static PointSet Load(ReadOnlySpan<byte> data, Context context = null)
        {
            fixed (byte* start = data)
            {
                return Load(start, data.Length, context);
            }
        }
#endif

        /// <summary>Lets go of the set; what still needs it keeps it alive.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }

        private static PointSet Load(byte* data, long size, Context context)
        {
            byte none;
            if (size == 0)
            {
                data = &none; // empty data is corrupt, not missing
            }
            context = Context.Resolve(context);
            hrbfnpr_error error = Errors.New();
            var made = new PointSetHandle();
            int status = NativeMethods.hrbfnpr_point_set_load_memory(
                context.Handle, data, size, out IntPtr created, &error);
            made.Take(created, context.Anchor);
            Errors.Check(status, &error);
            return new PointSet(made);
        }

        private static hrbfnpr_generate_desc Describe(
            GenerateOptions options, Pins pins, DensityState density, UserHandle user)
        {
            hrbfnpr_generate_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_generate_desc_init(&desc, (uint)sizeof(hrbfnpr_generate_desc)));
            options.Write(&desc, pins, density, user);
            return desc;
        }

        private static void Check(
            LongCall call, int status, hrbfnpr_error* error, DensityState density, Model model)
        {
            Exception thrown = density == null ? null : density.TakeException();
            if (thrown != null)
            {
                throw new CallbackException("the density function threw: " + thrown.Message, thrown);
            }
            call.Check(status, error, model.Function);
        }
    }
}
