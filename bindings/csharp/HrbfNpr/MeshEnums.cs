// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>Which components of a mesh are kept.</summary>
    [NativeConstants("HRBFNPR_PARTS_")]
    public enum MeshParts
    {
        /// <summary>All but those that lie inside a closed one (default).</summary>
        Outer = 0,
        /// <summary>All.</summary>
        All = 1,
        /// <summary>That of the largest area.</summary>
        Largest = 2,
    }

    /// <summary>What becomes of the order of a face's corners.</summary>
    [NativeConstants("HRBFNPR_FACES_")]
    public enum MeshFaces
    {
        /// <summary>Faces are turned to agree with their component, and closed components outward (default).</summary>
        Turn = 0,
        /// <summary>As they are.</summary>
        Keep = 1,
    }

    /// <summary>What becomes of a mesh's edges.</summary>
    [NativeConstants("HRBFNPR_EDGES_")]
    public enum MeshEdges
    {
        /// <summary>Sharp where they stand out, as those of machine parts do (default).</summary>
        Auto = 0,
        /// <summary>The surface is one smooth fit, which rounds them.</summary>
        Smooth = 1,
        /// <summary>Sharp wherever faces meet at more than the crease angle.</summary>
        Sharp = 2,
    }

    /// <summary>What a mesh keeps.</summary>
    [NativeConstants("HRBFNPR_MESH_ATTRIBUTE_")]
    public enum MeshAttribute
    {
        /// <summary>Places, 3 double.</summary>
        Vertex = 0,
        /// <summary>Numbers of vertices, 3 int of each face.</summary>
        Triangle = 1,
        /// <summary>From 0, 1 int of each face.</summary>
        Component = 2,
        /// <summary>The number that the face was given by, 1 int.</summary>
        GivenFace = 3,
        /// <summary>Unit normals of the three corners, 9 double of each face.</summary>
        CornerNormal = 4,
    }

    /// <summary>What a model keeps of its samples and of its fit.</summary>
    [NativeConstants("HRBFNPR_MODEL_ATTRIBUTE_")]
    public enum ModelAttribute
    {
        /// <summary>The centres, 3 double.</summary>
        Position = 0,
        /// <summary>Their unit normals, 3 double.</summary>
        Normal = 1,
        /// <summary>Relative residual after each iteration of the iterative solver, 1 double.</summary>
        ResidualHistory = 2,
    }
}
