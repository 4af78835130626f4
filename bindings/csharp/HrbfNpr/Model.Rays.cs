// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>
        /// Finds where n rays origin + t direction meet the surface in the search box, by sphere tracing [Hart 1996].
        /// </summary>
        /// <remarks>
        /// The search may miss two hits that are closer than <see cref="CastOptions.SmallestStep"/> along the ray.  A
        /// ray that starts on the surface may or may not have a hit there.  A call with a few thousand rays on a fit
        /// prepares the model and is 30 to 60 times as fast, unless <see cref="CastOptions.Lipschitz"/> is given.
        /// </remarks>
        /// <param name="origins">The n origins, which may lie inside.</param>
        /// <param name="directions">The n directions, of any length but 0.</param>
        /// <param name="options">The options; null = all defaults: the first hit only.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">NaN, infinity, a zero direction, different counts of origins and
        /// directions, or an option out of its range.</exception>
        public RayHits CastRays(
            ArrayView origins, ArrayView directions, CastOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            options = options ?? new CastOptions();
            hrbfnpr_cast_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_cast_desc_init(&desc, (uint)sizeof(hrbfnpr_cast_desc)));
            long count = origins.CountOf(3, nameof(origins));
            // The library refuses numbers out of range before it writes anything.
            var result = new RayHits(count, Math.Max(1, Math.Min(options.MaximumHits, 256)));
            using (var held = new HeldHandles())
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                options.Write(ref desc, held);
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
        /// Computes the bound on |grad f| that <see cref="CastRays"/> uses if none is given.  It is an estimate, except
        /// for a solid of primitives.  If you cast few rays in each call, compute it once and pass it on.
        /// </summary>
        /// <remarks>The estimate is 1.5 times the largest |grad f| at 24^3 points of the search box.</remarks>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
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

        /// <summary>Tells which of n points lie inside: where f &lt; 0, within the search box.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
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

        /// <summary>Tells which of n points lie inside, into the caller's memory.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="inside">Receives a byte for each point: 1 inside, else 0; optional.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call; some of the results may have been written by then.</param>
        /// <returns>The number of points inside.</returns>
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
