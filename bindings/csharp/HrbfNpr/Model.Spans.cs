// SPDX-License-Identifier: MIT
#if NET7_0_OR_GREATER
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>Fits f to samples, like the other <c>Fit</c>, from spans of 3 N numbers.</summary>
        /// <param name="points">The N points.</param>
        /// <param name="normals">The N outward normals.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
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

        /// <summary>Fits f to samples, like the other <c>Fit</c>, from spans of 3 N numbers.</summary>
        /// <param name="points">The N points.</param>
        /// <param name="normals">The N outward normals.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
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

        /// <summary>Fits f to samples, like the other <c>Fit</c>, from arrays of 3 N numbers.</summary>
        /// <param name="points">The N points.</param>
        /// <param name="normals">The N outward normals.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        public static Model Fit(
            double[] points, double[] normals, FitOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default)
        {
            return Fit((ArrayView)points, (ArrayView)normals, options, context, progress, cancellationToken);
        }

        /// <summary>Fits f to samples, like the other <c>Fit</c>, from arrays of 3 N numbers.</summary>
        /// <param name="points">The N points.</param>
        /// <param name="normals">The N outward normals.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the fit.</param>
        public static Model Fit(
            float[] points, float[] normals, FitOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default)
        {
            return Fit((ArrayView)points, (ArrayView)normals, options, context, progress, cancellationToken);
        }

        /// <summary>Evaluates f, its gradient and its Hessian at n points, into spans.</summary>
        /// <param name="points">3 n numbers: x, y, z of each point.</param>
        /// <param name="value">Receives n values; may be empty.</param>
        /// <param name="gradient">Receives 3 n derivatives; may be empty.</param>
        /// <param name="hessian">Receives 6 n derivatives, xx xy xz yy yz zz; may be empty.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call; some of the results may have been written by then.</param>
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

        /// <summary>Loads a saved model, like the other <c>Load</c>.</summary>
        /// <param name="data">The whole saved model.</param>
        /// <param name="context">The context; null = the default context.</param>
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
