// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>Values of a source's points, such as the colours or a quality of a mesh's vertices.</summary>
    public sealed class SourceField
    {
        /// <summary>Makes a field.</summary>
        /// <param name="name">Name for styles.</param>
        /// <param name="values">A number for each point, or three for colours and directions.</param>
        /// <param name="kind">What the values are.</param>
        public SourceField(string name, ArrayView values, FieldKind kind = FieldKind.Scalar)
        {
            Name = name ?? throw new ArgumentNullException(nameof(name));
            Values = values;
            Kind = kind;
        }

        /// <summary>What the values are.</summary>
        public FieldKind Kind { get; }

        /// <summary>Name for styles, 1 to 63 bytes of UTF-8.</summary>
        public string Name { get; }

        /// <summary>The values; float, double or byte.  Colours of bytes are 0 to 255.</summary>
        public ArrayView Values { get; }

        internal unsafe void Write(hrbfnpr_source_field* field, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_source_field_init(field, (uint)sizeof(hrbfnpr_source_field)));
            field->kind = (uint)Kind;
            field->name = pins.Text(Name);
            field->values = Values.ToNative(pins, Kind == FieldKind.Scalar ? 1 : 3, nameof(Values));
        }
    }

    /// <summary>A source of a picture: points, a mesh, a model, or a point set.</summary>
    /// <remarks>
    /// Arrays are read while a picture is made, and are not kept.  The picture keeps a model and a point set.
    /// </remarks>
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

        /// <summary>The points, or the vertices of the triangles; not given for a model or a point set.</summary>
        public ArrayView Points { get; private set; }

        /// <summary>The normals of the points; not given = no normals.</summary>
        public ArrayView Normals { get; private set; }

        /// <summary>The triangles of a mesh, as numbers of points from 0; not given for points.</summary>
        public ArrayView Triangles { get; private set; }

        /// <summary>The model; null for points, a mesh, or a point set alone.</summary>
        public Model Model { get; private set; }

        /// <summary>The marks; null for points and for a mesh.</summary>
        public PointSet PointSet { get; private set; }

        /// <summary>
        /// Edges of a mesh, as pairs of vertices, whose faces have separate normals in the file; int, uint or long;
        /// default not given = not known.  An empty array says that there are no such edges.
        /// </summary>
        public ArrayView SharpEdges { get; set; }

        /// <summary>Direction that is up by the convention of the file's format; default null = not known.</summary>
        public Vector3d? Up { get; set; }

        /// <summary>
        /// Reason for <see cref="Up"/> in notes, such as "PLY files"; default null = "files of this kind".
        /// </summary>
        public string UpBy { get; set; }

        /// <summary>Place where the scanner stood; default null = not known.</summary>
        public Vector3d? Viewpoint { get; set; }

        /// <summary>
        /// Whether the points are one image of a depth camera that stood at <see cref="Viewpoint"/>; default false.
        /// </summary>
        public bool IsPhoto { get; set; }

        /// <summary>
        /// Number of columns of a depth camera's image, whose points are given row by row; default 0 = the points are
        /// no image.
        /// </summary>
        public long Columns { get; set; }

        /// <summary>Number of rows of that image; default 0.</summary>
        public long Rows { get; set; }

        /// <summary>Name of the file, for titles and metadata; default null = none.</summary>
        public string Name { get; set; }

        /// <summary>
        /// Values of the points or vertices.  A style that names one gets it, as do the changes "style.field".
        /// </summary>
        public IList<SourceField> Fields { get; } = new List<SourceField>();

        /// <summary>Makes a source of points, with or without normals.</summary>
        /// <param name="points">The n points.  Points that are not finite are left out.</param>
        /// <param name="normals">The n normals, of any length; not given, or all zero = no normals.</param>
        public static PictureSource FromPoints(ArrayView points, ArrayView normals = default(ArrayView))
        {
            return new PictureSource { Points = points, Normals = normals };
        }

        /// <summary>Makes a source of a mesh.</summary>
        /// <param name="vertices">The n vertices, float or double.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0; int, uint or long.</param>
        public static PictureSource FromMesh(ArrayView vertices, ArrayView triangles)
        {
            if (!triangles.IsGiven)
            {
                throw new ArgumentNullException(nameof(triangles));
            }
            return new PictureSource { Points = vertices, Triangles = triangles };
        }

        /// <summary>Makes a source of a model, with marks that are used as they are, or without marks.</summary>
        /// <param name="model">The model.</param>
        /// <param name="marks">The marks; null = the picture places them.</param>
        public static PictureSource FromModel(Model model, PointSet marks = null)
        {
            return new PictureSource
            {
                Model = model ?? throw new ArgumentNullException(nameof(model)),
                PointSet = marks,
            };
        }

        /// <summary>Makes a source of marks without a model.  No lines are drawn, because lines need a model.</summary>
        /// <param name="marks">The marks.</param>
        public static PictureSource FromPointSet(PointSet marks)
        {
            return new PictureSource { PointSet = marks ?? throw new ArgumentNullException(nameof(marks)) };
        }

        /// <summary>Makes a source of a model without marks.</summary>
        public static implicit operator PictureSource(Model model)
        {
            return FromModel(model);
        }

        /// <summary>Makes a source of marks without a model.</summary>
        public static implicit operator PictureSource(PointSet marks)
        {
            return FromPointSet(marks);
        }

#if NET7_0_OR_GREATER
        /// <summary>Makes a source of points from spans of 3 n numbers, which are copied.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="normals">The n normals; empty = no normals.</param>
        public static PictureSource FromPoints(ReadOnlySpan<double> points, ReadOnlySpan<double> normals = default)
        {
            return FromPoints(points.ToArray(), normals.IsEmpty ? null : normals.ToArray());
        }

        /// <summary>Makes a source of points from spans of 3 n numbers, which are copied.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="normals">The n normals; empty = no normals.</param>
        public static PictureSource FromPoints(ReadOnlySpan<float> points, ReadOnlySpan<float> normals = default)
        {
            return FromPoints(points.ToArray(), normals.IsEmpty ? null : normals.ToArray());
        }

        /// <summary>Makes a source of points from arrays of 3 n numbers.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="normals">The n normals; null = no normals.</param>
        public static PictureSource FromPoints(double[] points, double[] normals = null)
        {
            return FromPoints((ArrayView)points, (ArrayView)normals);
        }

        /// <summary>Makes a source of points from arrays of 3 n numbers.</summary>
        /// <param name="points">The n points.</param>
        /// <param name="normals">The n normals; null = no normals.</param>
        public static PictureSource FromPoints(float[] points, float[] normals = null)
        {
            return FromPoints((ArrayView)points, (ArrayView)normals);
        }

        /// <summary>Makes a source of a mesh from spans, which are copied.</summary>
        /// <param name="vertices">3 n numbers: x, y, z of each vertex.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(ReadOnlySpan<double> vertices, ReadOnlySpan<int> triangles)
        {
            return FromMesh(vertices.ToArray(), triangles.ToArray());
        }

        /// <summary>Makes a source of a mesh from spans, which are copied.</summary>
        /// <param name="vertices">3 n numbers: x, y, z of each vertex.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(ReadOnlySpan<float> vertices, ReadOnlySpan<int> triangles)
        {
            return FromMesh(vertices.ToArray(), triangles.ToArray());
        }

        /// <summary>Makes a source of a mesh from arrays.</summary>
        /// <param name="vertices">3 n numbers: x, y, z of each vertex.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(double[] vertices, int[] triangles)
        {
            return FromMesh((ArrayView)vertices, (ArrayView)triangles);
        }

        /// <summary>Makes a source of a mesh from arrays.</summary>
        /// <param name="vertices">3 n numbers: x, y, z of each vertex.</param>
        /// <param name="triangles">Three numbers of vertices for each face, from 0.</param>
        public static PictureSource FromMesh(float[] vertices, int[] triangles)
        {
            return FromMesh((ArrayView)vertices, (ArrayView)triangles);
        }
#endif

        /// <summary>Looks at the source without drawing it, and returns facts.</summary>
        /// <exception cref="InvalidArgumentException">A property of the source is wrong.</exception>
        public SourceInfo Inspect()
        {
            return Inspect(out _);
        }

        /// <summary>Looks at the source without drawing it, and returns facts and findings.</summary>
        /// <param name="notes">Receives the findings.  A Note is something that a picture repairs.  A Warning is
        /// something that is wrong, with advice.  A Failure, with the code <see cref="NoteCode.NotUsable"/>, says why
        /// the source cannot be drawn.</param>
        /// <param name="wording">How notes write the options that they name.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A property of the source is wrong.</exception>
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
            WriteFields(source, pins);
        }

        private unsafe void WriteFields(hrbfnpr_picture_source* source, Pins pins)
        {
            if (Fields.Count == 0)
            {
                return;
            }
            var structs = new hrbfnpr_source_field[Fields.Count];
            var first = (hrbfnpr_source_field*)pins.Pin(structs);
            for (int i = 0; i < structs.Length; ++i)
            {
                SourceField field = Fields[i] ?? throw new ArgumentNullException(nameof(Fields));
                field.Write(first + i, pins);
            }
            source->fields = (IntPtr)first;
            source->field_count = structs.Length;
        }
    }
}
