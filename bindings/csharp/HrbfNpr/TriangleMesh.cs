// SPDX-License-Identifier: MIT
using System;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// A triangle mesh, welded, oriented, and without the parts that lie inside others.  Immutable: any number of
    /// threads may use it at a time.
    /// </summary>
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

        /// <summary>Makes a mesh.</summary>
        /// <param name="vertices">n points.</param>
        /// <param name="triangles">Three numbers of vertices each, from 0, counter-clockwise as seen from outside.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null; called on this thread with a number in [0, 1].</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An index is no vertex's (the message names the face and the
        /// index), a corner is not finite, or no face has an area.</exception>
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

        /// <summary>What making it found, and did.</summary>
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

        /// <summary>The mesh's own arrays; nothing is copied.</summary>
        /// <param name="attribute">What of it.</param>
        public NativeView View(MeshAttribute attribute)
        {
            hrbfnpr_array view;
            hrbfnpr_error error = Errors.New();
            Errors.Check(NativeMethods.hrbfnpr_mesh_view(handle, (uint)attribute, &view, &error), &error);
            return new NativeView(handle.Share(), view);
        }

        /// <summary>Points with unit normals, even over the mesh's area; every prefix is even.</summary>
        /// <param name="count">1 to 10000000.</param>
        /// <param name="normals">Three numbers for each point.</param>
        /// <param name="randomSeed">Any number.</param>
        /// <param name="candidates">Random places to choose from; 0 = 40 for each point, 1000000 at most.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>Three numbers for each point.</returns>
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
        /// Finds sharp edges and the smooth patches between them, as <see cref="Model.FitMesh"/> does.  Any number of
        /// threads may call it at a time.
        /// </summary>
        /// <param name="sharp">Three numbers for each face: 1 where the edge from that corner to the next one is sharp,
        /// else 0.</param>
        /// <param name="patches">The number of each face's patch, from 0 in the order of their first faces.</param>
        /// <param name="edges">Which edges are sharp: by default those of shapes with edges.</param>
        /// <param name="creaseAngle">Degrees between the normals of two faces, 1 to 179: edges that bend more are
        /// sharp.</param>
        /// <param name="far">Coarse faces that a round surface would leave by four fifths of this stay flat, with sharp
        /// edges; in units of the mesh, 0 = 0.01 of its diagonal.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        public MeshEdgesInfo FindEdges(
            out int[] sharp, out int[] patches, MeshEdges edges = MeshEdges.Auto, double creaseAngle = 30,
            double far = 0, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            patches = new int[Info.Faces];
            sharp = new int[3 * patches.Length];
            hrbfnpr_mesh_edges_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_mesh_edges_desc_init(&desc, (uint)sizeof(hrbfnpr_mesh_edges_desc)));
            desc.edges = (uint)edges;
            desc.crease_angle = creaseAngle;
            desc.far = far;
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
        /// Farthest-point order: each point the farthest from those before it, so that every prefix is even.
        /// </summary>
        /// <param name="points">n points.</param>
        /// <param name="count">1 to n.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>Numbers of points; the first is the one nearest to the middle of the bounding box.</returns>
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

        /// <summary>Lets go of the mesh; models that were fitted to it do not need it.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
