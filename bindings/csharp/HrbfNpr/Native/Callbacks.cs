// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>Tells IL2CPP that native code calls the method.  IL2CPP knows the attribute by its name.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        internal MonoPInvokeCallbackAttribute(Type type)
        {
            Type = type;
        }

        internal Type Type { get; }
    }

    /// <summary>
    /// The data of a callback, and the exception that it caught: no exception may leave a callback.  The <c>user</c>
    /// pointer is a GCHandle of it.
    /// </summary>
    internal class CallbackState
    {
        private Exception exception;

        internal Exception LastException
        {
            get { return Volatile.Read(ref exception); }
        }

        internal static T From<T>(IntPtr user)
            where T : CallbackState
        {
            return (T)GCHandle.FromIntPtr(user).Target;
        }

        /// <summary>Keeps the first exception.</summary>
        internal void Keep(Exception thrown)
        {
            Interlocked.CompareExchange(ref exception, thrown, null);
        }

        internal virtual Exception TakeException()
        {
            return Interlocked.Exchange(ref exception, null);
        }
    }

    /// <summary>A GCHandle of a state during a call.</summary>
    internal struct UserHandle : IDisposable
    {
        private GCHandle handle;

        /// <param name="state">The state; may be null.</param>
        /// <param name="type">Weak if the caller keeps the state alive.</param>
        internal UserHandle(CallbackState state, GCHandleType type = GCHandleType.Normal)
        {
            handle = state == null ? default(GCHandle) : GCHandle.Alloc(state, type);
        }

        internal IntPtr Pointer
        {
            get { return GCHandle.ToIntPtr(handle); }
        }

        public void Dispose()
        {
            if (handle.IsAllocated)
            {
                handle.Free();
            }
        }
    }

    /// <summary>
    /// A function of the library that the style or the layers of a picture call, such as for painted tone.
    /// </summary>
    internal sealed class NativeFunction
    {
        private readonly IntPtr user;
        private readonly SafeHandle owner;

        internal NativeFunction(IntPtr function, IntPtr user, SafeHandle owner)
        {
            Function = function;
            this.user = user;
            this.owner = owner;
        }

        internal IntPtr Function { get; }

        /// <summary>Returns the first argument of the function, and keeps its owner alive during the call.</summary>
        internal IntPtr Hold(HeldHandles held)
        {
            held.Hold(owner);
            return user;
        }

        /// <summary>Wraps a function; null if there is none.</summary>
        internal static NativeFunction Of(IntPtr function, IntPtr user, SafeHandle owner)
        {
            return function == IntPtr.Zero || owner == null ? null : new NativeFunction(function, user, owner);
        }
    }

    /// <summary>The types of the callbacks, as in hrbfnpr.h.</summary>
    internal static unsafe class NativeCallbacks
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void Log(IntPtr user, int level, byte* message);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void Task(IntPtr taskContext, long index);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void RunTasks(IntPtr user, IntPtr task, IntPtr taskContext, long count);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int Progress(IntPtr user, double progress);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int Write(IntPtr user, byte* data, ulong size);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate long Read(IntPtr user, byte* data, ulong size);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int Implicit(
            IntPtr user, long count, double* points, double* value, double* gradient, double* hessian);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void Release(IntPtr user);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int Density(IntPtr user, long count, double* positions, double* normals, double* density);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int Direction(
            IntPtr user, long count, double* positions, double* normals, double* directions);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int Field(
            IntPtr user, long count, double* positions, double* normals, double* values, double* weights);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate int Tone(IntPtr user, long count, float* positions, float* normals, float* tau);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        internal delegate void PictureEvent(IntPtr user, hrbfnpr_picture_event* happened);
    }
}
