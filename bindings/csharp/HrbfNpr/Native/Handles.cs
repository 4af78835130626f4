// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// Shared by all handles of one context: the address of the context, and the functions of the program that the
    /// library may call while one of the handles lives.  References are counted, because finalisers run in any order.
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

        /// <summary>The context, which lives as long as a handle that was made from it.</summary>
        internal IntPtr Context { get; set; }

        /// <summary>The <c>user</c> pointer of the context's callbacks.</summary>
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

    /// <summary>One reference to a handle of the library, which is released once.</summary>
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

        /// <summary>Takes over the result of a call; zero if the call failed.</summary>
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
        /// <summary>Passed to calls without progress and cancelling.</summary>
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

        /// <summary>Makes another reference to the same model.</summary>
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

        /// <summary>Makes a new reference to a handle that is alive.</summary>
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

        /// <summary>Makes another reference to the same point set.</summary>
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

        /// <summary>Makes a new reference to a handle that is alive.</summary>
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

        /// <summary>Makes a new reference to a handle that is alive.</summary>
        internal static LineSetHandle Of(IntPtr value, ContextAnchor owner)
        {
            var copy = new LineSetHandle();
            NativeMethods.hrbfnpr_line_set_retain(value);
            copy.Take(value, owner);
            return copy;
        }
    }

    internal sealed class FieldHandle : NativeHandle
    {
        private UserHandle user;
        private SafeHandle source;

        /// <summary>Keeps an object of the library, which has the function of the field, as long as the field.</summary>
        internal void Keep(SafeHandle owner)
        {
            bool held = false;
            owner.DangerousAddRef(ref held);
            source = owner;
        }

        /// <summary>Keeps the state of a function as long as the field; returns its <c>user</c> pointer.</summary>
        internal IntPtr Keep(CallbackState state)
        {
            user = new UserHandle(state);
            return user.Pointer;
        }

        /// <summary>Frees the state after the field could not be created.</summary>
        internal void Forget()
        {
            user.Dispose();
        }

        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_field_release(value);
            user.Dispose();
            if (source != null)
            {
                source.DangerousRelease();
            }
        }
    }

    internal sealed class OccludersHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_occluders_release(value);
        }
    }

    internal sealed class ShadingHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_shading_release(value);
        }
    }

    internal sealed class SettingsHandle : NativeHandle
    {
        protected override void Free(IntPtr value)
        {
            NativeMethods.hrbfnpr_settings_release(value);
        }
    }

    /// <summary>
    /// A picture, with everything of the program that its native part uses: contexts of its sources, and states.
    /// </summary>
    internal sealed class PictureHandle : NativeHandle
    {
        private readonly List<ContextAnchor> anchors = new List<ContextAnchor>();
        private readonly List<UserHandle> users = new List<UserHandle>();

        /// <summary>Takes over what a call made for the picture.  The picture must exist.</summary>
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

        /// <summary>Makes another reference to the same mesh.</summary>
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

        /// <summary>Makes a new reference to a handle that is alive.</summary>
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

    /// <summary>Keeps handles alive while their addresses are in the structs of a call.</summary>
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

        /// <summary>Releases all handles.  The object can be used again afterwards.</summary>
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
