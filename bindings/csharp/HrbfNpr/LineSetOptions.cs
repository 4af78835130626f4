// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    /// <summary>Lines to find once, when a line set is made.</summary>
    public sealed class LineOptions
    {
        /// <summary>With all defaults of a kind.</summary>
        /// <param name="kind">Ridge, Valley, Parabolic, Section or Own.</param>
        public LineOptions(LineKind kind = LineKind.Ridge)
        {
            Kind = kind;
        }

        /// <summary>Ridge, Valley, Parabolic, Section or Own: others are found with every drawing.</summary>
        public LineKind Kind { get; set; }

        /// <summary>Up to 63 bytes of UTF-8, for <see cref="NamedStyle.Name"/>; null = empty.</summary>
        public string Name { get; set; }

        /// <summary>Lines go on while their strength, of no unit, is at least this, 0 or more ...</summary>
        public double Lower { get; set; }

        /// <summary>
        /// ... and are kept if it is this somewhere; not below <see cref="Lower"/>.  0 and 0 = those of the kind: 6
        /// and 15 of ridges and valleys, 0 and 0 else.
        /// </summary>
        public double Upper { get; set; }

        /// <summary>Shorter ones are dropped, in diagonals of the model, 0 or more; 0.01.</summary>
        public double Shortest { get; set; } = 0.01;

        /// <summary>Of Section: normal of the planes, of any length; (0, 0, 1).</summary>
        public Vector3d Plane { get; set; } = (0, 0, 1);

        /// <summary>Of Section, and needed there: where the planes are along the unit normal, units of the model.</summary>
        public double[] Levels { get; set; }

        /// <summary>Of Own: n points, absolute, on the surface or near it; float or double.</summary>
        public ArrayView Positions { get; set; }

        /// <summary>
        /// Of Own: L + 1 uint, rising: line i has the positions first[i] to first[i + 1] - 1.  One whose last position
        /// is its first is closed.
        /// </summary>
        public ArrayView LineFirst { get; set; }

        /// <summary>Where parallel planes cut the surface.</summary>
        /// <param name="plane">Normal of the planes, of any length.</param>
        /// <param name="levels">Where they are along the unit normal, units of the model.</param>
        public static LineOptions Section(Vector3d plane, params double[] levels)
        {
            return new LineOptions(LineKind.Section) { Plane = plane, Levels = levels };
        }

        /// <summary>Polylines of the program's own, which are copied.</summary>
        /// <param name="positions">As <see cref="Positions"/>.</param>
        /// <param name="lineFirst">As <see cref="LineFirst"/>.</param>
        /// <param name="name">As <see cref="Name"/>.</param>
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
        /// Of the mesh on which curves are looked for, units of the model; 0 = half the samples' spacing, and finer
        /// where walls are thin (default).  Loops that are smaller, and walls that are thinner than 1.75 cells, may be
        /// missed.
        /// </summary>
        public double CellSize { get; set; }

        /// <summary>
        /// n points, float or double, near each part of the surface; if not given, the samples, or places found in
        /// the bounds of a model from a function.
        /// </summary>
        public ArrayView SeedPoints { get; set; }

        /// <summary>
        /// Where the surface ends for want of samples, as an open scan or a terrain does, with a line of
        /// <see cref="LineKind.Border"/>: 1.5 ends it some 0.7 spacings beyond the last samples, 3 some 0.9; 0 = at
        /// the search box only (default).
        /// </summary>
        public double Support { get; set; }

        /// <summary>
        /// n points, float or double, that this is judged by; if not given, the model's centres.  All points of a
        /// scan tell better where it ends.
        /// </summary>
        public ArrayView SupportPoints { get; set; }

        /// <summary>Of <see cref="SupportPoints"/>, of any length; if not given, those of the surface there.</summary>
        public ArrayView SupportNormals { get; set; }

        /// <summary>
        /// Whether curvatures and their derivatives are measured, for kinds that need them with every drawing: no by
        /// default.
        /// </summary>
        public bool WithCurvature { get; set; }

        /// <summary>Lines to find once; none by default.  Contours and borders need none.</summary>
        public IList<LineOptions> Lines { get; } = new List<LineOptions>();

        internal unsafe void Write(hrbfnpr_line_set_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_line_set_desc_init(desc, (uint)sizeof(hrbfnpr_line_set_desc)));
            desc->flags = WithCurvature ? 1u : 0;
            desc->cell_size = CellSize;
            desc->seed_points = SeedPoints.ToNative(pins, 3, nameof(SeedPoints));
            desc->support = Support;
            desc->support_points = SupportPoints.ToNative(pins, 3, nameof(SupportPoints));
            desc->support_normals = SupportNormals.ToNative(pins, 3, nameof(SupportNormals));
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
