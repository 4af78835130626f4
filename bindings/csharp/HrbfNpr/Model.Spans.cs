// SPDX-License-Identifier: MIT
#if NET7_0_OR_GREATER
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>As the other <c>Fit</c>, from spans of 3 N numbers.</summary>
        /// <param name="points">N points.</param>
        /// <param name="normals">Their outward normals.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        public static Model Fit(
            ReadOnlySpan<double> points, ReadOnlySpan<double> normals, FitOptions options = null,
            Context context = null, IProgress<double> progress = null, CancellationToken cancellationToken = default)
        {
            fixed (double* first = points, second = normals)
            {
                return Fit(
                    Spans.View(first, points.Length, 3), Spans.View(second, normals.Length, 3), options, context,
                    progress, cancellationToken);
            }
        }

        /// <summary>As the other <c>Fit</c>, from spans of 3 N numbers.</summary>
        /// <param name="points">N points.</param>
        /// <param name="normals">Their outward normals.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        public static Model Fit(
            ReadOnlySpan<float> points, ReadOnlySpan<float> normals, FitOptions options = null,
            Context context = null, IProgress<double> progress = null, CancellationToken cancellationToken = default)
        {
            fixed (float* first = points, second = normals)
            {
                return Fit(
                    Spans.View(first, points.Length, 3), Spans.View(second, normals.Length, 3), options, context,
                    progress, cancellationToken);
            }
        }

        /// <summary>As the other <c>Fit</c>, from arrays of 3 N numbers.</summary>
        /// <param name="points">N points.</param>
        /// <param name="normals">Their outward normals.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        public static Model Fit(
            double[] points, double[] normals, FitOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default)
        {
            return Fit((ArrayView)points, (ArrayView)normals, options, context, progress, cancellationToken);
        }

        /// <summary>As the other <c>Fit</c>, from arrays of 3 N numbers.</summary>
        /// <param name="points">N points.</param>
        /// <param name="normals">Their outward normals.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        public static Model Fit(
            float[] points, float[] normals, FitOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default)
        {
            return Fit((ArrayView)points, (ArrayView)normals, options, context, progress, cancellationToken);
        }

        /// <summary>f, its gradient and Hessian at n points, into the caller's spans.</summary>
        /// <param name="points">3 n numbers.</param>
        /// <param name="value">n numbers, or empty.</param>
        /// <param name="gradient">3 n numbers, or empty.</param>
        /// <param name="hessian">6 n numbers, or empty.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call; a part of the results may then be written.</param>
        public void Evaluate(
            ReadOnlySpan<double> points, Span<double> value, Span<double> gradient = default,
            Span<double> hessian = default, IProgress<double> progress = null,
            CancellationToken cancellationToken = default)
        {
            fixed (double* at = points, values = value, gradients = gradient, hessians = hessian)
            {
                EvaluateInto(
                    Spans.View(at, points.Length, 3), Spans.View(values, value.Length, 1),
                    Spans.View(gradients, gradient.Length, 3), Spans.View(hessians, hessian.Length, 6), progress,
                    cancellationToken);
            }
        }

        /// <summary>As the other <c>Load</c>.</summary>
        /// <param name="data">All of a saved model.</param>
        /// <param name="context">The default context if null.</param>
        public static Model Load(ReadOnlySpan<byte> data, Context context = null)
        {
            fixed (byte* start = data)
            {
                return Load(start, data.Length, context);
            }
        }
    }

    internal static unsafe class Spans
    {
        internal static ArrayView View(double* data, int length, int components)
        {
            return At((IntPtr)data, length, ScalarType.Float64, components);
        }

        internal static ArrayView View(float* data, int length, int components)
        {
            return At((IntPtr)data, length, ScalarType.Float32, components);
        }

        private static ArrayView At(IntPtr data, int length, ScalarType scalar, int components)
        {
            if (length % components != 0)
            {
                throw new InvalidArgumentException(
                    $"a span has {length} numbers, which is not a multiple of {components}");
            }
            return ArrayView.At(data, length / components, scalar, components);
        }
    }
}
#endif
