// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// What making a mesh found and did.  Numbers of vertices, faces and edges are those of the mesh that is kept;
    /// numbers of repairs are those of the given mesh.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_info")]
    public struct MeshInfo
    {
        internal uint StructSize;
        private readonly uint closed;

        /// <summary>Number of given vertices.</summary>
        public readonly long GivenVertices;

        /// <summary>Number of given faces.</summary>
        public readonly long GivenFaces;

        /// <summary>Number of vertices that are kept.</summary>
        public readonly long Vertices;

        /// <summary>Number of faces that are kept.</summary>
        public readonly long Faces;

        /// <summary>Number of vertices at the place of another, which were joined with it.</summary>
        public readonly long WeldedVertices;

        /// <summary>Number of faces left out because they have no area.</summary>
        public readonly long DegenerateFaces;

        /// <summary>Number of faces left out because another has the same corners.</summary>
        public readonly long RepeatedFaces;

        /// <summary>Number of faces turned to agree with those beside them.</summary>
        public readonly long TurnedFaces;

        /// <summary>Number of components of the given faces.</summary>
        public readonly long Components;

        /// <summary>Number of closed components turned because they were inside out.</summary>
        public readonly long TurnedComponents;

        /// <summary>Number of components inside a closed one.</summary>
        public readonly long NestedComponents;

        /// <summary>Number of components left out.</summary>
        public readonly long LeftOutComponents;

        /// <summary>Number of faces of these components.</summary>
        public readonly long LeftOutFaces;

        /// <summary>Number of edges with one face.</summary>
        public readonly long BoundaryEdges;

        /// <summary>Number of loops that these edges form.</summary>
        public readonly long BoundaryLoops;

        /// <summary>Number of edges with more than two faces.</summary>
        public readonly long NonmanifoldEdges;

        /// <summary>Number of edges whose two faces do not agree.</summary>
        public readonly long ContraryEdges;

        /// <summary>Number of vertices - edges + faces.</summary>
        public readonly long EulerCharacteristic;

        /// <summary>Number of handles of all components; -1 if the mesh is not closed.</summary>
        public readonly long Genus;

        /// <summary>Area, in squared units of the mesh.</summary>
        public readonly double Area;

        /// <summary>Enclosed volume, in cubed units of the mesh; NaN if the mesh is not closed.</summary>
        public readonly double Volume;

        /// <summary>Lower corner of the box around the vertices that are kept.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>Upper corner of the box.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Time that it took to make the mesh, in seconds.</summary>
        public readonly double Seconds;

        /// <summary>Bytes that the mesh keeps.</summary>
        public readonly long Bytes;

        /// <summary>Length of the edges that bend by more than 30 degrees, in diagonals.</summary>
        public readonly double CreaseLength;

        private readonly uint creases;
        private readonly uint cavities;

        /// <summary>Whether no edge has one face or more than two, and all faces agree.</summary>
        public bool Closed
        {
            get { return closed != 0; }
        }

        /// <summary>
        /// Whether the mesh has edges that stand out, as those of machine parts do.  Fits with
        /// <see cref="MeshEdges.Auto"/> keep them sharp.
        /// </summary>
        public bool Creases
        {
            get { return creases != 0; }
        }

        /// <summary>The number of kept components that are walls of cavities.</summary>
        public int Cavities
        {
            get { return (int)cavities; }
        }
    }

    /// <summary>
    /// The result of a fit to a mesh.  Distances are in units of the mesh, from the last measurement of the fit.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_fit_info")]
    public struct MeshFitInfo
    {
        internal uint StructSize;
        private readonly uint reached;

        /// <summary>The tolerance as used.</summary>
        public readonly double Tolerance;

        /// <summary>The distance <see cref="MeshFitOptions.Far"/> as used.</summary>
        public readonly double Far;

        /// <summary>Number of places on the mesh that samples were chosen from.</summary>
        public readonly long Candidates;

        /// <summary>Number of all centres.</summary>
        public readonly long Centres;

        /// <summary>
        /// Number of centres off the surface, at which f is held to the distance from the mesh.  They are the last
        /// ones.
        /// </summary>
        public readonly long OffSurfaceCentres;

        /// <summary>Number of fits.</summary>
        public readonly int Rounds;

        private readonly uint supported;

        /// <summary>Share of the surface within the tolerance of the mesh; 0 to 1.</summary>
        public readonly double SurfaceShare;

        /// <summary>99th percentile of the surface's distances from the mesh.</summary>
        public readonly double SurfaceP99;

        /// <summary>Greatest distance of the surface from the mesh.</summary>
        public readonly double SurfaceMax;

        /// <summary>Share of the mesh within the tolerance of the surface; 0 to 1.</summary>
        public readonly double MeshShare;

        /// <summary>99th percentile of the mesh's distances from the surface.</summary>
        public readonly double MeshP99;

        /// <summary>Greatest distance of the mesh from the surface.</summary>
        public readonly double MeshMax;

        /// <summary>Time for choosing samples, in seconds.</summary>
        public readonly double SecondsSample;

        /// <summary>Time for the fits of all rounds, in seconds.</summary>
        public readonly double SecondsFit;

        /// <summary>Time for measuring distances, in seconds.</summary>
        public readonly double SecondsMeasure;

        /// <summary>Time of the whole call, in seconds.</summary>
        public readonly double SecondsTotal;

        /// <summary>Number of smooth sheets that the surface consists of; 1 if it has no sharp edges.</summary>
        public readonly int Sheets;

        private readonly uint reserved;

        /// <summary>Length of the mesh's edges that are sharp.</summary>
        public readonly double CreaseLength;

        /// <summary>Length of edges that stay smooth because the mesh could not be cut there.</summary>
        public readonly double SmoothLength;

        /// <summary>Number of cells of space, in each of which a few sheets make the surface.</summary>
        public readonly long Cells;

        /// <summary>Number of cells in which no maximum and minimum of sheets follows the mesh everywhere.</summary>
        public readonly long PoorCells;

        private readonly int touchingParts0;
        private readonly int touchingParts1;

        /// <summary>Place where two parts of the mesh are nearer to each other than the tolerance.</summary>
        public readonly Vector3d TouchingPlace;

        private readonly uint partsMayCross;
        private readonly uint reserved2;

        /// <summary>Numbers of these two parts, from 0, which the surface may join; null if none were found.</summary>
        public (int First, int Second)? TouchingParts
        {
            get { return touchingParts0 < 0 ? default((int, int)?) : (touchingParts0, touchingParts1); }
        }

        /// <summary>
        /// Whether these parts may go through each other there; false if they are only near each other.
        /// </summary>
        public bool PartsMayCross
        {
            get { return partsMayCross != 0; }
        }

        /// <summary>Whether surface and mesh keep the tolerance, the share and <see cref="Far"/>, both ways.</summary>
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
    /// How near a surface and a mesh are to each other.  Distances are in units of the mesh; figures without any place
    /// to measure at are NaN.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_comparison")]
    public struct MeshComparison
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Number of places on the surface, even over its area.</summary>
        public readonly long SurfacePoints;

        /// <summary>Mean of their distances from the mesh.</summary>
        public readonly double SurfaceMean;

        /// <summary>99th percentile of these distances.</summary>
        public readonly double SurfaceP99;

        /// <summary>Greatest of these distances.</summary>
        public readonly double SurfaceMax;

        /// <summary>Share of the surface within the tolerance of the mesh; 0 to 1.</summary>
        public readonly double SurfaceShare;

        /// <summary>Share of the surface farther than <see cref="CompareOptions.Far"/> from the mesh; 0 to 1.</summary>
        public readonly double InventedShare;

        /// <summary>
        /// Share of the surface left out, beyond the mesh's border or by <see cref="CompareOptions.Support"/>; 0 to 1.
        /// No other figure includes it.
        /// </summary>
        public readonly double LeftOutShare;

        /// <summary>Number of places on the mesh, even over its area.</summary>
        public readonly long MeshPoints;

        /// <summary>Mean of their distances from the surface.</summary>
        public readonly double MeshMean;

        /// <summary>99th percentile of these distances.</summary>
        public readonly double MeshP99;

        /// <summary>Greatest of these distances.</summary>
        public readonly double MeshMax;

        /// <summary>Share of the mesh within the tolerance of the surface; 0 to 1.</summary>
        public readonly double MeshShare;

        /// <summary>Share of the mesh farther than <see cref="CompareOptions.Far"/> from the surface; 0 to 1.</summary>
        public readonly double MissedShare;

        /// <summary>Mean angle between the mesh's normals and those of the surface beside them, in degrees.</summary>
        public readonly double NormalMean;

        /// <summary>99th percentile of these angles, in degrees.</summary>
        public readonly double NormalP99;

        /// <summary>Number of components of the surface.</summary>
        public readonly long Components;

        /// <summary>Genus of the surface, summed over its components; -1 if it has a border in the box.</summary>
        public readonly long Genus;

        /// <summary>The tolerance as used.</summary>
        public readonly double Tolerance;

        /// <summary>Diagonal of the mesh.</summary>
        public readonly double Diagonal;

        /// <summary>Time that the comparison took, in seconds.</summary>
        public readonly double Seconds;
    }
}
