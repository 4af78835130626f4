// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    /// <summary>The marks of one layer as they are in a drawing, for an animated surface.</summary>
    public sealed class LayerPose
    {
        /// <summary>Creates a pose of a layer.</summary>
        /// <param name="layer">The number of the layer in the item's point set; each layer has one pose at
        /// most.</param>
        /// <param name="position">n absolute positions, in the order of the layer's n marks; float or double.</param>
        /// <param name="normal">n outward unit normals; float or double.</param>
        /// <param name="direction">n unit directions, float or double; not given = the directions of the set.</param>
        public LayerPose(
            long layer, ArrayView position, ArrayView normal, ArrayView direction = default(ArrayView))
        {
            Layer = layer;
            Position = position;
            Normal = normal;
            Direction = direction;
        }

        /// <summary>Number of the layer in the item's point set; each layer has one pose at most.</summary>
        public long Layer { get; set; }

        /// <summary>n absolute positions, in the order of the layer's n marks; float or double.</summary>
        public ArrayView Position { get; set; }

        /// <summary>n outward unit normals; float or double.</summary>
        public ArrayView Normal { get; set; }

        /// <summary>n unit directions, float or double; default not given = the directions of the set.</summary>
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

        /// <summary>Creates an item of marks and how they are drawn.</summary>
        /// <param name="pointSet">The marks.</param>
        /// <param name="style">How they are drawn; null = the default style.</param>
        public Item(PointSet pointSet, Style style = null)
        {
            PointSet = pointSet ?? throw new ArgumentNullException(nameof(pointSet));
            Style = style;
        }

        /// <summary>The marks to draw.</summary>
        public PointSet PointSet { get; }

        /// <summary>How they are drawn; default null = the default style.</summary>
        public Style Style { get; set; }

        /// <summary>
        /// The surface that the marks lie on; default null.  With it, a ray from each mark to the eye finds what hides
        /// the mark: exact, but slow.
        /// </summary>
        /// <remarks>
        /// It is used with <see cref="Visibility.DepthLayers"/> only, and must be null if there are poses.
        /// </remarks>
        public Model Model { get; set; }

        /// <summary>
        /// What the lines of the style are drawn from; default null = no lines.  All items of a drawing that have one
        /// hide each other's lines.
        /// </summary>
        /// <remarks>Items without a line set hide no lines.  It must be null if there are poses.</remarks>
        public LineSet LineSet { get; set; }

        /// <summary>
        /// How much light reaches the marks past the surfaces of all items; default null = all.
        /// </summary>
        /// <remarks>It must be that of the same point set, and null if there are poses.</remarks>
        public Shading Shading { get; set; }

        /// <summary>The sides on which marks are drawn; default Front.</summary>
        /// <remarks>
        /// Both sides are for a surface that ends, such as a bowl or a leaf.  Where the other side faces the camera,
        /// marks are drawn with opposite normals.  They keep their ids, and are in separate layers after those of all
        /// items.
        /// </remarks>
        public Sides Sides { get; set; }

        /// <summary>
        /// Object to world: 16 numbers, column-major, affine and invertible; default null = the identity.
        /// </summary>
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

        /// <summary>Poses of layers whose marks have moved; default empty.</summary>
        public IList<LayerPose> Poses { get; } = new List<LayerPose>();

        /// <summary>Makes an item of marks in the default style.</summary>
        public static implicit operator Item(PointSet pointSet)
        {
            return new Item(pointSet);
        }
    }
}
