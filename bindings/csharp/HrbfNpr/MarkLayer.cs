// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>One layer of a point set: marks of one kind, made in one way and drawn in one style.</summary>
    /// <remarks>
    /// It keeps its point set from being finalised.  It cannot be used after the point set is disposed of.
    /// </remarks>
    public sealed unsafe class MarkLayer
    {
        private readonly PointSet pointSet;
        private readonly string name;

        internal MarkLayer(PointSet pointSet, int number)
        {
            this.pointSet = pointSet;
            Number = number;
            LayerInfo info = Info;
            name = info.Name;
            Kind = info.Kind;
            Count = info.Marks;
            Strokes = info.Strokes;
        }

        /// <summary>Its place in the list of layers, from 0.</summary>
        public int Number { get; }

        /// <summary>The kind of its marks.</summary>
        public LayerKind Kind { get; }

        /// <summary>Its name.</summary>
        public string Name
        {
            get { return name; }
        }

        /// <summary>Number of marks.</summary>
        public long Count { get; }

        /// <summary>Number of strokes that the marks form; 0 = none.</summary>
        public long Strokes { get; }

        /// <summary>What the layer holds, and how long it took to make.</summary>
        public LayerInfo Info
        {
            get
            {
                LayerInfo info;
                Errors.Check(NativeMethods.hrbfnpr_layer_info_init(&info, (uint)sizeof(LayerInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(
                    NativeMethods.hrbfnpr_point_set_get_layer_info(pointSet.Handle, Number, &info, &error), &error);
                return info;
            }
        }

        /// <summary>
        /// Tells what became of the candidates of one level: 0 for the seeds, then each refinement step.
        /// </summary>
        /// <param name="level">The level, from 0 to <see cref="LayerInfo.Levels"/>.</param>
        /// <exception cref="InvalidArgumentException">There is no such level.</exception>
        public PlacementInfo Placement(int level)
        {
            PlacementInfo info;
            Errors.Check(NativeMethods.hrbfnpr_placement_info_init(&info, (uint)sizeof(PlacementInfo)));
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_point_set_get_placement(pointSet.Handle, Number, level, &info, &error), &error);
            return info;
        }

        /// <summary>
        /// Gives a view of one attribute, without a copy.  It is empty for an empty layer, and for an attribute that
        /// the layer does not have.
        /// </summary>
        public NativeView View(MarkAttribute attribute)
        {
            hrbfnpr_array view = Array(attribute);
            return new NativeView(pointSet.Handle.Share(), view);
        }

        /// <summary>Copies one attribute.</summary>
        /// <typeparam name="T">float, byte or uint, as <see cref="MarkAttribute"/> says.</typeparam>
        /// <exception cref="InvalidCastException">The numbers are of another type.</exception>
        public T[] ToArray<T>(MarkAttribute attribute)
            where T : struct
        {
            using (NativeView view = View(attribute))
            {
                return view.ToArray<T>();
            }
        }

        /// <summary>Copies the positions: 3 n numbers, relative to <see cref="PointSetInfo.Origin"/>.</summary>
        public float[] Positions()
        {
            return ToArray<float>(MarkAttribute.Position);
        }

        /// <summary>Copies the unit normals: 3 n numbers.</summary>
        public float[] Normals()
        {
            return ToArray<float>(MarkAttribute.Normal);
        }

#if NET7_0_OR_GREATER
        /// <summary>
        /// Gives one attribute in place.  Do not use the span after the point set is disposed of or finalised.
        /// </summary>
        /// <typeparam name="T">float, byte or uint, as <see cref="MarkAttribute"/> says.</typeparam>
        /// <exception cref="InvalidCastException">The numbers are of another type.</exception>
        public ReadOnlySpan<T> AsSpan<T>(MarkAttribute attribute)
            where T : unmanaged
        {
            hrbfnpr_array view = Array(attribute);
            NativeView.CheckType(typeof(T), (ScalarType)view.scalar, view.count);
            NativeView.CheckPacked(view.stride, view.components * sizeof(T));
            return new ReadOnlySpan<T>((void*)view.data, checked((int)(view.count * view.components)));
        }
#endif

        /// <summary>
        /// Copies the values of a field: n numbers for a scalar, 3 n for other kinds; empty if the layer has none.
        /// </summary>
        /// <param name="name">The name of the field.</param>
        /// <exception cref="InvalidArgumentException">No layer of the set has a field of this name.</exception>
        public float[] FieldValues(string name)
        {
            return FieldView(name, false);
        }

        /// <summary>Copies the weights of a field: n numbers from 0 to 1; empty if all are 1.</summary>
        /// <param name="name">The name of the field.</param>
        /// <exception cref="InvalidArgumentException">No layer of the set has a field of this name.</exception>
        public float[] FieldWeights(string name)
        {
            return FieldView(name, true);
        }

        private float[] FieldView(string name, bool weights)
        {
            hrbfnpr_array values, its;
            hrbfnpr_error error = Errors.New();
            using (var pins = new Pins())
            {
                Errors.Check(
                    NativeMethods.hrbfnpr_point_set_view_field(
                        pointSet.Handle, Number, (byte*)pins.Text(name), &values, &its, &error),
                    &error);
            }
            using (var view = new NativeView(pointSet.Handle.Share(), weights ? its : values))
            {
                return view.ToArray<float>();
            }
        }

        private hrbfnpr_array Array(MarkAttribute attribute)
        {
            hrbfnpr_array view;
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_point_set_view(pointSet.Handle, Number, (uint)attribute, &view, &error), &error);
            return view;
        }
    }
}
