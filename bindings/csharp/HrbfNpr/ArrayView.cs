// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace HrbfNpr
{
    /// <summary>
    /// A view of the program's memory that a call reads or writes in place, without a copy.  Arrays of numbers convert
    /// implicitly: a <c>double[]</c> of 3 n numbers is n points.  The default value means "not given".
    /// </summary>
    /// <remarks>The memory is used during the call only.</remarks>
    /// <example>
    /// <code>
    /// Model.Fit(points, normals);                                             // double[] or float[]
    /// Model.Fit(ArrayView.Of(vectors, ScalarType.Float32, 3), normals);       // any array of structs of 3 float
    /// Model.Fit(ArrayView.At(pointer, count, ScalarType.Float32, 3), normals) // native memory
    /// </code>
    /// </example>
    public readonly struct ArrayView
    {
        private readonly Array array;
        private readonly IntPtr data;
        private readonly long count; // number of elements; number of scalars for an array that was converted implicitly
        private readonly long stride;
        private readonly ScalarType scalar;
        private readonly int components; // numbers in an element; 0 = as many as the call expects

        private ArrayView(Array array, IntPtr data, long count, ScalarType scalar, int components, long stride)
        {
            this.array = array;
            this.data = data;
            this.count = count;
            this.scalar = scalar;
            this.components = components;
            this.stride = stride;
        }

        /// <summary>Whether the view is of some memory: false for the default value.</summary>
        public bool IsGiven
        {
            get { return array != null || data != IntPtr.Zero; }
        }

        /// <summary>Views all numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(double[] array)
        {
            return Packed(array, ScalarType.Float64);
        }

        /// <summary>Views all numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(float[] array)
        {
            return Packed(array, ScalarType.Float32);
        }

        /// <summary>Views all numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(byte[] array)
        {
            return Packed(array, ScalarType.Uint8);
        }

        /// <summary>Views all numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(uint[] array)
        {
            return Packed(array, ScalarType.Uint32);
        }

        /// <summary>Views all numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(int[] array)
        {
            return Packed(array, ScalarType.Int32);
        }

        /// <summary>Views all numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(long[] array)
        {
            return Packed(array, ScalarType.Int64);
        }

        /// <summary>
        /// Views an array of structs, each of which begins with <paramref name="components"/> numbers.
        /// </summary>
        /// <param name="array">The array, such as one of vectors of three <c>float</c>.</param>
        /// <param name="scalar">The type of the numbers.</param>
        /// <param name="components">The number of scalars at the start of a struct, side by side.</param>
        /// <typeparam name="T">A struct without references and with sequential layout.</typeparam>
        public static ArrayView Of<T>(T[] array, ScalarType scalar, int components)
            where T : struct
        {
            if (array == null)
            {
                throw new ArgumentNullException(nameof(array));
            }
            return new ArrayView(array, IntPtr.Zero, array.LongLength, scalar, components, Marshal.SizeOf<T>());
        }

        /// <summary>Views native memory, such as that of a pinned span or a NativeArray.</summary>
        /// <param name="data">The address of the first element.</param>
        /// <param name="count">The number of elements.</param>
        /// <param name="scalar">The type of the numbers.</param>
        /// <param name="components">The number of scalars in an element, side by side.</param>
        /// <param name="stride">The bytes from one element to the next; may be negative; 0 = packed.</param>
        public static ArrayView At(IntPtr data, long count, ScalarType scalar, int components, long stride = 0)
        {
            return new ArrayView(null, data, count, scalar, components, stride);
        }

        /// <summary>Views an array of an enum whose underlying type is byte.</summary>
        internal static ArrayView OfBytes(Array array)
        {
            return Packed(array, ScalarType.Uint8);
        }

        private static ArrayView Packed(Array array, ScalarType scalar)
        {
            return array == null ? default(ArrayView)
                : new ArrayView(array, IntPtr.Zero, array.LongLength, scalar, 0, 0);
        }

        /// <summary>The number of elements if each has <paramref name="wanted"/> numbers.</summary>
        internal long CountOf(int wanted, string argument)
        {
            if (components != 0 || array == null)
            {
                return count;
            }
            if (wanted <= 0 || count % wanted != 0)
            {
                throw new InvalidArgumentException(
                    argument + " has " + count + " numbers, which is not a multiple of " + wanted);
            }
            return count / wanted;
        }

        internal hrbfnpr_array ToNative(Pins pins, int wanted, string argument)
        {
            var result = default(hrbfnpr_array);
            if (!IsGiven)
            {
                return result;
            }
            result.count = CountOf(wanted, argument);
            result.scalar = (uint)scalar;
            result.components = (uint)(components == 0 ? wanted : components);
            result.stride = stride;
            result.data = array == null ? data : pins.Pin(array);
            return result;
        }
    }

    /// <summary>Pins arrays during a call.</summary>
    internal sealed class Pins : IDisposable
    {
        private readonly List<GCHandle> handles = new List<GCHandle>();

        internal IntPtr Pin(Array array)
        {
            GCHandle handle = GCHandle.Alloc(array, GCHandleType.Pinned);
            handles.Add(handle);
            return handle.AddrOfPinnedObject();
        }

        /// <summary>Pins a text as UTF-8 with a terminating zero; zero for null.</summary>
        internal IntPtr Text(string text)
        {
            return text == null ? IntPtr.Zero : Pin(Encoding.UTF8.GetBytes(text + "\0"));
        }

        public void Dispose()
        {
            foreach (GCHandle handle in handles)
            {
                handle.Free();
            }
            handles.Clear();
        }
    }
}
