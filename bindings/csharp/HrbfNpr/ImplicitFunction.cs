// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Evaluates an implicit function of the program at n points.</summary>
    /// <param name="points">3 n numbers: x, y, z of each point.</param>
    /// <param name="value">Receives n values of f, negative inside and finite in a box twice as wide as the
    /// bounds.</param>
    /// <param name="gradient">Receives 3 n derivatives, of a length near 1 at the surface; null = not wanted.</param>
    /// <param name="hessian">Receives 6 n derivatives, xx xy xz yy yz zz; null = not wanted.</param>
    /// <remarks>If it throws, the call that evaluates it throws a <see cref="CallbackException"/>.</remarks>
    public delegate void ImplicitFunction(double[] points, double[] value, double[] gradient, double[] hessian);

#if NET7_0_OR_GREATER
    /// <summary>
    /// Evaluates an implicit function like <see cref="ImplicitFunction"/>, in place.  A span of results that are not
    /// wanted is empty.
    /// </summary>
    public delegate void ImplicitSpanFunction(
        ReadOnlySpan<double> points, Span<double> value, Span<double> gradient, Span<double> hessian);
#endif

    /// <summary>What a function can do, and how it may be called.</summary>
    public sealed class FunctionOptions
    {
        /// <summary>Whether the function fills gradients; default false = they are computed by differences.</summary>
        public bool HasGradient { get; set; }

        /// <summary>Whether the function fills Hessians; default false = they are computed by differences.</summary>
        public bool HasHessian { get; set; }

        /// <summary>Whether the function may run on several threads at the same time; default false.</summary>
        public bool ThreadSafe { get; set; }

        /// <summary>
        /// Step of the differences, in the unit of the points; 0 or more; default 0 = 1e-4 diagonals for gradients,
        /// 1e-3 for Hessians.
        /// </summary>
        public double DifferenceStep { get; set; }

        internal uint Flags
        {
            get { return (HasGradient ? 1u : 0) | (HasHessian ? 2u : 0) | (ThreadSafe ? 4u : 0); }
        }
    }

    /// <summary>The function of one model, and what it threw.</summary>
    internal sealed unsafe class FunctionState : CallbackState
    {
        internal static readonly IntPtr Evaluate;
        internal static readonly IntPtr Release;
        private static readonly NativeCallbacks.Implicit EvaluateCallback = OnEvaluate;
        private static readonly NativeCallbacks.Release ReleaseCallback = OnRelease;
        private readonly ImplicitFunction function;

        static FunctionState()
        {
            Evaluate = Marshal.GetFunctionPointerForDelegate(EvaluateCallback);
            Release = Marshal.GetFunctionPointerForDelegate(ReleaseCallback);
        }

        internal FunctionState(ImplicitFunction function)
        {
            this.function = function ?? throw new ArgumentNullException(nameof(function));
        }

        private readonly FunctionState first, second; // the states of two models of a solid

        private FunctionState(FunctionState first, FunctionState second)
        {
            this.first = first;
            this.second = second;
        }

        /// <summary>Makes one state of two models' functions; null if neither has one.</summary>
        internal static FunctionState Both(FunctionState one, FunctionState other)
        {
            return one == null || one == other ? other : other == null ? one : new FunctionState(one, other);
        }

        internal override Exception TakeException()
        {
            if (first == null)
            {
                return base.TakeException();
            }
            Exception exception = first.TakeException();
            return second.TakeException() is Exception other ? exception ?? other : exception;
        }

#if NET7_0_OR_GREATER
        private readonly ImplicitSpanFunction spanFunction;

        internal FunctionState(ImplicitSpanFunction function)
        {
            spanFunction = function ?? throw new ArgumentNullException(nameof(function));
        }
#endif

        private void Call(long count, double* points, double* value, double* gradient, double* hessian)
        {
#if NET7_0_OR_GREATER
            if (spanFunction != null)
            {
                int n = checked((int)count);
                spanFunction(
                    new ReadOnlySpan<double>(points, 3 * n), new Span<double>(value, n),
                    new Span<double>(gradient, gradient == null ? 0 : 3 * n),
                    new Span<double>(hessian, hessian == null ? 0 : 6 * n));
                return;
            }
#endif
            var place = new double[count * 3];
            Marshal.Copy((IntPtr)points, place, 0, place.Length);
            var values = new double[count];
            double[] gradients = gradient == null ? null : new double[count * 3];
            double[] hessians = hessian == null ? null : new double[count * 6];
            function(place, values, gradients, hessians);
            Marshal.Copy(values, 0, (IntPtr)value, values.Length);
            if (gradients != null)
            {
                Marshal.Copy(gradients, 0, (IntPtr)gradient, gradients.Length);
            }
            if (hessians != null)
            {
                Marshal.Copy(hessians, 0, (IntPtr)hessian, hessians.Length);
            }
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Implicit))]
        private static int OnEvaluate(
            IntPtr user, long count, double* points, double* value, double* gradient, double* hessian)
        {
            var state = From<FunctionState>(user);
            try
            {
                state.Call(count, points, value, gradient, hessian);
                return 0;
            }
            catch (Exception exception)
            {
                state.Keep(exception);
                return 1;
            }
        }

        /// <summary>
        /// Frees the handle of a state.  It runs with the last reference to the model, on any thread.
        /// </summary>
        [MonoPInvokeCallback(typeof(NativeCallbacks.Release))]
        private static void OnRelease(IntPtr user)
        {
            GCHandle.FromIntPtr(user).Free();
        }
    }
}
