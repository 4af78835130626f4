// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// Native memory for the structs of a call, kept from one call to the next.  Its size is measured first; then
    /// pieces of it are taken.
    /// </summary>
    internal sealed unsafe class Memory : IDisposable
    {
        private byte* start;
        private long capacity;
        private long used;

        ~Memory()
        {
            Release();
        }

        public void Dispose()
        {
            Release();
            GC.SuppressFinalize(this);
        }

        internal static long Rounded(long size)
        {
            return (size + 7) / 8 * 8;
        }

        /// <summary>
        /// Frees all pieces, and makes room for <paramref name="size"/> bytes: the sum of the sizes of all pieces, each
        /// rounded up by <see cref="Rounded"/>.
        /// </summary>
        internal void Begin(long size)
        {
            used = 0;
            if (size > capacity)
            {
                Release();
                start = (byte*)Marshal.AllocHGlobal((IntPtr)size);
                capacity = size;
            }
        }

        internal byte* Take(long size)
        {
            byte* piece = start + used;
            used += Rounded(size);
            if (used > capacity)
            {
                throw new InvalidOperationException("the list was changed during the call; change it before or after");
            }
            return piece;
        }

        private void Release()
        {
            Marshal.FreeHGlobal((IntPtr)start);
            start = null;
            capacity = 0;
        }
    }
}
