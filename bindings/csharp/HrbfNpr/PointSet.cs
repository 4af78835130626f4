// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.IO;

namespace HrbfNpr
{
    /// <summary>A layer of ready-made marks for <c>PointSet.Create</c>: position and normal are needed.</summary>
    public sealed class OwnLayer
    {
        /// <summary>Without arrays.</summary>
        public OwnLayer()
        {
        }

        /// <summary>Marks, or strokes.</summary>
        /// <param name="position">n points, absolute; float or double.</param>
        /// <param name="normal">n unit normals, outward; float or double.</param>
        /// <param name="strokeFirst">As <see cref="StrokeFirst"/>; not given for marks that form no strokes.</param>
        /// <param name="name">"own" if null.</param>
        public OwnLayer(
            ArrayView position, ArrayView normal, ArrayView strokeFirst = default(ArrayView), string name = null)
        {
            Position = position;
            Normal = normal;
            StrokeFirst = strokeFirst;
            Name = name;
        }

        /// <summary>What its marks are; Own.</summary>
        public LayerKind Kind { get; set; } = LayerKind.Own;

        /// <summary>1 to 63 bytes of UTF-8; the kind's name if null.</summary>
        public string Name { get; set; }

        /// <summary>n points, absolute; float or double.</summary>
        public ArrayView Position { get; set; }

        /// <summary>n unit normals, outward; float or double.</summary>
        public ArrayView Normal { get; set; }

        /// <summary>
        /// S + 1 uint, rising from 0 to n: stroke s has the marks first[s] to first[s + 1] - 1 from end to end.  No
        /// strokes by default.
        /// </summary>
        public ArrayView StrokeFirst { get; set; }

        /// <summary>S bytes: 0 the first direction, 1 the second; 0 by default.</summary>
        public ArrayView StrokeDirection { get; set; }

        /// <summary>n unit tangents; by default along the stroke, or the mark's basis.</summary>
        public ArrayView Direction { get; set; }

        /// <summary>n times k1, k2, confidence; not known by default.</summary>
        public ArrayView Curvature { get; set; }

        /// <summary>n numbers in [0, 1); random by default, the same for all marks of a stroke.</summary>
        public ArrayView Rank { get; set; }

        /// <summary>n bytes; 0 by default.</summary>
        public ArrayView Level { get; set; }

        /// <summary>n numbers in (0, 1]; 1 by default.</summary>
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

    /// <summary>Layers of marks on a surface: stipples, strokes, and marks of the program's own [NPAR 5].</summary>
    /// <remarks>
    /// Immutable: any number of threads may use a set at a time.  A set that is disposed of or finalised goes on
    /// living where it is still needed.  Positions are float, relative to <see cref="PointSetInfo.Origin"/>.
    /// </remarks>
    public sealed unsafe class PointSet : IDisposable
    {
        private readonly PointSetHandle handle;
        private ReadOnlyCollection<MarkLayer> layers;

        internal PointSet(PointSetHandle handle)
        {
            this.handle = handle;
        }

        /// <summary>Counts, bounds and seconds.</summary>
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

        /// <summary>Marks in all layers.</summary>
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
                    layers = new ReadOnlyCollection<MarkLayer>(made); // any thread may be the first, or the second
                }
                return layers;
            }
        }

        /// <summary>The first layer of a name.</summary>
        /// <exception cref="KeyNotFoundException">There is none.</exception>
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
                throw new KeyNotFoundException("no layer of the set is called " + name);
            }
        }

        /// <summary>What became of the seeds' candidates.</summary>
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

        /// <summary>A set of the program's marks, which are copied.</summary>
        /// <param name="layers">One or more.</param>
        /// <exception cref="InvalidArgumentException">The message names the layer, the array and the index.</exception>
        public static PointSet Create(params OwnLayer[] layers)
        {
            return Create(layers, null);
        }

        /// <summary>A set of another set's layers, followed by the program's.</summary>
        /// <param name="basis">Its layers come first; null for none.</param>
        /// <param name="layers">The layers that follow.</param>
        /// <exception cref="InvalidArgumentException">The message names the layer, the array and the index.</exception>
        public static PointSet Create(PointSet basis, params OwnLayer[] layers)
        {
            return Create(layers, basis);
        }

        /// <summary>A set of the program's marks, or of another set's layers and the program's.</summary>
        /// <param name="layers">The layers that follow.</param>
        /// <param name="basis">Its layers come first; null for none.</param>
        /// <param name="randomSeed">For ranks that are not given.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="InvalidArgumentException">The message names the layer, the array and the index.</exception>
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
    }
}
