// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>Where n rays origin + t direction meet the surface [Hart 1996, "Sphere tracing"].</summary>
        /// <param name="origins">n points; rays may start inside.</param>
        /// <param name="directions">n directions of any length but zero.</param>
        /// <param name="options">All defaults, the first hit, if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">NaN, infinity, a direction of zero, different numbers of
        /// origins and directions, an option out of its range.</exception>
        public RayHits CastRays(
            ArrayView origins, ArrayView directions, CastOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            options = options ?? new CastOptions();
            hrbfnpr_cast_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_cast_desc_init(&desc, (uint)sizeof(hrbfnpr_cast_desc)));
            options.Write(ref desc);
            long count = origins.CountOf(3, nameof(origins));
            // Numbers out of range are refused by the library, before it writes anything.
            var result = new RayHits(count, Math.Max(1, Math.Min(options.MaximumHits, 256)));
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_array from = origins.ToNative(pins, 3, nameof(origins));
                hrbfnpr_array along = directions.ToNative(pins, 3, nameof(directions));
                hrbfnpr_ray_hits hits;
                Errors.Check(NativeMethods.hrbfnpr_ray_hits_init(&hits, (uint)sizeof(hrbfnpr_ray_hits)));
                hits.count = ((ArrayView)result.Hits).ToNative(pins, 1, "hits");
                hits.t = ((ArrayView)result.T).ToNative(pins, result.Room, "t");
                hits.position = ((ArrayView)result.Position).ToNative(pins, result.Room * 3, "position");
                hits.normal = ((ArrayView)result.Normal).ToNative(pins, result.Room * 3, "normal");
                hits.entering = ((ArrayView)result.Entering).ToNative(pins, result.Room, "entering");
                hits.status = ArrayView.OfBytes(result.Status).ToNative(pins, 1, "status");
                hrbfnpr_error error = Errors.New();
                int failed = NativeMethods.hrbfnpr_model_cast_rays(
                    handle, &from, &along, &desc, &hits, call.Operation, &error);
                call.Check(failed, &error, function);
                result.HitRays = hits.hit_rays;
            }
            return result;
        }

        /// <summary>
        /// The bound that <see cref="CastRays"/> takes: the largest |grad f| at 24^3 points, times 1.5.  An estimate,
        /// and no proof.  Pass it on if you cast few rays at a time.
        /// </summary>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        public double Lipschitz(
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                double bound;
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_model_lipschitz(handle, &bound, call.Operation, &error);
                call.Check(status, &error, function);
                return bound;
            }
        }

        /// <summary>Which of n points lie inside: where f is negative, and in the bounds grown by 0.05 diagonals.</summary>
        /// <param name="points">n points.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A point is not finite.</exception>
        public bool[] Contains(
            ArrayView points, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            var inside = new byte[points.CountOf(3, nameof(points))];
            ContainsInto(points, inside, progress, cancellationToken);
            return Array.ConvertAll(inside, one => one != 0);
        }

        /// <summary>As <see cref="Contains"/>, into the caller's memory.</summary>
        /// <param name="points">n points.</param>
        /// <param name="inside">n bytes, 1 or 0, or not given.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call; a part of the results may then be written.</param>
        /// <returns>How many lie inside.</returns>
        public long ContainsInto(
            ArrayView points, ArrayView inside, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_array at = points.ToNative(pins, 3, nameof(points));
                hrbfnpr_array result = inside.ToNative(pins, 1, nameof(inside));
                long count;
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_model_contains(
                    handle, &at, inside.IsGiven ? &result : null, &count, call.Operation, &error);
                call.Check(status, &error, function);
                return count;
            }
        }
    }
}
