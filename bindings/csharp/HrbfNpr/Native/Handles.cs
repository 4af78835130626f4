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
            bool held = false;
            try
            {
                DangerousAddRef(ref held);
                return Of(handle, Anchor);
            }
            finally
            {
                if (held)
                {
                    DangerousRelease();
                }
            }
        }

        /// <summary>Adds a reference to a handle that is alive.</summary>
        internal static ModelHandle Of(IntPtr value, ContextAnchor owner)
        {
            var copy = new ModelHandle();
            NativeMethods.hrbfnpr_model_retain(value);
            copy.Take(value, owner);
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
            bool held = false;
            try
            {
                DangerousAddRef(ref held);
                return Of(handle, Anchor);
            }
            finally
            {
                if (held)
                {
                    DangerousRelease();
                }
            }
        }

        /// <summary>Adds a reference to a handle that is alive.</summary>
        internal static PointSetHandle Of(IntPtr value, ContextAnchor owner)
        {
            var copy = new PointSetHandle();
            NativeMethods.hrbfnpr_point_set_retain(value);
            copy.Take(value, owner);
            return copy;
        }
    }

    internal sealed class LineSetHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_line_set_release(value);
        }

        /// <summary>Adds a reference to a handle that is alive.</summary>
        internal static LineSetHandle Of(IntPtr value, ContextAnchor owner)
        {
            var copy = new LineSetHandle();
            NativeMethods.hrbfnpr_line_set_retain(value);
            copy.Take(value, owner);
            return copy;
        }
    }

    internal sealed class SettingsHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_settings_release(value);
        }
    }

    /// <summary>A picture, and what its native part may use of the program: contexts of others, and states.</summary>
    internal sealed class PictureHandle : NativeHandle
    {
        private readonly List<ContextAnchor> anchors = new List<ContextAnchor>();
        private readonly List<UserHandle> users = new List<UserHandle>();

        /// <summary>Takes over what a call made for the picture, which is there.</summary>
        internal void Keep(IEnumerable<ContextAnchor> others, IEnumerable<UserHandle> states)
        {
            foreach (ContextAnchor anchor in others)
            {
                anchor.AddReference();
                anchors.Add(anchor);
            }
            users.AddRange(states);
        }

        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_picture_release(value);
            foreach (UserHandle user in users)
            {
                user.Dispose();
            }
            foreach (ContextAnchor anchor in anchors)
            {
                anchor.Release();
            }
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
            bool held = false;
            try
            {
                DangerousAddRef(ref held);
                return Of(handle, Anchor);
            }
            finally
            {
                if (held)
                {
                    DangerousRelease();
                }
            }
        }

        /// <summary>Adds a reference to a handle that is alive.</summary>
        internal static MeshHandle Of(IntPtr value, ContextAnchor owner)
        {
            var copy = new MeshHandle();
            NativeMethods.hrbfnpr_mesh_retain(value);
            copy.Take(value, owner);
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
