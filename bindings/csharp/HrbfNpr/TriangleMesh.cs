// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// A triangle mesh that has been repaired: vertices are joined, faces are turned to agree, and components inside
    /// others are left out.
    /// </summary>
    /// <remarks>A mesh never changes, so several threads may use it at the same time.</remarks>
    /// <example>
    /// <code>
    /// using (var mesh = new TriangleMesh(vertices, triangles)) // double[] or float[], int[]
    /// using (Model model = Model.FitMesh(mesh, out MeshFitInfo info))
    /// {
    ///     MeshComparison error = model.Compare(mesh);
    /// }
    /// </code>
    /// </example>
    public sealed unsafe class TriangleMesh : IDisposable
    {
        private readonly MeshHandle handle;

        /// <summary>Makes a mesh from triangles, and repairs it.</summary>
        /// <param name="vertices">The n vertices.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0, counter-clockwise as seen from
        /// outside.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A corner is not the number of a vertex, or its vertex is not
        /// finite (the message names the face and the index), or no face is left.</exception>
        /// <exception cref="CancelledException">The call was cancelled.</exception>
        public TriangleMesh(
            ArrayView vertices, ArrayView triangles, MeshOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            hrbfnpr_mesh_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_mesh_desc_init(&desc, (uint)sizeof(hrbfnpr_mesh_desc)));
            (options ?? new MeshOptions()).Write(ref desc);
            handle = new MeshHandle();
            using (var pins = new Pins())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                desc.vertices = vertices.ToNative(pins, 3, nameof(vertices));
                desc.triangles = triangles.ToNative(pins, 3, nameof(triangles));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_mesh_create(
                    context.Handle, &desc, call.Operation, out IntPtr created, &error);
                handle.Take(created, context.Anchor);
                try
                {
                    call.Check(status, &error, null);
                }
                catch
                {
                    handle.Dispose();
                    throw;
                }
            }
        }

        internal TriangleMesh(MeshHandle handle)
        {
            this.handle = handle;
        }

        /// <summary>What making the mesh found and did.</summary>
        public MeshInfo Info
        {
            get
            {
                MeshInfo info;
                Errors.Check(NativeMethods.hrbfnpr_mesh_info_init(&info, (uint)sizeof(MeshInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_mesh_get_info(handle, &info, &error), &error);
                return info;
            }
        }

        internal MeshHandle Handle
        {
            get { return handle; }
        }

        /// <summary>Gives a view of an array of the mesh, without a copy.</summary>
        /// <param name="attribute">The array.</param>
        public NativeView View(MeshAttribute attribute)
        {
            hrbfnpr_array view;
            hrbfnpr_error error = Errors.New();
            Errors.Check(NativeMethods.hrbfnpr_mesh_view(handle, (uint)attribute, &view, &error), &error);
            return new NativeView(handle.Share(), view);
        }

        /// <summary>Samples the mesh evenly, with unit normals.  Every prefix of the samples is even.</summary>
        /// <param name="count">The number of samples; 1 to 10000000.</param>
        /// <param name="normals">Receives three numbers for each sample.</param>
        /// <param name="randomSeed">The seed of the places; any number.</param>
        /// <param name="candidates">The number of random places to choose from; 0 to 1000000; 0 = 40 for each sample,
        /// up to 1000000.  More: more even samples, in more time.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>Three numbers for each sample.</returns>
        public double[] Sample(
            int count, out double[] normals, ulong randomSeed = 1, long candidates = 0,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            var points = new double[3 * Math.Max(count, 0)];
            normals = new double[points.Length];
            hrbfnpr_sample_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_sample_desc_init(&desc, (uint)sizeof(hrbfnpr_sample_desc)));
            desc.random_seed = randomSeed;
            desc.candidates = candidates;
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_array at = ((ArrayView)points).ToNative(pins, 3, nameof(count));
                hrbfnpr_array along = ((ArrayView)normals).ToNative(pins, 3, nameof(count));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_mesh_sample(handle, &desc, &at, &along, call.Operation, &error);
                call.Check(status, &error, null);
            }
            return points;
        }

        /// <summary>
        /// Finds sharp edges and the smooth patches between them, as <see cref="Model.FitMesh"/> does.
        /// </summary>
        /// <remarks>Several threads may call it at the same time.</remarks>
        /// <param name="sharp">Receives three numbers for each face: 1 if the edge from that corner to the next one is
        /// sharp, 2 if it is a tangent edge, else 0.</param>
        /// <param name="patches">Receives the number of each face's patch, from 0 in the order of their first
        /// faces.</param>
        /// <param name="edges">Which edges are sharp; default Auto.</param>
        /// <param name="creaseAngle">The angle between the normals of two faces, in degrees, above which their edge is
        /// sharp; 1 to 179.</param>
        /// <param name="far">The distance that decides about coarse faces, in units of the mesh; 0 or more; 0 = 0.01
        /// diagonals.  Faces stay flat, with sharp edges, if a round surface would leave them by more than four fifths
        /// of it.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <param name="tangent">Whether tangent edges are found, too, as those of fillets.</param>
        public MeshEdgesInfo FindEdges(
            out int[] sharp, out int[] patches, MeshEdges edges = MeshEdges.Auto, double creaseAngle = 30,
            double far = 0, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken), bool tangent = false)
        {
            patches = new int[Info.Faces];
            sharp = new int[3 * patches.Length];
            hrbfnpr_mesh_edges_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_mesh_edges_desc_init(&desc, (uint)sizeof(hrbfnpr_mesh_edges_desc)));
            desc.edges = (uint)edges;
            desc.crease_angle = creaseAngle;
            desc.far = far;
            desc.tangent = tangent ? 1u : 0;
            MeshEdgesInfo info;
            Errors.Check(NativeMethods.hrbfnpr_mesh_edges_info_init(&info, (uint)sizeof(MeshEdgesInfo)));
            using (var pins = new Pins())
            using (var call = new LongCall(handle, progress, cancellationToken))
            {
                hrbfnpr_array of = ((ArrayView)patches).ToNative(pins, 1, nameof(patches));
                hrbfnpr_array at = ((ArrayView)sharp).ToNative(pins, 3, nameof(sharp));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_mesh_edges(
                    handle, &desc, &of, &at, &info, call.Operation, &error);
                call.Check(status, &error, null);
            }
            return info;
        }

        /// <summary>
        /// Orders points so that each is the farthest from those before it, so that every prefix is an even choice.
        /// </summary>
        /// <param name="points">The n points.</param>
        /// <param name="count">The number of points to order; 1 to n.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>Numbers of points.  The first is the point nearest to the middle of the bounding box.</returns>
        public static long[] FarthestPoints(
            ArrayView points, int count, Context context = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            var indices = new long[Math.Max(count, 0)];
            using (var pins = new Pins())
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_array from = points.ToNative(pins, 3, nameof(points));
                hrbfnpr_array to = ((ArrayView)indices).ToNative(pins, 1, nameof(count));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_farthest_points(
                    context.Handle, &from, &to, null, call.Operation, &error);
                call.Check(status, &error, null);
            }
            return indices;
        }

        /// <summary>Releases the mesh.  Models that were fitted to it do not need it.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
