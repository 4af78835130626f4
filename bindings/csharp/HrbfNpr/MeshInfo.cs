// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What making a mesh found, and did.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_info")]
    public struct MeshInfo
    {
        internal uint StructSize;
        private readonly uint closed;

        /// <summary>Vertices, as given.</summary>
        public readonly long GivenVertices;

        /// <summary>Faces, as given.</summary>
        public readonly long GivenFaces;

        /// <summary>Vertices that are kept.</summary>
        public readonly long Vertices;

        /// <summary>Faces that are kept.</summary>
        public readonly long Faces;

        /// <summary>Vertices in the place of another, which were joined with it.</summary>
        public readonly long WeldedVertices;

        /// <summary>Faces without area, left out.</summary>
        public readonly long DegenerateFaces;

        /// <summary>Faces with the corners of another, left out.</summary>
        public readonly long RepeatedFaces;

        /// <summary>Faces that were against those beside them, and were turned.</summary>
        public readonly long TurnedFaces;

        /// <summary>Components of the given faces.</summary>
        public readonly long Components;

        /// <summary>Of these, closed ones that were inside out and were turned.</summary>
        public readonly long TurnedComponents;

        /// <summary>Components inside a closed one.</summary>
        public readonly long NestedComponents;

        /// <summary>Components that were left out.</summary>
        public readonly long LeftOutComponents;

        /// <summary>Their faces.</summary>
        public readonly long LeftOutFaces;

        /// <summary>Edges that one face has.</summary>
        public readonly long BoundaryEdges;

        /// <summary>Rings of these.</summary>
        public readonly long BoundaryLoops;

        /// <summary>Edges that more than two faces have.</summary>
        public readonly long NonmanifoldEdges;

        /// <summary>Edges whose two faces do not agree.</summary>
        public readonly long ContraryEdges;

        /// <summary>Vertices - edges + faces.</summary>
        public readonly long EulerCharacteristic;

        /// <summary>Handles of all components; -1 where the mesh is not closed.</summary>
        public readonly long Genus;

        /// <summary>Of all faces.</summary>
        public readonly double Area;

        /// <summary>Enclosed; NaN where the mesh is not closed.</summary>
        public readonly double Volume;

        /// <summary>Corner of the box of what is kept.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>The opposite corner.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Seconds that it took to make.</summary>
        public readonly double Seconds;

        /// <summary>Bytes kept by the mesh.</summary>
        public readonly long Bytes;

        /// <summary>Length of the edges that bend by more than 30 degrees, in diagonals of the box.</summary>
        public readonly double CreaseLength;

        private readonly uint creases;
        private readonly uint reserved;

        /// <summary>Whether no edge has one face, or more than two, and all faces agree.</summary>
        public bool Closed
        {
            get { return closed != 0; }
        }

        /// <summary>Whether those edges stand out, as of machine parts: fits with edges AUTO keep them sharp.</summary>
        public bool Creases
        {
            get { return creases != 0; }
        }
    }

    /// <summary>What a fit to a mesh came to: the last of the measurements that it went by.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_fit_info")]
    public struct MeshFitInfo
    {
        internal uint StructSize;
        private readonly uint reached;

        /// <summary>As used.</summary>
        public readonly double Tolerance;

        /// <summary>As used.</summary>
        public readonly double Far;

        /// <summary>Places on the mesh that were chosen from.</summary>
        public readonly long Candidates;

        /// <summary>All centres.</summary>
        public readonly long Centres;

        /// <summary>Of these, the last ones: where f is held to the distance from the mesh.</summary>
        public readonly long OffSurfaceCentres;

        /// <summary>Fits.</summary>
        public readonly int Rounds;

        private readonly uint supported;

        /// <summary>Of the surface, the share within the tolerance of the mesh.</summary>
        public readonly double SurfaceShare;

        /// <summary>99 % of the surface are not farther from the mesh.</summary>
        public readonly double SurfaceP99;

        /// <summary>How far the surface is from the mesh at most.</summary>
        public readonly double SurfaceMax;

        /// <summary>Of the mesh, the share within the tolerance of the surface.</summary>
        public readonly double MeshShare;

        /// <summary>99 % of the mesh are not farther from the surface.</summary>
        public readonly double MeshP99;

        /// <summary>How far the mesh is from the surface at most.</summary>
        public readonly double MeshMax;

        /// <summary>Seconds for the places to choose from.</summary>
        public readonly double SecondsSample;

        /// <summary>Seconds of all fits.</summary>
        public readonly double SecondsFit;

        /// <summary>Seconds of all measurements.</summary>
        public readonly double SecondsMeasure;

        /// <summary>Seconds of the call.</summary>
        public readonly double SecondsTotal;

        /// <summary>Smooth pieces that the surface is made of; 1: it has no edges.</summary>
        public readonly int Sheets;

        private readonly uint reserved;

        /// <summary>Of the mesh's edges that are sharp.</summary>
        public readonly double CreaseLength;

        /// <summary>Of those that are not, as the mesh could not be cut there.</summary>
        public readonly double SmoothLength;

        /// <summary>Of space, in each of which a few sheets rule.</summary>
        public readonly long Cells;

        /// <summary>In which no maximum and minimum of its sheets does all that the mesh does.</summary>
        public readonly long PoorCells;

        private readonly int touchingParts0;
        private readonly int touchingParts1;

        /// <summary>Where two parts of the mesh are nearer to each other than the tolerance.</summary>
        public readonly Vector3d TouchingPlace;

        private readonly uint partsMayCross;
        private readonly uint reserved2;

        /// <summary>
        /// Two parts of the mesh, from 0, that are nearer to each other than the tolerance, so that the surface may
        /// join them; null if none were found.
        /// </summary>
        public (int First, int Second)? TouchingParts
        {
            get { return touchingParts0 < 0 ? default((int, int)?) : (touchingParts0, touchingParts1); }
        }

        /// <summary>Whether these may go through each other there; else they are near to each other.</summary>
        public bool PartsMayCross
        {
            get { return partsMayCross != 0; }
        }

        /// <summary>Whether tolerance, share and far are kept, both ways.</summary>
        public bool Reached
        {
            get { return reached != 0; }
        }

        /// <summary>Whether the mesh has a border, and the surface beyond it was not counted.</summary>
        public bool Supported
        {
            get { return supported != 0; }
        }
    }

    /// <summary>
    /// How near a surface is to a mesh, both ways.  Distances are in units of the mesh; of no places they are NaN.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_comparison")]
    public struct MeshComparison
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Places on the surface, even over its area.</summary>
        public readonly long SurfacePoints;

        /// <summary>Mean of their distances from the mesh.</summary>
        public readonly double SurfaceMean;

        /// <summary>99 % are not farther.</summary>
        public readonly double SurfaceP99;

        /// <summary>The farthest.</summary>
        public readonly double SurfaceMax;

        /// <summary>The share within the tolerance.</summary>
        public readonly double SurfaceShare;

        /// <summary>The share of the surface farther than <see cref="CompareOptions.Far"/>.</summary>
        public readonly double InventedShare;

        /// <summary>
        /// The share of the surface beyond the mesh's border, or left out by <see cref="CompareOptions.Support"/>.
        /// </summary>
        public readonly double LeftOutShare;

        /// <summary>Places on the mesh, even over its area.</summary>
        public readonly long MeshPoints;

        /// <summary>Mean of their distances from the surface.</summary>
        public readonly double MeshMean;

        /// <summary>99 % are not farther.</summary>
        public readonly double MeshP99;

        /// <summary>The farthest.</summary>
        public readonly double MeshMax;

        /// <summary>The share within the tolerance.</summary>
        public readonly double MeshShare;

        /// <summary>The share of the mesh farther than <see cref="CompareOptions.Far"/>.</summary>
        public readonly double MissedShare;

        /// <summary>Mean of the degrees between the mesh's normals and the surface's.</summary>
        public readonly double NormalMean;

        /// <summary>99 % are not more.</summary>
        public readonly double NormalP99;

        /// <summary>Components of the surface.</summary>
        public readonly long Components;

        /// <summary>Handles of the surface; -1 if it has a border in the box.</summary>
        public readonly long Genus;

        /// <summary>As used.</summary>
        public readonly double Tolerance;

        /// <summary>Of the mesh.</summary>
        public readonly double Diagonal;

        /// <summary>Seconds of the call.</summary>
        public readonly double Seconds;
    }
}
