// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// A view of an array of a model, mesh or point set, without a copy.  It keeps the object alive, and must not be
    /// written to.
    /// </summary>
    /// <remarks>Any thread may use it.</remarks>
    public sealed unsafe class NativeView : IDisposable
    {
        private readonly NativeHandle owner;
        private readonly IntPtr data;

        internal NativeView(NativeHandle owner, hrbfnpr_array view)
        {
            this.owner = owner;
            data = view.data;
            Count = view.count;
            Scalar = (ScalarType)view.scalar;
            Components = (int)view.components;
            Stride = view.stride != 0 ? view.stride : Components * ScalarSize;
        }

        /// <summary>Number of elements, such as marks; 0 if the array is absent.</summary>
        public long Count { get; }

        /// <summary>Bytes from one element to the next.</summary>
        public long Stride { get; }

        /// <summary>Type of the numbers.</summary>
        public ScalarType Scalar { get; }

        /// <summary>Number of scalars in an element, side by side.</summary>
        public int Components { get; }

        /// <summary>Address of the first element.  It is valid until the view is disposed of or finalised.</summary>
        /// <exception cref="ObjectDisposedException">The view was disposed of.</exception>
        public IntPtr Data
        {
            get
            {
                if (owner.IsClosed)
                {
                    throw new ObjectDisposedException(nameof(NativeView));
                }
                return data;
            }
        }

        private int ScalarSize
        {
            get { return Scalar == ScalarType.Float64 || Scalar == ScalarType.Int64 ? 8 : Scalar == ScalarType.Uint8 ? 1 : 4; }
        }

        /// <summary>Returns the view as an argument of a call.  Keep the view alive as long as the call runs.</summary>
        public ArrayView ToArrayView()
        {
            return ArrayView.At(Data, Count, Scalar, Components, Stride);
        }

        /// <summary>Copies all numbers, element by element.</summary>
        /// <typeparam name="T">float, double, byte or uint, as <see cref="Scalar"/> says.</typeparam>
        /// <exception cref="InvalidCastException">The numbers are of another type.</exception>
        public T[] ToArray<T>()
            where T : struct
        {
            CheckType(typeof(T), Scalar, Count);
            bool held = false;
            try
            {
                owner.DangerousAddRef(ref held);
                var result = new T[Count * Components];
                if (Count == 0)
                {
                    return result;
                }
                GCHandle pin = GCHandle.Alloc(result, GCHandleType.Pinned);
                try
                {
                    Copy((byte*)pin.AddrOfPinnedObject());
                }
                finally
                {
                    pin.Free();
                }
                return result;
            }
            finally
            {
                if (held)
                {
                    owner.DangerousRelease();
                }
            }
        }

#if NET7_0_OR_GREATER
        /// <summary>Gives all numbers in place.  Do not use the span after the view is disposed of.</summary>
        /// <typeparam name="T">float, double, byte or uint, as <see cref="Scalar"/> says.</typeparam>
        /// <exception cref="InvalidCastException">The numbers are of another type, or not packed.</exception>
        public ReadOnlySpan<T> AsSpan<T>()
            where T : unmanaged
        {
            CheckType(typeof(T), Scalar, Count);
            CheckPacked(Stride, Components * ScalarSize);
            return new ReadOnlySpan<T>((void*)Data, checked((int)(Count * Components)));
        }
#endif

        /// <summary>Releases the object that the view is of.</summary>
        public void Dispose()
        {
            owner.Dispose();
        }

        internal static void CheckType(Type type, ScalarType scalar, long count)
        {
            Type wanted = scalar == ScalarType.Float64 ? typeof(double) : scalar == ScalarType.Float32 ? typeof(float)
                : scalar == ScalarType.Uint8 ? typeof(byte) : typeof(uint);
            if (type != wanted && count > 0)
            {
                throw new InvalidCastException("this view has numbers of type " + wanted.Name + ", not " + type.Name);
            }
        }

#if NET7_0_OR_GREATER
        internal static void CheckPacked(long stride, long size)
        {
            if (stride != 0 && stride != size)
            {
                throw new InvalidCastException("the elements of this view are not contiguous; copy them instead");
            }
        }

#endif
        private void Copy(byte* target)
        {
            long size = Components * ScalarSize;
            if (Stride == size)
            {
                Buffer.MemoryCopy((void*)data, target, size * Count, size * Count);
                return;
            }
            for (long i = 0; i < Count; ++i)
            {
                Buffer.MemoryCopy((byte*)data + i * Stride, target + i * size, size, size);
            }
        }
    }
}
