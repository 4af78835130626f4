// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// What <see cref="PictureSource.Inspect()"/> found.  What is not known of this kind of source is 0, and so is what
    /// would have been found out after the finding that it cannot be drawn.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_source_info")]
    public unsafe struct SourceInfo
    {
        internal uint StructSize;
        private readonly uint kind;
        private readonly uint severity;
        private readonly uint normalsLook;

        /// <summary>As given: points, vertices of a mesh, centres of a model, marks of a point set.</summary>
        public readonly long Points;

        /// <summary>Triangles, as given.</summary>
        public readonly long Triangles;

        /// <summary>Points at a value that stands for none; what follows is without them.</summary>
        public readonly long NoData;

        /// <summary>Points far from all others; what follows is without them.</summary>
        public readonly long Strays;

        /// <summary>Points that are not finite.</summary>
        public readonly long PointsNotFinite;

        /// <summary>Points, or vertices of faces, at the place of another.</summary>
        public readonly long Duplicates;

        /// <summary>Corner of the box of finite points.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>The opposite corner.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Diagonal of these bounds.</summary>
        public readonly double Diagonal;

        /// <summary>Which way is up as a picture chooses by itself, of points and meshes.</summary>
        public readonly Vector3d Up;

        private readonly uint hasNormals;
        private readonly uint alongCurves;
        private readonly uint looksDown;
        private readonly uint reserved;

        /// <summary>Normals of length 0.</summary>
        public readonly long NormalsZero;

        /// <summary>Normals that are not finite.</summary>
        public readonly long NormalsNotFinite;

        /// <summary>Share of length 1, of those normals that can be used; 0 to 1.</summary>
        public readonly double NormalsUnitShare;

        /// <summary>
        /// Sum of the winding numbers on both sides of the samples, in the middle: 1 closed and outward, -1 inward, 0 a
        /// flat sheet; also of faces, not of points along curves.
        /// </summary>
        public readonly double NormalsClosed;

        /// <summary>
        /// Share of normals that are flipped as judged by their neighbours; also of faces, not of points along curves.
        /// </summary>
        public readonly double NormalsFlippedShare;

        /// <summary>Pixels of a depth camera that have a point.</summary>
        public readonly long ImageSeen;

        /// <summary>Those of these pixels that are on no surface.</summary>
        public readonly long ImageDropped;

        /// <summary>Median of the depths that were seen.</summary>
        public readonly double ImageDepth;

        /// <summary>Standard deviation at that depth.</summary>
        public readonly double ImageNoise;

        private readonly uint closed;
        private readonly uint insideOut;

        /// <summary>Parts of a mesh that share no vertex.</summary>
        public readonly long Components;

        /// <summary>Parts without border whose faces look inward; inside another one such a part is a cavity.</summary>
        public readonly long ComponentsInsideOut;

        /// <summary>Edges of one face.</summary>
        public readonly long BoundaryEdges;

        /// <summary>Borders.</summary>
        public readonly long BoundaryLoops;

        /// <summary>Edges of more than two faces.</summary>
        public readonly long NonmanifoldEdges;

        /// <summary>What <see cref="TriangleMesh"/> leaves of them.</summary>
        public readonly long NonmanifoldLeft;

        /// <summary>Edges of two faces, one of which is turned over.</summary>
        public readonly long ContraryEdges;

        /// <summary>Faces with a corner that is not finite.</summary>
        public readonly long FacesNotFinite;

        /// <summary>Faces without area.</summary>
        public readonly long DegenerateFaces;

        /// <summary>Faces with the corners of another.</summary>
        public readonly long RepeatedFaces;

        /// <summary>Vertices of no face.</summary>
        public readonly long UnusedVertices;

        /// <summary>Area of all faces.</summary>
        public readonly double Area;

        /// <summary>Enclosed volume; 0 where the mesh is not closed.</summary>
        public readonly double Volume;

        private fixed byte upReason[128];

        /// <summary>What the source is.</summary>
        public SourceKind Kind
        {
            get { return (SourceKind)kind; }
        }

        /// <summary>
        /// How bad the worst finding is: Info = there is none, Note = a picture repairs it, Warning, Failure = it cannot be
        /// drawn.
        /// </summary>
        public Severity Severity
        {
            get { return (Severity)severity; }
        }

        /// <summary>Which way the normals of points or of faces look.</summary>
        public NormalsLook NormalsLook
        {
            get { return (NormalsLook)normalsLook; }
        }

        /// <summary>Whether there are normals that are not zero.</summary>
        public bool HasNormals
        {
            get { return hasNormals != 0; }
        }

        /// <summary>Whether the points lie along curves, as those of wires and cross sections do.</summary>
        public bool AlongCurves
        {
            get { return alongCurves != 0; }
        }

        /// <summary>The axis along which a terrain looks down: 1 = y, 2 = z; 0 = it does not, or is none.</summary>
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

        /// <summary>Why <see cref="Up"/> is up, such as "it is so in PLY files"; empty if it is not known.</summary>
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
