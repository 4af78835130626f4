// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>The kinds of nodes, with the numbers of the library.</summary>
    [NativeConstants("HRBFNPR_CSG_")]
    internal enum CsgKind : uint
    {
        Union = 0,
        Intersection = 1,
        Difference = 2,
        Complement = 3,
        Offset = 4,
        Shell = 5,
        Model = 6,
        HalfSpace = 7,
        Box = 8,
        Sphere = 9,
        Cylinder = 10,
        Cone = 11,
        Torus = 12,
    }

    /// <summary>Makes primitive solids, from which other solids are made.</summary>
    /// <remarks>
    /// <para>Each result is a <see cref="Model"/>.  It can be drawn and queried like any other model, and combined with
    /// any model, fits and functions included: <c>a | b</c>, <c>a &amp; b</c>, <c>a - b</c>, <c>~a</c>,
    /// <see cref="Model.Blend"/>, <see cref="Model.Offset"/>, <see cref="Model.Shell"/>,
    /// <see cref="Model.Transformed"/>.</para>
    /// <para>For a half-space, a sphere and a torus, f is the signed distance to the surface.  For a box, a cylinder
    /// and a cone, f is the distance inside, and outside where one side is nearest; it is less beside edges and
    /// corners.</para>
    /// </remarks>
    /// <exception cref="InvalidArgumentException">A size is not above 0, or an axis has no length.</exception>
    public static unsafe class Csg
    {
        /// <summary>A box with sides of these lengths along the axes, centred at <c>center</c>.</summary>
        public static Model Box(Vector3d size, Vector3d center = default(Vector3d), Context context = null)
        {
            hrbfnpr_csg_node node = Place(CsgKind.Box, center, (0, 0, 1));
            *(Vector3d*)node.size = size;
            return Model.FromNode(node, context);
        }

        /// <summary>A ball around <c>center</c>.</summary>
        public static Model Sphere(double radius, Vector3d center = default(Vector3d), Context context = null)
        {
            hrbfnpr_csg_node node = Place(CsgKind.Sphere, center, (0, 0, 1));
            node.radius = radius;
            return Model.FromNode(node, context);
        }

        /// <summary>
        /// A cylinder with flat ends around an axis, which is z by default; <c>center</c> is the middle of the axis.
        /// </summary>
        public static Model Cylinder(
            double radius, double height, Vector3d center = default(Vector3d), Vector3d? axis = null,
            Context context = null)
        {
            hrbfnpr_csg_node node = Place(CsgKind.Cylinder, center, axis ?? new Vector3d(0, 0, 1));
            node.radius = radius;
            node.height = height;
            return Model.FromNode(node, context);
        }

        /// <summary>
        /// A cone with flat ends, or with a tip where a radius is 0, around an axis, which is z by default;
        /// <c>center</c> is the middle of the axis.
        /// </summary>
        public static Model Cone(
            double radius, double topRadius, double height, Vector3d center = default(Vector3d),
            Vector3d? axis = null, Context context = null)
        {
            hrbfnpr_csg_node node = Place(CsgKind.Cone, center, axis ?? new Vector3d(0, 0, 1));
            node.radius = radius;
            node.second_radius = topRadius;
            node.height = height;
            return Model.FromNode(node, context);
        }

        /// <summary>A tube around a circle, which lies around an axis, by default z.</summary>
        public static Model Torus(
            double radius, double tubeRadius, Vector3d center = default(Vector3d), Vector3d? axis = null,
            Context context = null)
        {
            hrbfnpr_csg_node node = Place(CsgKind.Torus, center, axis ?? new Vector3d(0, 0, 1));
            node.radius = radius;
            node.second_radius = tubeRadius;
            return Model.FromNode(node, context);
        }

        /// <summary>
        /// The half-space behind the plane through a point; the normal points out of it.  It has no end and serves to
        /// cut other solids.  Drawn alone, it ends at a cube from -1 to 1 around the point.
        /// </summary>
        public static Model HalfSpace(Vector3d point, Vector3d normal, Context context = null)
        {
            hrbfnpr_csg_node node = Place(CsgKind.HalfSpace, point, normal);
            return Model.FromNode(
                node, context, (point.X - 1, point.Y - 1, point.Z - 1), (point.X + 1, point.Y + 1, point.Z + 1));
        }

        internal static hrbfnpr_csg_node New(CsgKind kind, long parent = -1)
        {
            hrbfnpr_csg_node node;
            Errors.Check(NativeMethods.hrbfnpr_csg_node_init(&node, (uint)sizeof(hrbfnpr_csg_node)));
            node.kind = (uint)kind;
            node.parent = parent;
            return node;
        }

        /// <summary>
        /// Makes a node whose transform moves the origin to the centre and turns the z axis to the axis.
        /// </summary>
        private static hrbfnpr_csg_node Place(CsgKind kind, Vector3d center, Vector3d axis)
        {
            hrbfnpr_csg_node node = New(kind);
            double length = Math.Sqrt(axis.X * axis.X + axis.Y * axis.Y + axis.Z * axis.Z);
            if (!(length > 0) || double.IsInfinity(length))
            {
                throw new InvalidArgumentException("axis must be a finite vector other than zero");
            }
            double x = axis.X / length, y = axis.Y / length, z = axis.Z / length;
            double s = z < 0 ? -1 : 1; // for a downward axis, the map first makes half a turn about the x axis
            double k = 1 / (1 + s * z);
            double* m = node.transform;
            m[0] = 1 - k * x * x;
            m[1] = -k * x * y;
            m[2] = -s * x;
            m[4] = -s * k * x * y;
            m[5] = s * (1 - k * y * y);
            m[6] = -y;
            m[8] = x;
            m[9] = y;
            m[10] = z;
            m[12] = center.X;
            m[13] = center.Y;
            m[14] = center.Z;
            return node;
        }
    }
}
