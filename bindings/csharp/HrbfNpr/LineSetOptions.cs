// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    /// <summary>Lines to find once, when a line set is made.</summary>
    public sealed class LineOptions
    {
        /// <summary>Creates options with all defaults.</summary>
        /// <param name="kind">The kind of lines: Ridge, Valley, Parabolic, Section, Own, SoftEdge or TangentEdge.</param>
        public LineOptions(LineKind kind = LineKind.Ridge)
        {
            Kind = kind;
        }

        /// <summary>The kind of lines: Ridge, Valley, Parabolic, Section, Own, SoftEdge or TangentEdge; default Ridge.</summary>
        public LineKind Kind { get; set; }

        /// <summary>
        /// Name by which <see cref="NamedStyle.Name"/> selects these lines, up to 63 bytes of UTF-8; default null = "".
        /// </summary>
        public string Name { get; set; }

        /// <summary>
        /// Least strength at which a line goes on; 0 or more; default 0.  If it and <see cref="Upper"/> are 0, it is 6
        /// for ridges and valleys, and 0 for other kinds.
        /// </summary>
        public double Lower { get; set; }

        /// <summary>
        /// Strength that a line must reach somewhere, or it is dropped; not below <see cref="Lower"/>; default 0.  If
        /// both are 0, it is 15 for ridges and valleys, and 0 for other kinds.
        /// </summary>
        public double Upper { get; set; }

        /// <summary>Length below which a line is dropped, in diagonals; 0 or more; default 0.01.</summary>
        public double Shortest { get; set; } = 0.01;

        /// <summary>Section: normal of the planes, of any length but 0; default (0, 0, 1).</summary>
        public Vector3d Plane { get; set; } = (0, 0, 1);

        /// <summary>Section: places of the planes along the unit normal, in units of the model; at least one.</summary>
        public double[] Levels { get; set; }

        /// <summary>Own: points of all lines, absolute, on the surface or near it; float or double.</summary>
        public ArrayView Positions { get; set; }

        /// <summary>
        /// Own: number of the first position of each line, ascending, then the end of the last line; uint.  A line
        /// whose last position equals its first is closed.
        /// </summary>
        public ArrayView LineFirst { get; set; }

        /// <summary>Creates options for cuts of the surface by parallel planes.</summary>
        /// <param name="plane">The normal of the planes, of any length but 0.</param>
        /// <param name="levels">The places of the planes along the unit normal, in units of the model.</param>
        public static LineOptions Section(Vector3d plane, params double[] levels)
        {
            return new LineOptions(LineKind.Section) { Plane = plane, Levels = levels };
        }

        /// <summary>Creates options for polylines of the program.</summary>
        /// <param name="positions">The points of all lines, as in <see cref="Positions"/>.</param>
        /// <param name="lineFirst">The first position of each line, as in <see cref="LineFirst"/>.</param>
        /// <param name="name">The name for styles, as in <see cref="Name"/>.</param>
        public static LineOptions Own(ArrayView positions, ArrayView lineFirst, string name = null)
        {
            return new LineOptions(LineKind.Own) { Positions = positions, LineFirst = lineFirst, Name = name };
        }

        internal unsafe void Write(hrbfnpr_line_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_line_desc_init(desc, (uint)sizeof(hrbfnpr_line_desc)));
            desc->kind = (uint)Kind;
            desc->name = pins.Text(Name);
            desc->lower = Lower;
            desc->upper = Upper;
            desc->shortest = Shortest;
            *(Vector3d*)desc->plane = Plane;
            desc->levels = ((ArrayView)Levels).ToNative(pins, 1, nameof(Levels));
            desc->position = Positions.ToNative(pins, 3, nameof(Positions));
            desc->line_first = LineFirst.ToNative(pins, 1, nameof(LineFirst));
        }
    }

    /// <summary>How a line set is made; a new one holds all defaults.</summary>
    /// <example>
    /// <code>
    /// model.LineSet(new LineSetOptions
    /// {
    ///     WithCurvature = true, // for suggestive contours, apparent ridges and isophotes
    ///     Lines = { new LineOptions(LineKind.Ridge), LineOptions.Section((0, 0, 1), -0.5, 0, 0.5) },
    /// });
    /// </code>
    /// </example>
    public sealed class LineSetOptions
    {
        /// <summary>
        /// Side of the cells in which curves are searched, in units of the model; 0 or more; default 0 = half the
        /// samples' spacing, and finer where walls are thin.  Loops smaller than a cell and walls thinner than 1.75
        /// cells may be missed.
        /// </summary>
        public double CellSize { get; set; }

        /// <summary>
        /// n points near each part of the surface, where the search begins; float or double; default not given = the
        /// samples, or places found within the bounds of a model from a function.
        /// </summary>
        public ArrayView SeedPoints { get; set; }

        /// <summary>
        /// Limit of the support beyond which the surface ends because samples are missing, as in an open scan or a
        /// terrain; 0 or more; default 0 = the surface ends where its model does.
        /// </summary>
        /// <remarks>
        /// 1.5 ends the surface about 0.7 sample spacings beyond the last samples. 3 ends it about 0.9 spacings beyond
        /// them, and leaves larger holes closed.  The end is drawn as a <see cref="LineKind.Border"/>.
        /// </remarks>
        public double Support { get; set; }

        /// <summary>
        /// n samples that <see cref="Support"/> is measured from; float or double; default not given = the model's
        /// centres.  All points of a scan show where it ends better than the centres chosen from them.
        /// </summary>
        public ArrayView SupportPoints { get; set; }

        /// <summary>
        /// Normals of <see cref="SupportPoints"/>, of any length but 0; float or double; default not given = normals of
        /// the surface there.
        /// </summary>
        public ArrayView SupportNormals { get; set; }

        /// <summary>
        /// The mesh that the model was fitted to; default null.  Its triangles find lines where walls are thinner than
        /// cells.  The line set does not keep it.  Ignored with a <see cref="CellSize"/>, and if it has edges that are not
        /// manifold or whose faces do not agree.
        /// </summary>
        public TriangleMesh Mesh { get; set; }

        /// <summary>
        /// Whether to measure curvatures and their derivatives, which suggestive contours, apparent ridges and
        /// isophotes need; default false.
        /// </summary>
        public bool WithCurvature { get; set; }

        /// <summary>Lines to find once; default empty.  Contours and borders need no element.</summary>
        public IList<LineOptions> Lines { get; } = new List<LineOptions>();

        internal unsafe void Write(hrbfnpr_line_set_desc* desc, Pins pins, HeldHandles held)
        {
            Errors.Check(NativeMethods.hrbfnpr_line_set_desc_init(desc, (uint)sizeof(hrbfnpr_line_set_desc)));
            desc->flags = WithCurvature ? 1u : 0;
            desc->cell_size = CellSize;
            desc->seed_points = SeedPoints.ToNative(pins, 3, nameof(SeedPoints));
            desc->support = Support;
            desc->support_points = SupportPoints.ToNative(pins, 3, nameof(SupportPoints));
            desc->support_normals = SupportNormals.ToNative(pins, 3, nameof(SupportNormals));
            if (Mesh != null)
            {
                desc->mesh = held.Hold(Mesh.Handle);
            }
            if (Lines.Count == 0)
            {
                return;
            }
            var lines = new hrbfnpr_line_desc[Lines.Count];
            var first = (hrbfnpr_line_desc*)pins.Pin(lines);
            for (int i = 0; i < lines.Length; ++i)
            {
                LineOptions line = Lines[i] ?? throw new ArgumentNullException(nameof(Lines));
                line.Write(first + i, pins);
            }
            desc->lines = (IntPtr)first;
            desc->line_count = lines.Length;
        }
    }
}
