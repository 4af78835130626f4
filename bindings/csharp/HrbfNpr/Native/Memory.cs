// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// Native memory for the structs of one call after the other, kept between calls: its size is measured first, then
    /// it is given out piece by piece.
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

        /// <summary>Takes all back, and makes room for so many bytes; sizes of pieces count rounded.</summary>
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
                throw new InvalidOperationException("the list was changed while it was drawn");
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
