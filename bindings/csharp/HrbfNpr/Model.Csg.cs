// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    public sealed unsafe partial class Model
    {
        /// <summary>What the solid is made of.  All fields are 0 for a model that is not a solid.</summary>
        public CsgInfo CsgInfo
        {
            get
            {
                CsgInfo info;
                Errors.Check(NativeMethods.hrbfnpr_csg_info_init(&info, (uint)sizeof(CsgInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_model_get_csg_info(handle, &info, &error), &error);
                return info;
            }
        }

        /// <summary>The union: everything inside either solid.</summary>
        public static Model operator |(Model a, Model b)
        {
            return a.Union(b);
        }

        /// <summary>The intersection: everything inside both solids.</summary>
        public static Model operator &(Model a, Model b)
        {
            return a.Intersection(b);
        }

        /// <summary>The difference: the first solid without the second.</summary>
        public static Model operator -(Model a, Model b)
        {
            return a.Difference(b);
        }

        /// <summary>The complement: the same surface, with inside and outside exchanged.</summary>
        public static Model operator ~(Model a)
        {
            return a.Combined(Csg.New(CsgKind.Complement), new Model[0]);
        }

        /// <summary>Makes the union of this and others, with creases where they meet.</summary>
        /// <exception cref="InvalidArgumentException">The surface of the result may have no end, or a model is
        /// trimmed.</exception>
        public Model Union(params Model[] others)
        {
            return Combined(Csg.New(CsgKind.Union), others);
        }

        /// <summary>Makes the intersection of this and others, with creases where they meet.</summary>
        /// <exception cref="InvalidArgumentException">The surface of the result may have no end, nothing is left, or a
        /// model is trimmed.</exception>
        public Model Intersection(params Model[] others)
        {
            return Combined(Csg.New(CsgKind.Intersection), others);
        }

        /// <summary>Makes the difference: this without all others, with creases where they meet.</summary>
        /// <exception cref="InvalidArgumentException">The surface of the result may have no end, nothing is left, or a
        /// model is trimmed.</exception>
        public Model Difference(params Model[] others)
        {
            return Combined(Csg.New(CsgKind.Difference), others);
        }

        /// <summary>Makes the union of this and another, rounded where they meet.</summary>
        /// <param name="other">The other solid.</param>
        /// <param name="radius">The radius of the blend, in the unit of the model; 0 or more; 0 = a crease.  Larger
        /// values round more.</param>
        /// <param name="exponent">The exponent of the blend; 0, or 2 to 64; 0 = twice continuously differentiable
        /// everywhere; 2 = an arc of the radius at a right angle.  Larger values are sharper.</param>
        public Model Blend(Model other, double radius, double exponent = 0)
        {
            return Blended(CsgKind.Union, other, radius, exponent);
        }

        /// <summary>
        /// Makes the intersection of this and another, rounded where they meet as in <see cref="Blend"/>.
        /// </summary>
        public Model BlendIntersection(Model other, double radius, double exponent = 0)
        {
            return Blended(CsgKind.Intersection, other, radius, exponent);
        }

        /// <summary>
        /// Makes the difference of this and another, rounded where they meet as in <see cref="Blend"/>.
        /// </summary>
        public Model BlendDifference(Model other, double radius, double exponent = 0)
        {
            return Blended(CsgKind.Difference, other, radius, exponent);
        }

        /// <summary>
        /// Grows the solid outward by a distance, or inward if it is negative.  Exact where f is the distance.
        /// </summary>
        public Model Offset(double distance)
        {
            hrbfnpr_csg_node root = Csg.New(CsgKind.Offset);
            root.distance = distance;
            return Combined(root, new Model[0]);
        }

        /// <summary>Makes a hollow body with a wall of this thickness inside the surface, which stays.</summary>
        public Model Shell(double thickness)
        {
            hrbfnpr_csg_node root = Csg.New(CsgKind.Shell);
            root.distance = thickness;
            return Combined(root, new Model[0]);
        }

        /// <summary>Moves the model by an affine map: 16 numbers, column-major.</summary>
        /// <remarks>
        /// If the map stretches unevenly, f is measured by the least stretch, so that |grad f| does not grow.
        /// </remarks>
        public Model Transformed(double[] matrix)
        {
            if (matrix == null || matrix.Length != 16)
            {
                throw new InvalidArgumentException("matrix must have 16 numbers");
            }
            hrbfnpr_csg_node root = Csg.New(CsgKind.Union);
            for (int i = 0; i < 16; ++i)
            {
                root.transform[i] = matrix[i];
            }
            return Combined(root, new Model[0]);
        }

        /// <summary>Moves the model by a vector.</summary>
        public Model Translated(Vector3d by)
        {
            return Transformed(new double[] { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, by.X, by.Y, by.Z, 1 });
        }

        internal static Model FromNode(
            hrbfnpr_csg_node node, Context context, Vector3d boundsMin = default(Vector3d),
            Vector3d boundsMax = default(Vector3d))
        {
            context = Context.Resolve(context);
            Model made = FromNodes(new[] { node }, null, boundsMin, boundsMax, context.Anchor);
            GC.KeepAlive(context);
            return made;
        }

        private static Model FromNodes(
            hrbfnpr_csg_node[] nodes, FunctionState functions, Vector3d boundsMin, Vector3d boundsMax,
            ContextAnchor anchor)
        {
            hrbfnpr_csg_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_csg_desc_init(&desc, (uint)sizeof(hrbfnpr_csg_desc)));
            *(Vector3d*)desc.bounds_min = boundsMin;
            *(Vector3d*)desc.bounds_max = boundsMax;
            desc.node_count = nodes.Length;
            hrbfnpr_error error = Errors.New();
            var made = new ModelHandle();
            fixed (hrbfnpr_csg_node* first = nodes)
            {
                desc.nodes = (IntPtr)first;
                int status = NativeMethods.hrbfnpr_model_create_csg(
                    anchor.Context, &desc, out IntPtr created, &error);
                made.Take(created, anchor);
                Errors.Check(status, &error);
            }
            return new Model(made, functions);
        }

        private Model Blended(CsgKind kind, Model other, double radius, double exponent)
        {
            hrbfnpr_csg_node root = Csg.New(kind);
            root.blend = radius;
            root.exponent = exponent;
            return Combined(root, new[] { other });
        }

        /// <summary>Makes a tree with one root, whose children are this model and others.</summary>
        private Model Combined(hrbfnpr_csg_node root, Model[] others)
        {
            var all = new List<Model> { this };
            all.AddRange(others);
            var nodes = new hrbfnpr_csg_node[all.Count + 1];
            var held = new bool[all.Count];
            FunctionState functions = null;
            nodes[0] = root;
            try
            {
                for (int i = 0; i < all.Count; ++i)
                {
                    Model model = all[i] ?? throw new ArgumentNullException(nameof(others));
                    model.handle.DangerousAddRef(ref held[i]);
                    nodes[i + 1] = Csg.New(CsgKind.Model, 0);
                    nodes[i + 1].model = model.handle.DangerousGetHandle();
                    functions = FunctionState.Both(functions, model.function);
                }
                return FromNodes(nodes, functions, default(Vector3d), default(Vector3d), handle.Anchor);
            }
            finally
            {
                for (int i = 0; i < all.Count; ++i)
                {
                    if (held[i])
                    {
                        all[i].handle.DangerousRelease();
                    }
                }
            }
        }
    }
}
