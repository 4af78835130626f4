// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How a mesh is made; a new one holds all defaults.</summary>
    public sealed class MeshOptions
    {
        /// <summary>The components that are kept; default Outer.</summary>
        public MeshParts Parts { get; set; }

        /// <summary>
        /// Angle between the normals of two faces, in degrees, above which they do not share corner normals; 0 to 180;
        /// default 60.
        /// </summary>
        public double CreaseAngle { get; set; } = 60;

        /// <summary>Whether faces are turned to agree, and closed components to face outward; default Turn.</summary>
        public MeshFaces Faces { get; set; }

        internal void Write(ref hrbfnpr_mesh_desc desc)
        {
            desc.parts = (uint)Parts;
            desc.crease_angle = CreaseAngle;
            desc.faces = (uint)Faces;
        }
    }

    /// <summary>How a surface is fitted to a mesh; a new one holds all defaults.</summary>
    public sealed class MeshFitOptions
    {
        /// <summary>
        /// Largest distance of surface and mesh from each other, in units of the mesh; 1e-6 diagonals or more; default
        /// 0 = 0.002 diagonals.  Smaller: more samples and time.
        /// </summary>
        public double Tolerance { get; set; }

        /// <summary>Share of both that must be within the tolerance; above 0, up to 1; default 0.99.</summary>
        public double Share { get; set; } = 0.99;

        /// <summary>
        /// Distance that no part may exceed, in units of the mesh; not below the tolerance; default 0 = five times the
        /// tolerance.
        /// </summary>
        public double Far { get; set; }

        /// <summary>
        /// Largest number of centres; 16 to 1000000; default 8000.  A fit that ends there, short of the tolerance, is
        /// no error.
        /// </summary>
        /// <remarks>A fit with sharp edges may have 32 centres for each of its sheets, if that is more.</remarks>
        public long MaximumCentres { get; set; } = 8000;

        /// <summary>
        /// Number of places on the mesh to choose samples from; 1000 to 10000000; default 0 = by its area and its
        /// details.
        /// </summary>
        public long Candidates { get; set; }

        /// <summary>Seed of the places; any number; default 1.</summary>
        public ulong RandomSeed { get; set; } = 1;

        /// <summary>
        /// Angle between the normals of two faces, in degrees, above which their edge is sharp; 5 to 175; default 30.
        /// </summary>
        public double CreaseAngle { get; set; } = 30;

        /// <summary>Which edges of the mesh are sharp; default Auto.</summary>
        public MeshEdges Edges { get; set; }

        internal void Write(ref hrbfnpr_mesh_fit_desc desc)
        {
            desc.tolerance = Tolerance;
            desc.share = Share;
            desc.far = Far;
            desc.maximum_centres = MaximumCentres;
            desc.candidates = Candidates;
            desc.random_seed = RandomSeed;
            desc.crease_angle = CreaseAngle;
            desc.edges = (uint)Edges;
        }
    }

    /// <summary>How a surface is compared with a mesh; a new one holds all defaults.</summary>
    public sealed class CompareOptions
    {
        /// <summary>
        /// Distance within which shares are counted, in units of the mesh; 0 or more; default 0 = 0.002 diagonals.
        /// </summary>
        public double Tolerance { get; set; }

        /// <summary>
        /// Distance beyond which surface is invented and mesh is missed, in units of the mesh; 0 or more; default 0 =
        /// 0.01 diagonals.
        /// </summary>
        public double Far { get; set; }

        /// <summary>
        /// Limit of the support of the model's samples, beyond which surface is left out, as in
        /// <see cref="LineSetOptions.Support"/>; 0 or more; default 0 = nothing is left out.
        /// </summary>
        public double Support { get; set; }

        /// <summary>
        /// Number of places to measure at, on the surface and on the mesh each; 100 to 10000000; default 0 = 20000.
        /// </summary>
        public long Points { get; set; }

        /// <summary>
        /// Side of the cells in which the surface is searched, in units of the mesh; at least 0.001 diagonals; default
        /// 0 = 1/128 diagonal, and finer where the surface is thin.
        /// </summary>
        public double CellSize { get; set; }

        /// <summary>Seed of the places; any number; default 1.</summary>
        public ulong RandomSeed { get; set; } = 1;

        internal void Write(ref hrbfnpr_compare_desc desc)
        {
            desc.tolerance = Tolerance;
            desc.far = Far;
            desc.support = Support;
            desc.points = Points;
            desc.cell_size = CellSize;
            desc.random_seed = RandomSeed;
        }
    }
}
