// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Streams that the library writes to and reads from.</summary>
    internal sealed unsafe class StreamState : CallbackState
    {
        internal static readonly IntPtr Write;
        internal static readonly IntPtr Read;
        private static readonly NativeCallbacks.Write WriteCallback = OnWrite;
        private static readonly NativeCallbacks.Read ReadCallback = OnRead;
        private readonly Stream stream;
        private readonly byte[] buffer = new byte[1 << 16];

        static StreamState()
        {
            Write = Marshal.GetFunctionPointerForDelegate(WriteCallback);
            Read = Marshal.GetFunctionPointerForDelegate(ReadCallback);
        }

        internal StreamState(Stream stream)
        {
            this.stream = stream ?? throw new ArgumentNullException(nameof(stream));
        }

        /// <summary>Throws what the stream threw, or the failure of the call.</summary>
        internal void Check(int status, hrbfnpr_error* error)
        {
            CheckStream();
            Errors.Check(status, error);
        }

        /// <summary>Throws what the stream threw.</summary>
        internal void CheckStream()
        {
            Exception thrown = TakeException();
            if (thrown != null)
            {
                throw new StreamException("the stream failed: " + thrown.Message, thrown);
            }
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Write))]
        private static int OnWrite(IntPtr user, byte* data, ulong size)
        {
            var state = From<StreamState>(user);
            try
            {
                while (size > 0)
                {
                    int part = (int)Math.Min(size, (ulong)state.buffer.Length);
                    Marshal.Copy((IntPtr)data, state.buffer, 0, part);
                    state.stream.Write(state.buffer, 0, part);
                    data += part;
                    size -= (ulong)part;
                }
                return 0;
            }
            catch (Exception exception)
            {
                state.Keep(exception);
                return 1;
            }
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Read))]
        private static long OnRead(IntPtr user, byte* data, ulong size)
        {
            var state = From<StreamState>(user);
            try
            {
                int part = state.stream.Read(state.buffer, 0, (int)Math.Min(size, (ulong)state.buffer.Length));
                Marshal.Copy(state.buffer, 0, (IntPtr)data, part);
                return part;
            }
            catch (Exception exception)
            {
                state.Keep(exception);
                return -1;
            }
        }
    }
}
