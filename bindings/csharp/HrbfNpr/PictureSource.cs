// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>What a picture is drawn of: points, a mesh, a model, or a point set.</summary>
    /// <remarks>Arrays are read while a picture is made, and not kept.  A model and a point set are kept by
    /// it.</remarks>
    /// <example>
    /// <code>
    /// Picture.Draw(PictureSource.FromPoints(points, normals)); // double[] or float[] of x, y, z
    /// Picture.Draw(PictureSource.FromMesh(vertices, triangles));
    /// Picture.Draw(model);
    /// </code>
    /// </example>
    public sealed class PictureSource
    {
        private PictureSource()
        {
        }

        /// <summary>Points, or the vertices of the triangles; not given of a model or point set.</summary>
        public ArrayView Points { get; private set; }

        /// <summary>Normals of points; not given = none.</summary>
        public ArrayView Normals { get; private set; }

        /// <summary>Three numbers of vertices for each face; not given of points.</summary>
        public ArrayView Triangles { get; private set; }

        /// <summary>The surface; null of points, a mesh, or a point set alone.</summary>
        public Model Model { get; private set; }

        /// <summary>The marks; null of points and of a mesh.</summary>
        public PointSet PointSet { get; private set; }

        /// <summary>
        /// Sharp edges of a mesh: pairs of numbers of vertices, int, uint or long, whose faces have normals of their
        /// own in its file.  An array without numbers says that there are none; not given = not known (default).
        /// </summary>
        public ArrayView SharpEdges { get; set; }

        /// <summary>Which way is up by the convention of the file's format; null = not known (default).</summary>
        public Vector3d? Up { get; set; }

        /// <summary>Why, for the note, such as "PLY files"; null = "files of this kind".</summary>
        public string UpBy { get; set; }

        /// <summary>Where the scanner stood; null = not known (default).</summary>
        public Vector3d? Viewpoint { get; set; }

        /// <summary>
        /// Whether the points are one picture of a depth camera that stood at <see cref="Viewpoint"/>; no by default.
        /// </summary>
        public bool IsPhoto { get; set; }

        /// <summary>
        /// Columns of a depth camera's image, whose points stand row by row; 0 = it is none (default).
        /// </summary>
        public long Columns { get; set; }

        /// <summary>Rows of that image.</summary>
        public long Rows { get; set; }

        /// <summary>Name of the file, for titles and metadata; null = none.</summary>
        public string Name { get; set; }

        /// <summary>Points, with normals or without.</summary>
        /// <param name="points">n points; those that are not finite are left out.</param>
        /// <param name="normals">n normals of any length; not given, or all zero, = none.</param>
        public static PictureSource FromPoints(ArrayView points, ArrayView normals = default(ArrayView))
        {
            return new PictureSource { Points = points, Normals = normals };
        }

        /// <summary>A mesh of triangles.</summary>
        /// <param name="vertices">n points, float or double.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0; int, uint or long.</param>
        public static PictureSource FromMesh(ArrayView vertices, ArrayView triangles)
        {
            if (!triangles.IsGiven)
            {
                throw new ArgumentNullException(nameof(triangles));
            }
            return new PictureSource { Points = vertices, Triangles = triangles };
        }

        /// <summary>A surface, with marks that are used as they are, or without.</summary>
        /// <param name="model">The surface.</param>
        /// <param name="marks">null = they are placed.</param>
        public static PictureSource FromModel(Model model, PointSet marks = null)
        {
            return new PictureSource
            {
                Model = model ?? throw new ArgumentNullException(nameof(model)),
                PointSet = marks,
            };
        }

        /// <summary>Marks alone: they draw the contours.</summary>
        /// <param name="marks">The marks.</param>
        public static PictureSource FromPointSet(PointSet marks)
        {
            return new PictureSource { PointSet = marks ?? throw new ArgumentNullException(nameof(marks)) };
        }

        /// <summary>As <see cref="FromModel"/>.</summary>
        public static implicit operator PictureSource(Model model)
        {
            return FromModel(model);
        }

        /// <summary>As <see cref="FromPointSet"/>.</summary>
        public static implicit operator PictureSource(PointSet marks)
        {
            return FromPointSet(marks);
        }

#if NET7_0_OR_GREATER
        /// <summary>As the other <c>FromPoints</c>, from spans of 3 n numbers, which are copied.</summary>
        /// <param name="points">n points.</param>
        /// <param name="normals">n normals, or empty.</param>
        public static PictureSource FromPoints(ReadOnlySpan<double> points, ReadOnlySpan<double> normals = default)
        {
            return FromPoints(points.ToArray(), normals.IsEmpty ? null : normals.ToArray());
        }

        /// <summary>As the other <c>FromPoints</c>, from spans of 3 n numbers, which are copied.</summary>
        /// <param name="points">n points.</param>
        /// <param name="normals">n normals, or empty.</param>
        public static PictureSource FromPoints(ReadOnlySpan<float> points, ReadOnlySpan<float> normals = default)
        {
            return FromPoints(points.ToArray(), normals.IsEmpty ? null : normals.ToArray());
        }

        /// <summary>As the other <c>FromPoints</c>, from arrays of 3 n numbers.</summary>
        /// <param name="points">n points.</param>
        /// <param name="normals">n normals, or null.</param>
        public static PictureSource FromPoints(double[] points, double[] normals = null)
        {
            return FromPoints((ArrayView)points, (ArrayView)normals);
        }

        /// <summary>As the other <c>FromPoints</c>, from arrays of 3 n numbers.</summary>
        /// <param name="points">n points.</param>
        /// <param name="normals">n normals, or null.</param>
        public static PictureSource FromPoints(float[] points, float[] normals = null)
        {
            return FromPoints((ArrayView)points, (ArrayView)normals);
        }

        /// <summary>As the other <c>FromMesh</c>, from spans, which are copied.</summary>
        /// <param name="vertices">3 n numbers.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(ReadOnlySpan<double> vertices, ReadOnlySpan<int> triangles)
        {
            return FromMesh(vertices.ToArray(), triangles.ToArray());
        }

        /// <summary>As the other <c>FromMesh</c>, from spans, which are copied.</summary>
        /// <param name="vertices">3 n numbers.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(ReadOnlySpan<float> vertices, ReadOnlySpan<int> triangles)
        {
            return FromMesh(vertices.ToArray(), triangles.ToArray());
        }

        /// <summary>As the other <c>FromMesh</c>, from arrays.</summary>
        /// <param name="vertices">3 n numbers.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(double[] vertices, int[] triangles)
        {
            return FromMesh((ArrayView)vertices, (ArrayView)triangles);
        }

        /// <summary>As the other <c>FromMesh</c>, from arrays.</summary>
        /// <param name="vertices">3 n numbers.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(float[] vertices, int[] triangles)
        {
            return FromMesh((ArrayView)vertices, (ArrayView)triangles);
        }
#endif

        /// <summary>Looks at the source without drawing it.</summary>
        /// <exception cref="InvalidArgumentException">A field of the source makes no sense.</exception>
        public SourceInfo Inspect()
        {
            return Inspect(out _);
        }

        /// <summary>Looks at the source without drawing it.</summary>
        /// <param name="notes">The findings.  Severity Note: a picture repairs it; Warning: it is wrong, with
        /// advice; Failure: a note <see cref="NoteCode.NotUsable"/> that says why it cannot be drawn.</param>
        /// <param name="wording">How notes name options.</param>
        /// <param name="context">The default context if null.</param>
        /// <param name="progress">May be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A field of the source makes no sense.</exception>
        public unsafe SourceInfo Inspect(
            out IReadOnlyList<Note> notes, Wording wording = Wording.Fields, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            var found = new List<Note>();
            notes = found;
            Action<PictureEvent> onEvent = happened =>
            {
                if (happened.Note != null)
                {
                    found.Add(happened.Note);
                }
            };
            var state = new PictureState(onEvent, null, Model == null ? null : Model.Function);
            using (var pins = new Pins())
            using (var held = new HeldHandles())
            using (var user = new UserHandle(state))
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_picture_source source;
                Write(&source, pins, held);
                SourceInfo info;
                Errors.Check(NativeMethods.hrbfnpr_source_info_init(&info, (uint)sizeof(SourceInfo)));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_source_inspect(
                    context.Handle, &source, (uint)wording, PictureState.Function, user.Pointer, call.Operation,
                    &info, &error);
                state.Check(call, status, &error);
                return info;
            }
        }

        internal unsafe void Write(hrbfnpr_picture_source* source, Pins pins, HeldHandles held)
        {
            Errors.Check(
                NativeMethods.hrbfnpr_picture_source_init(source, (uint)sizeof(hrbfnpr_picture_source)));
            source->flags = (SharpEdges.IsGiven ? 1u : 0) | (Viewpoint.HasValue ? 2u : 0) | (IsPhoto ? 4u : 0);
            source->points = Points.ToNative(pins, 3, nameof(Points));
            source->normals = Normals.ToNative(pins, 3, nameof(Normals));
            source->triangles = Triangles.ToNative(pins, 3, nameof(Triangles));
            source->sharp_edges = SharpEdges.ToNative(pins, 2, nameof(SharpEdges));
            source->model = Model == null ? IntPtr.Zero : held.Hold(Model.Handle);
            source->point_set = PointSet == null ? IntPtr.Zero : held.Hold(PointSet.Handle);
            *(Vector3d*)source->up = Up.GetValueOrDefault();
            source->up_by = pins.Text(UpBy);
            *(Vector3d*)source->viewpoint = Viewpoint.GetValueOrDefault();
            source->columns = Columns;
            source->rows = Rows;
            source->name = pins.Text(Name);
        }
    }
}
