// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How a mesh is made; a new one holds all defaults.</summary>
    public sealed class MeshOptions
    {
        /// <summary>Which components are kept; all but those inside others by default.</summary>
        public MeshParts Parts { get; set; }

        /// <summary>Degrees, 0 to 180: faces that meet at a sharper angle do not share their normals; 60.</summary>
        public double CreaseAngle { get; set; } = 60;

        /// <summary>Whether faces are turned to agree, and closed components outward: they are by default.</summary>
        public MeshFaces Faces { get; set; }

        internal void Write(ref hrbfnpr_mesh_desc desc)
        {
            desc.parts = (uint)Parts;
            desc.crease_angle = CreaseAngle;
            desc.faces = (uint)Faces;
        }
    }

    /// <summary>How a surface is fitted to a mesh.</summary>
    public sealed class MeshFitOptions
    {
        /// <summary>
        /// How near the surface and the mesh are to be to each other, in units of the mesh; 0 = 0.002 of its diagonal.
        /// </summary>
        public double Tolerance { get; set; }

        /// <summary>Of both that has to be within the tolerance, above 0, at most 1; 0.99.</summary>
        public double Share { get; set; } = 0.99;

        /// <summary>What no part may be beyond; 0 = five times the tolerance.</summary>
        public double Far { get; set; }

        /// <summary>16 to 1000000; 8000.  An end there, short of the tolerance, is no error.</summary>
        public long MaximumCentres { get; set; } = 8000;

        /// <summary>Places on the mesh to choose from; 0 = by its area and its details.</summary>
        public long Candidates { get; set; }

        /// <summary>Any number; 1.</summary>
        public ulong RandomSeed { get; set; } = 1;

        /// <summary>Degrees between the normals of two faces, 5 to 175: what bends more is an edge; 30.</summary>
        public double CreaseAngle { get; set; } = 30;

        /// <summary>What becomes of the mesh's edges: sharp where they stand out by default.</summary>
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

    /// <summary>How a surface is compared with a mesh.</summary>
    public sealed class CompareOptions
    {
        /// <summary>That shares are counted for, in units of the mesh; 0 = 0.002 of its diagonal.</summary>
        public double Tolerance { get; set; }

        /// <summary>Beyond it a part of the surface is an invention; 0 = 0.01 of the mesh's diagonal.</summary>
        public double Far { get; set; }

        /// <summary>
        /// Above 0: what the samples do not bear out by this limit is left out, as by
        /// <see cref="LineSetOptions.Support"/>.
        /// </summary>
        public double Support { get; set; }

        /// <summary>On each side, 100 to 10000000; 0 = 20000.</summary>
        public long Points { get; set; }

        /// <summary>
        /// Of the cells that the surface is looked for in; 0 = 1/128 of the diagonal, and finer where it is thin.
        /// </summary>
        public double CellSize { get; set; }

        /// <summary>Any number; 1.</summary>
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
