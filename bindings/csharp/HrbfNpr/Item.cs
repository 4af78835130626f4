// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    /// <summary>Where the marks of one layer are in a drawing: of an animated surface.</summary>
    public sealed class LayerPose
    {
        /// <summary>A pose of a layer.</summary>
        /// <param name="layer">Number of the layer in the item's point set.</param>
        /// <param name="position">n points, absolute, in the order of the layer's n marks; float or double.</param>
        /// <param name="normal">n unit normals, outward.</param>
        /// <param name="direction">n unit directions; those of the set if not given.</param>
        public LayerPose(
            long layer, ArrayView position, ArrayView normal, ArrayView direction = default(ArrayView))
        {
            Layer = layer;
            Position = position;
            Normal = normal;
            Direction = direction;
        }

        /// <summary>Number of the layer in the item's point set.</summary>
        public long Layer { get; set; }

        /// <summary>n points, absolute; float or double.</summary>
        public ArrayView Position { get; set; }

        /// <summary>n unit normals, outward; float or double.</summary>
        public ArrayView Normal { get; set; }

        /// <summary>n unit directions, float or double; those of the set if not given.</summary>
        public ArrayView Direction { get; set; }

        internal unsafe void Write(hrbfnpr_layer_pose* pose, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_layer_pose_init(pose, (uint)sizeof(hrbfnpr_layer_pose)));
            pose->layer = Layer;
            pose->position = Position.ToNative(pins, 3, nameof(Position));
            pose->normal = Normal.ToNative(pins, 3, nameof(Normal));
            pose->direction = Direction.ToNative(pins, 3, nameof(Direction));
        }
    }

    /// <summary>One thing to draw.</summary>
    public sealed class Item
    {
        private double[] transform;

        /// <summary>Marks, and how they are drawn.</summary>
        /// <param name="pointSet">The marks.</param>
        /// <param name="style">The library's default style if null.</param>
        public Item(PointSet pointSet, Style style = null)
        {
            PointSet = pointSet ?? throw new ArgumentNullException(nameof(pointSet));
            Style = style;
        }

        /// <summary>The marks.</summary>
        public PointSet PointSet { get; }

        /// <summary>How they are drawn; the library's default style if null.</summary>
        public Style Style { get; set; }

        /// <summary>
        /// The surface that the marks lie on, or null: with <see cref="Visibility.DepthLayers"/>, what hides a mark is
        /// then found by casting a ray from it to the eye, exact but slow.
        /// </summary>
        public Model Model { get; set; }

        /// <summary>
        /// What the style's <see cref="HrbfNpr.Style.Lines"/> are drawn from, or null.  All items of a drawing that
        /// have one hide each other's lines; others hide none.
        /// </summary>
        public LineSet LineSet { get; set; }

        /// <summary>
        /// Which sides of the surface marks are drawn on: of one that ends, such as a bowl or a leaf, the inside is
        /// seen, too.  There marks have opposite normals for tone, the same ids, and layers behind all others.
        /// </summary>
        public Sides Sides { get; set; }

        /// <summary>Object to world, 16 numbers, column-major, affine, invertible; the identity if null.</summary>
        public double[] Transform
        {
            get
            {
                return transform;
            }

            set
            {
                if (value != null && value.Length != 16)
                {
                    throw new InvalidArgumentException("Transform must have 16 numbers, not " + value.Length);
                }
                transform = value;
            }
        }

        /// <summary>Layers whose marks have moved.</summary>
        public IList<LayerPose> Poses { get; } = new List<LayerPose>();

        /// <summary>The marks in the default style.</summary>
        public static implicit operator Item(PointSet pointSet)
        {
            return new Item(pointSet);
        }
    }
}
