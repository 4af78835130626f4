// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// What <see cref="PictureSource.Inspect()"/> found.  A field that does not apply to the kind of source is 0.  If
    /// the source cannot be drawn, fields that were not examined any more are 0.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_source_info")]
    public unsafe struct SourceInfo
    {
        internal uint StructSize;
        private readonly uint kind;
        private readonly uint severity;
        private readonly uint normalsLook;

        /// <summary>
        /// Number of given points: points, vertices of a mesh, centres of a model, or marks of a point set.
        /// </summary>
        public readonly long Points;

        /// <summary>Number of given triangles.</summary>
        public readonly long Triangles;

        /// <summary>Number of points at a value that means "no data"; all following fields leave them out.</summary>
        public readonly long NoData;

        /// <summary>Number of points far from all others; all following fields leave them out.</summary>
        public readonly long Strays;

        /// <summary>Number of points without a finite position.</summary>
        public readonly long PointsNotFinite;

        /// <summary>Number of points, or vertices of faces, at the place of another.</summary>
        public readonly long Duplicates;

        /// <summary>Lower corner of the box around the finite points.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>Upper corner of the box.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Diagonal of these bounds.</summary>
        public readonly double Diagonal;

        /// <summary>
        /// Direction that a picture chooses as up, for points and meshes; <see cref="UpReason"/> says why.
        /// </summary>
        public readonly Vector3d Up;

        private readonly uint hasNormals;
        private readonly uint alongCurves;
        private readonly uint looksDown;
        private readonly uint reserved;

        /// <summary>Number of normals that are zero.</summary>
        public readonly long NormalsZero;

        /// <summary>Number of normals that are not finite.</summary>
        public readonly long NormalsNotFinite;

        /// <summary>Share of the usable normals that have length 1; 0 to 1.</summary>
        public readonly double NormalsUnitShare;

        /// <summary>
        /// Median over the samples of the sum of the winding numbers on both sides: 1 = closed and outward, -1 =
        /// inward, 0 = a flat sheet; 0 for points along curves.  Also set for faces.
        /// </summary>
        public readonly double NormalsClosed;

        /// <summary>
        /// Share of the normals that look flipped beside their neighbours; 0 to 1; 0 for points along curves.  Also set
        /// for faces.
        /// </summary>
        public readonly double NormalsFlippedShare;

        /// <summary>Number of pixels of a depth camera that have a point.</summary>
        public readonly long ImageSeen;

        /// <summary>Number of these pixels that lie on no surface.</summary>
        public readonly long ImageDropped;

        /// <summary>Median depth of the pixels that have a point.</summary>
        public readonly double ImageDepth;

        /// <summary>Standard deviation of the depth, at that depth.</summary>
        public readonly double ImageNoise;

        private readonly uint closed;
        private readonly uint insideOut;

        /// <summary>Number of parts of a mesh that share no vertex.</summary>
        public readonly long Components;

        /// <summary>
        /// Number of parts without a border whose faces look inward.  Such a part inside another one is a cavity.
        /// </summary>
        public readonly long ComponentsInsideOut;

        /// <summary>Number of edges with one face.</summary>
        public readonly long BoundaryEdges;

        /// <summary>Number of borders.</summary>
        public readonly long BoundaryLoops;

        /// <summary>Number of edges with more than two faces.</summary>
        public readonly long NonmanifoldEdges;

        /// <summary>Number of these edges that <see cref="TriangleMesh"/> cannot mend.</summary>
        public readonly long NonmanifoldLeft;

        /// <summary>Number of edges with two faces, one of which is turned over.</summary>
        public readonly long ContraryEdges;

        /// <summary>Number of faces with a corner that is not finite.</summary>
        public readonly long FacesNotFinite;

        /// <summary>Number of faces without area.</summary>
        public readonly long DegenerateFaces;

        /// <summary>Number of faces with the same corners as another.</summary>
        public readonly long RepeatedFaces;

        /// <summary>Number of vertices of no face.</summary>
        public readonly long UnusedVertices;

        /// <summary>Area, in squared units of the source.</summary>
        public readonly double Area;

        /// <summary>Enclosed volume, in cubed units of the source; 0 if the mesh is not closed.</summary>
        public readonly double Volume;

        private fixed byte upReason[128];

        /// <summary>Kind of the source.</summary>
        public SourceKind Kind
        {
            get { return (SourceKind)kind; }
        }

        /// <summary>
        /// Severity of the worst finding.  Info: no finding; Note: a picture repairs it; Warning: something is wrong;
        /// Failure: it cannot be drawn.
        /// </summary>
        public Severity Severity
        {
            get { return (Severity)severity; }
        }

        /// <summary>Which way the normals of points or faces look.</summary>
        public NormalsLook NormalsLook
        {
            get { return (NormalsLook)normalsLook; }
        }

        /// <summary>Whether some normals are given that are not zero.</summary>
        public bool HasNormals
        {
            get { return hasNormals != 0; }
        }

        /// <summary>Whether the points lie along curves, such as wires or cross sections.</summary>
        public bool AlongCurves
        {
            get { return alongCurves != 0; }
        }

        /// <summary>
        /// Axis along which a terrain looks down: 1 = y, 2 = z; 0 = it does not, or is no terrain.  Also set for faces.
        /// </summary>
        public int LooksDown
        {
            get { return (int)looksDown; }
        }

        /// <summary>Whether each edge of a mesh has two faces, which run along it in opposite directions.</summary>
        public bool Closed
        {
            get { return closed != 0; }
        }

        /// <summary>Whether a mesh is closed, and its faces look inward.</summary>
        public bool InsideOut
        {
            get { return insideOut != 0; }
        }

        /// <summary>Reason for <see cref="Up"/>, such as "as in PLY files"; empty if up is not known.</summary>
        public string UpReason
        {
            get
            {
                fixed (byte* text = upReason)
                {
                    return Errors.Utf8(text);
                }
            }
        }
    }
}
