// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Text;

namespace HrbfNpr
{
    /// <summary>
    /// Memory of the program that a call reads or writes in place: nothing is copied, and it is used during the call
    /// only.  Arrays of numbers convert by themselves: a <c>double[]</c> of 3 n numbers is n points.  The default
    /// value means "not given".
    /// </summary>
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
        private readonly long count; // elements; of an array that converted by itself: scalars
        private readonly long stride;
        private readonly ScalarType scalar;
        private readonly int components; // 0: as the call wants

        private ArrayView(Array array, IntPtr data, long count, ScalarType scalar, int components, long stride)
        {
            this.array = array;
            this.data = data;
            this.count = count;
            this.scalar = scalar;
            this.components = components;
            this.stride = stride;
        }

        /// <summary>Whether there is anything.</summary>
        public bool IsGiven
        {
            get { return array != null || data != IntPtr.Zero; }
        }

        /// <summary>All numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(double[] array)
        {
            return Packed(array, ScalarType.Float64);
        }

        /// <summary>All numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(float[] array)
        {
            return Packed(array, ScalarType.Float32);
        }

        /// <summary>All numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(byte[] array)
        {
            return Packed(array, ScalarType.Uint8);
        }

        /// <summary>All numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(uint[] array)
        {
            return Packed(array, ScalarType.Uint32);
        }

        /// <summary>All numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(int[] array)
        {
            return Packed(array, ScalarType.Int32);
        }

        /// <summary>All numbers of an array; null is "not given".</summary>
        public static implicit operator ArrayView(long[] array)
        {
            return Packed(array, ScalarType.Int64);
        }

        /// <summary>An array of structs, each of which begins with <paramref name="components"/> numbers.</summary>
        /// <param name="array">Such as one of vectors of three <c>float</c>.</param>
        /// <param name="scalar">Type of the numbers.</param>
        /// <param name="components">Numbers in an element, side by side.</param>
        /// <typeparam name="T">A type without references, laid out in order.</typeparam>
        public static ArrayView Of<T>(T[] array, ScalarType scalar, int components)
            where T : struct
        {
            if (array == null)
            {
                throw new ArgumentNullException(nameof(array));
            }
            return new ArrayView(array, IntPtr.Zero, array.LongLength, scalar, components, Marshal.SizeOf<T>());
        }

        /// <summary>Native memory, such as a pinned span's or a NativeArray's.</summary>
        /// <param name="data">The first element.</param>
        /// <param name="count">Elements.</param>
        /// <param name="scalar">Type of the numbers.</param>
        /// <param name="components">Numbers in an element, side by side.</param>
        /// <param name="stride">Bytes from an element to the next; 0 = packed; may be negative.</param>
        public static ArrayView At(IntPtr data, long count, ScalarType scalar, int components, long stride = 0)
        {
            return new ArrayView(null, data, count, scalar, components, stride);
        }

        /// <summary>An array of an enum of bytes.</summary>
        internal static ArrayView OfBytes(Array array)
        {
            return Packed(array, ScalarType.Uint8);
        }

        private static ArrayView Packed(Array array, ScalarType scalar)
        {
            return array == null ? default(ArrayView)
                : new ArrayView(array, IntPtr.Zero, array.LongLength, scalar, 0, 0);
        }

        /// <summary>Elements of <paramref name="wanted"/> numbers each.</summary>
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

    /// <summary>Keeps arrays where they are during a call.</summary>
    internal sealed class Pins : IDisposable
    {
        private readonly List<GCHandle> handles = new List<GCHandle>();

        internal IntPtr Pin(Array array)
        {
            GCHandle handle = GCHandle.Alloc(array, GCHandleType.Pinned);
            handles.Add(handle);
            return handle.AddrOfPinnedObject();
        }

        /// <summary>UTF-8 with a zero behind it; null for null.</summary>
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
