// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// What all handles of one context share: the context's address, and the program's functions that the library
    /// may call as long as one of these handles lives.  Counted, because finalisers run in any order.
    /// </summary>
    internal sealed class ContextAnchor
    {
        private readonly GCHandle user;
        private int references;

        internal ContextAnchor(CallbackState state)
        {
            State = state;
            user = GCHandle.Alloc(state);
        }

        internal CallbackState State { get; }

        /// <summary>The context; alive as long as a handle that was made from it.</summary>
        internal IntPtr Context { get; set; }

        /// <summary>For the `user` pointers of the context's callbacks.</summary>
        internal IntPtr User
        {
            get { return GCHandle.ToIntPtr(user); }
        }

        internal void AddReference()
        {
            Interlocked.Increment(ref references);
        }

        internal void Release()
        {
            if (Interlocked.Decrement(ref references) == 0)
            {
                user.Free();
            }
        }
    }

    /// <summary>One reference of a handle of the library, given back once.</summary>
    internal abstract class NativeHandle : SafeHandle
    {
        private ContextAnchor anchor;

        protected NativeHandle()
            : base(IntPtr.Zero, true)
        {
        }

        public override bool IsInvalid
        {
            get { return handle == IntPtr.Zero; }
        }

        internal ContextAnchor Anchor
        {
            get { return anchor; }
        }

        /// <summary>Takes what a call returned; a failed call returns zero.</summary>
        internal void Take(IntPtr value, ContextAnchor owner)
        {
            if (value != IntPtr.Zero)
            {
                owner.AddReference();
                anchor = owner;
                SetHandle(value);
            }
        }

        protected abstract void Free(IntPtr value);

        protected override bool ReleaseHandle()
        {
            Free(handle);
            anchor.Release();
            return true;
        }
    }

    internal sealed class ContextHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_context_release(value);
        }
    }

    internal sealed class OperationHandle : NativeHandle
    {
        /// <summary>For calls that are neither watched nor cancelled.</summary>
        internal static readonly OperationHandle None = new OperationHandle();

        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_operation_release(value);
        }
    }

    internal sealed class ModelHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_model_release(value);
        }

        /// <summary>Another reference of the same model.</summary>
        internal ModelHandle Share()
        {
            var copy = new ModelHandle();
            bool held = false;
            try
            {
                DangerousAddRef(ref held);
                NativeMethods.hrbfnpr_model_retain(handle);
                copy.Take(handle, Anchor);
            }
            finally
            {
                if (held)
                {
                    DangerousRelease();
                }
            }
            return copy;
        }
    }

    internal sealed class PointSetHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_point_set_release(value);
        }

        /// <summary>Another reference of the same point set.</summary>
        internal PointSetHandle Share()
        {
            var copy = new PointSetHandle();
            bool held = false;
            try
            {
                DangerousAddRef(ref held);
                NativeMethods.hrbfnpr_point_set_retain(handle);
                copy.Take(handle, Anchor);
            }
            finally
            {
                if (held)
                {
                    DangerousRelease();
                }
            }
            return copy;
        }
    }

    internal sealed class LineSetHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_line_set_release(value);
        }
    }

    internal sealed class MeshHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_mesh_release(value);
        }

        /// <summary>Another reference of the same mesh.</summary>
        internal MeshHandle Share()
        {
            var copy = new MeshHandle();
            bool held = false;
            try
            {
                DangerousAddRef(ref held);
                NativeMethods.hrbfnpr_mesh_retain(handle);
                copy.Take(handle, Anchor);
            }
            finally
            {
                if (held)
                {
                    DangerousRelease();
                }
            }
            return copy;
        }
    }

    internal sealed class RendererHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_renderer_release(value);
        }
    }

    internal sealed class DrawingHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_drawing_release(value);
        }
    }

    /// <summary>Keeps handles alive whose addresses stand in structs of a call.</summary>
    internal sealed class HeldHandles : IDisposable
    {
        private readonly List<SafeHandle> handles = new List<SafeHandle>();

        internal IntPtr Hold(SafeHandle handle)
        {
            bool held = false;
            handle.DangerousAddRef(ref held);
            handles.Add(handle);
            return handle.DangerousGetHandle();
        }

        /// <summary>Lets all of them go; then it can be used again.</summary>
        public void Dispose()
        {
            foreach (SafeHandle handle in handles)
            {
                handle.DangerousRelease();
            }
            handles.Clear();
        }
    }
}
