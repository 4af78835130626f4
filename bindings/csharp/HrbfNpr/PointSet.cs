// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.IO;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// A layer of ready-made marks for <c>PointSet.Create</c>.  Position and normal must be given; other arrays may be
    /// left out.
    /// </summary>
    public sealed class OwnLayer
    {
        /// <summary>Creates a layer without arrays.</summary>
        public OwnLayer()
        {
        }

        /// <summary>Creates a layer of marks or strokes.</summary>
        /// <param name="position">n absolute positions; float or double.</param>
        /// <param name="normal">n outward normals, of any length but 0; float or double.</param>
        /// <param name="strokeFirst">The strokes, as in <see cref="StrokeFirst"/>; not given = no strokes.</param>
        /// <param name="name">The name for styles; null = "own".</param>
        public OwnLayer(
            ArrayView position, ArrayView normal, ArrayView strokeFirst = default(ArrayView), string name = null)
        {
            Position = position;
            Normal = normal;
            StrokeFirst = strokeFirst;
            Name = name;
        }

        /// <summary>Kind of the marks, except Any; default Own.</summary>
        public LayerKind Kind { get; set; } = LayerKind.Own;

        /// <summary>Name for styles, 1 to 63 bytes of UTF-8; default null = that of the kind.</summary>
        public string Name { get; set; }

        /// <summary>n absolute positions; float or double.</summary>
        public ArrayView Position { get; set; }

        /// <summary>n outward normals, of any length but 0; float or double.</summary>
        public ArrayView Normal { get; set; }

        /// <summary>
        /// S + 1 uint that rise from 0 to n: stroke s has the marks first[s] to first[s + 1] - 1 from end to end;
        /// default not given = no strokes.
        /// </summary>
        public ArrayView StrokeFirst { get; set; }

        /// <summary>S bytes: 0 = the first direction, 1 = the second; default not given = 0.</summary>
        public ArrayView StrokeDirection { get; set; }

        /// <summary>
        /// n directions, of any length, not along the normal; float or double; default not given = along the stroke, or
        /// the u of the basis for a mark without a stroke.
        /// </summary>
        public ArrayView Direction { get; set; }

        /// <summary>n times k1, k2 and confidence; float or double; default not given = not known.</summary>
        public ArrayView Curvature { get; set; }

        /// <summary>
        /// n ranks in [0, 1); float or double; default not given = random, the same for all marks of a stroke.
        /// </summary>
        public ArrayView Rank { get; set; }

        /// <summary>n refinement steps, a byte each; default not given = 0.</summary>
        public ArrayView Level { get; set; }

        /// <summary>n widths in (0, 1]; float or double; default not given = 1.</summary>
        public ArrayView Width { get; set; }

        internal unsafe void Write(hrbfnpr_layer_arrays* arrays, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_layer_arrays_init(arrays, (uint)sizeof(hrbfnpr_layer_arrays)));
            arrays->kind = (uint)Kind;
            arrays->name = pins.Text(Name);
            arrays->position = Position.ToNative(pins, 3, nameof(Position));
            arrays->normal = Normal.ToNative(pins, 3, nameof(Normal));
            arrays->stroke_first = StrokeFirst.ToNative(pins, 1, nameof(StrokeFirst));
            arrays->stroke_direction = StrokeDirection.ToNative(pins, 1, nameof(StrokeDirection));
            arrays->direction = Direction.ToNative(pins, 3, nameof(Direction));
            arrays->curvature = Curvature.ToNative(pins, 3, nameof(Curvature));
            arrays->rank = Rank.ToNative(pins, 1, nameof(Rank));
            arrays->level = Level.ToNative(pins, 1, nameof(Level));
            arrays->width = Width.ToNative(pins, 1, nameof(Width));
        }
    }

    /// <summary>A set of marks on a surface, in layers: stipples, strokes, and marks of the program [NPAR 5].</summary>
    /// <remarks>
    /// A point set never changes, so several threads may use it at the same time.  A point set that is disposed of or
    /// finalised stays alive as long as other objects need it.  Positions are float, relative to
    /// <see cref="PointSetInfo.Origin"/>.
    /// </remarks>
    public sealed unsafe class PointSet : IDisposable
    {
        private readonly PointSetHandle handle;
        private ReadOnlyCollection<MarkLayer> layers;

        internal PointSet(PointSetHandle handle)
        {
            this.handle = handle;
        }

        /// <summary>What the point set holds, and how long it took to make.</summary>
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

        /// <summary>Number of marks in all layers.</summary>
        public long Count
        {
            get { return Info.Marks; }
        }

        /// <summary>The layers, by number.</summary>
        public IReadOnlyList<MarkLayer> Layers
        {
            get
            {
                if (layers == null)
                {
                    var made = new MarkLayer[Info.Layers];
                    for (int i = 0; i < made.Length; ++i)
                    {
                        made[i] = new MarkLayer(this, i);
                    }
                    layers = new ReadOnlyCollection<MarkLayer>(made); // two threads may make the list at the same time; either is right
                }
                return layers;
            }
        }

        /// <summary>The first layer with a name.</summary>
        /// <exception cref="KeyNotFoundException">No layer has the name.</exception>
        public MarkLayer this[string name]
        {
            get
            {
                foreach (MarkLayer layer in Layers)
                {
                    if (layer.Name == name)
                    {
                        return layer;
                    }
                }
                throw new KeyNotFoundException("the point set has no layer \"" + name + "\"");
            }
        }

        /// <summary>What became of the seeds.</summary>
        public PlacementInfo SeedPlacement
        {
            get
            {
                PlacementInfo info;
                Errors.Check(NativeMethods.hrbfnpr_placement_info_init(&info, (uint)sizeof(PlacementInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_point_set_get_seed_placement(handle, &info, &error), &error);
                return info;
            }
        }

        internal PointSetHandle Handle
        {
            get { return handle; }
        }

        /// <summary>Makes a point set from marks of the program, which are copied.</summary>
        /// <param name="layers">One or several layers.</param>
        /// <exception cref="InvalidArgumentException">There is no mark, or a number is wrong; the message names the
        /// layer, the array and the index.</exception>
        public static PointSet Create(params OwnLayer[] layers)
        {
            return Create(layers, null);
        }

        /// <summary>Makes a point set from the layers of another one, followed by layers of the program.</summary>
        /// <param name="basis">The point set whose layers come first; null = none.</param>
        /// <param name="layers">The layers that follow.</param>
        /// <exception cref="InvalidArgumentException">There is no mark, or a number is wrong; the message names the
        /// layer, the array and the index.</exception>
        public static PointSet Create(PointSet basis, params OwnLayer[] layers)
        {
            return Create(layers, basis);
        }

        /// <summary>
        /// Makes a point set from layers of the program, or from the layers of another one and layers of the program.
        /// </summary>
        /// <param name="layers">The layers that follow.</param>
        /// <param name="basis">The point set whose layers come first; null = none.</param>
        /// <param name="randomSeed">The start of the random numbers for ranks that are not given; any number.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="InvalidArgumentException">There is no mark, or a number is wrong; the message names the
        /// layer, the array and the index.</exception>
        public static PointSet Create(
            IReadOnlyList<OwnLayer> layers, PointSet basis, ulong randomSeed = 1, Context context = null)
        {
            if (layers == null)
            {
                throw new ArgumentNullException(nameof(layers));
            }
            context = Context.Resolve(context);
            hrbfnpr_point_set_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_point_set_desc_init(&desc, (uint)sizeof(hrbfnpr_point_set_desc)));
            desc.random_seed = randomSeed;
            using (var pins = new Pins())
            using (var held = new HeldHandles())
            {
                if (basis != null)
                {
                    desc.@base = held.Hold(basis.handle);
                }
                var arrays = new hrbfnpr_layer_arrays[layers.Count];
                var first = (hrbfnpr_layer_arrays*)pins.Pin(arrays);
                for (int i = 0; i < arrays.Length; ++i)
                {
                    OwnLayer layer = layers[i] ?? throw new ArgumentNullException(nameof(layers));
                    layer.Write(first + i, pins);
                }
                desc.layers = arrays.Length == 0 ? IntPtr.Zero : (IntPtr)first;
                desc.layer_count = arrays.Length;
                hrbfnpr_error error = Errors.New();
                var made = new PointSetHandle();
                int status = NativeMethods.hrbfnpr_point_set_create(
                    context.Handle, &desc, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                Errors.Check(status, &error);
                return new PointSet(made);
            }
        }

        /// <summary>The kinds of the fields of the set, by name.</summary>
        public IReadOnlyDictionary<string, FieldKind> Fields
        {
            get
            {
                var kinds = new Dictionary<string, FieldKind>();
                long count = Info.FieldCount;
                for (long i = 0; i < count; ++i)
                {
                    byte* name;
                    uint kind;
                    hrbfnpr_error error = Errors.New();
                    Errors.Check(
                        NativeMethods.hrbfnpr_point_set_get_field(handle, i, &name, &kind, &error), &error);
                    kinds.Add(Errors.Utf8(name), (FieldKind)kind);
                }
                return kinds;
            }
        }

        /// <summary>
        /// Makes a point set that has the same marks, which are shared, and values of fields for them.  Values of other
        /// names stay.  They are saved and loaded with the set.
        /// </summary>
        /// <param name="fields">The fields by the names for styles, of 1 to 63 bytes of UTF-8; null removes the values
        /// of a name.</param>
        /// <param name="transform">The matrix from the marks to the fields: 16 numbers, column-major, affine and
        /// invertible; null = the identity.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A name or the transform is wrong.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        /// <exception cref="CallbackException">The function of a field threw an exception.</exception>
        public PointSet WithFields(
            IReadOnlyDictionary<string, Field> fields, double[] transform = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            if (fields == null)
            {
                throw new ArgumentNullException(nameof(fields));
            }
            if (transform != null && transform.Length != 16)
            {
                throw new InvalidArgumentException("transform must have 16 numbers, not " + transform.Length);
            }
            context = Context.Resolve(context);
            var list = new hrbfnpr_mark_field[fields.Count];
            CallbackState function = null;
            using (var pins = new Pins())
            using (var held = new HeldHandles())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                IntPtr matrix = transform == null ? IntPtr.Zero : pins.Pin(transform);
                var first = (hrbfnpr_mark_field*)pins.Pin(list);
                int i = 0;
                foreach (KeyValuePair<string, Field> named in fields)
                {
                    hrbfnpr_mark_field* to = first + i++;
                    Errors.Check(NativeMethods.hrbfnpr_mark_field_init(to, (uint)sizeof(hrbfnpr_mark_field)));
                    to->name = pins.Text(named.Key);
                    to->field = named.Value == null ? IntPtr.Zero : held.Hold(named.Value.Handle);
                    to->transform = matrix;
                }
                hrbfnpr_error error = Errors.New();
                var made = new PointSetHandle();
                int status = NativeMethods.hrbfnpr_point_set_with_fields(
                    context.Handle, handle, list.Length == 0 ? null : first, list.Length, 0, call.Operation,
                    out IntPtr created, &error);
                made.Take(created, context.Anchor);
                foreach (Field field in fields.Values)
                {
                    function = field?.Function?.LastException != null ? field.Function : function;
                }
                try
                {
                    call.Check(status, &error, function);
                    return new PointSet(made);
                }
                catch
                {
                    made.Dispose();
                    throw;
                }
            }
        }

        /// <summary>Saves the point set.  The data has a version and a checksum.</summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
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

        /// <summary>Returns what <see cref="Save"/> writes.</summary>
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

        /// <summary>Loads a saved point set.</summary>
        /// <param name="stream">The stream, which is read on this thread, not beyond the point set's end, and is not
        /// closed.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="CorruptDataException">The data is not a saved point set, or is truncated or
        /// damaged.</exception>
        /// <exception cref="VersionMismatchException">A newer library wrote the data.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
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

        /// <summary>Loads a point set from the data that <see cref="ToBytes"/> returned.</summary>
        /// <param name="data">The whole data.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="CorruptDataException">The data is not a saved point set, or is truncated or
        /// damaged.</exception>
        /// <exception cref="VersionMismatchException">A newer library wrote the data.</exception>
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
        /// <summary>Loads a saved point set, like the other <c>Load</c>.</summary>
        /// <param name="data">The whole saved point set.</param>
        /// <param name="context">The context; null = the default context.</param>
        public static PointSet Load(ReadOnlySpan<byte> data, Context context = null)
        {
            fixed (byte* start = data)
            {
                return Load(start, data.Length, context);
            }
        }
#endif

        /// <summary>Releases the point set.  Objects that need it keep it alive.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }

        private static PointSet Load(byte* data, long size, Context context)
        {
            byte none;
            if (size == 0)
            {
                data = &none; // so that empty data is corrupt, not missing
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
    }
}
