// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>Which components of a mesh are kept.  Faces that share vertices belong to one component.</summary>
    [NativeConstants("HRBFNPR_PARTS_")]
    public enum MeshParts
    {
        /// <summary>
        /// All components except those inside a closed one, such as eyes in a head or inner shells (default).
        /// </summary>
        Outer = 0,
        /// <summary>All components.</summary>
        All = 1,
        /// <summary>The component of the largest area.</summary>
        Largest = 2,
        /// <summary>
        /// All components except open ones inside a closed one.  A closed component inside an odd number of closed ones is
        /// the wall of a cavity.
        /// </summary>
        Solids = 3,
        /// <summary>
        /// In a picture <see cref="Solids"/> if hidden parts of lines or a section are drawn, or if the picture is a surface
        /// only; else <see cref="Outer"/>.
        /// </summary>
        Auto = 4,
    }

    /// <summary>Whether the order of a face's corners may change.</summary>
    [NativeConstants("HRBFNPR_FACES_")]
    public enum MeshFaces
    {
        /// <summary>
        /// Faces are turned to agree with their component, and closed components to face outward (default).
        /// </summary>
        Turn = 0,
        /// <summary>Faces stay as they are.</summary>
        Keep = 1,
    }

    /// <summary>Which edges of a mesh are sharp.</summary>
    [NativeConstants("HRBFNPR_EDGES_")]
    public enum MeshEdges
    {
        /// <summary>
        /// Edges are sharp if they stand out from the faces beside them, as those of machine parts do (default).
        /// </summary>
        Auto = 0,
        /// <summary>No edge is sharp: a fit is one smooth surface, which rounds all edges.</summary>
        Smooth = 1,
        /// <summary>All edges are sharp whose faces meet at more than the crease angle.</summary>
        Sharp = 2,
    }

    /// <summary>The arrays of a mesh.</summary>
    [NativeConstants("HRBFNPR_MESH_ATTRIBUTE_")]
    public enum MeshAttribute
    {
        /// <summary>Positions of the vertices; 3 double.</summary>
        Vertex = 0,
        /// <summary>Numbers of the vertices of each face; 3 int.</summary>
        Triangle = 1,
        /// <summary>Number of the component of each face, from 0; 1 int.</summary>
        Component = 2,
        /// <summary>Number of each face among the given ones; 1 int.</summary>
        GivenFace = 3,
        /// <summary>Unit normals of the three corners of each face; 9 double.</summary>
        CornerNormal = 4,
    }

    /// <summary>The arrays of a model.</summary>
    [NativeConstants("HRBFNPR_MODEL_ATTRIBUTE_")]
    public enum ModelAttribute
    {
        /// <summary>Centres; for a model of several sheets, places all over the surface; 3 double.</summary>
        Position = 0,
        /// <summary>Unit normals at these places; 3 double.</summary>
        Normal = 1,
        /// <summary>
        /// Relative residual after each iteration of Iterative; 1 double; empty after Direct and after loading.
        /// </summary>
        ResidualHistory = 2,
    }
}
