using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
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
        /// The surface that the marks lie on, or null: with <see cref="Visibility.Sheets"/>, what hides a mark is then
        /// found by casting a ray from it to the eye, exact but slow (tens of microseconds a mark drawn).
        /// </summary>
        public Model Model { get; set; }

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

        /// <summary>The marks in the default style.</summary>
        public static implicit operator Item(PointSet pointSet)
        {
            return new Item(pointSet);
        }
    }

    /// <summary>What a frame did.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_frame_info")]
    public struct FrameInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Marks of the groups that the styles use: the sum of those outside, front, back, silhouette, culled.</summary>
        public readonly long Marks;

        /// <summary>Outside the frustum.</summary>
        public readonly long Outside;

        /// <summary>Of those inside: facing the eye.</summary>
        public readonly long Front;

        /// <summary>Facing away.</summary>
        public readonly long Back;

        /// <summary>Of the contour.</summary>
        public readonly long Silhouette;

        /// <summary>Drawn as ink.</summary>
        public readonly long Shown;

        /// <summary>Front marks not shown because of light or share, and contour marks that a line does not need.</summary>
        public readonly long DroppedTone;

        /// <summary>Not shown because of depth attenuation.</summary>
        public readonly long DroppedDepth;

        /// <summary>Front marks not shown because of tone scaling.</summary>
        public readonly long DroppedZoom;

        /// <summary>Not drawn because nothing of them is seen through what is in front.</summary>
        public readonly long DroppedHidden;

        /// <summary>Discs of paper, or marks that sheets were found from.</summary>
        public readonly long Painted;

        /// <summary>Nanoseconds to transform, classify and shade.</summary>
        public readonly long NanosecondsClassify;

        /// <summary>Nanoseconds to find what hides what.</summary>
        public readonly long NanosecondsVisibility;

        /// <summary>Nanoseconds to order.</summary>
        public readonly long NanosecondsSort;

        /// <summary>Nanoseconds of the last drawing; 0 in what Prepare returns.</summary>
        public readonly long NanosecondsDraw;

        /// <summary>Bytes that the renderer keeps from frame to frame.</summary>
        public readonly long ScratchBytes;

        /// <summary>Of no class, since no tone or contour could show them.</summary>
        public readonly long Culled;
    }

    /// <summary>How a prepared frame is drawn, and what is wanted beside the picture.</summary>
    public sealed class DrawOptions
    {
        /// <summary>Byte order of the pixels; straight RGBA.</summary>
        public PixelFormat Format { get; set; } = PixelFormat.Rgba8;

        /// <summary>
        /// Bytes from a row to the one below; 0 = packed (default).  Negative for an image whose first row in memory
        /// is the lowest: the pixels given are the top-left one's, wherever it is.
        /// </summary>
        public long RowStride { get; set; }

        /// <summary>Lay the drawing over the image's contents; wants a style with transparent paper.</summary>
        public bool Over { get; set; }

        /// <summary>Blend in linear light (sRGB decoded), not in encoded values.</summary>
        public bool LinearLight { get; set; }

        /// <summary>width * height floats in the camera's convention: hides the marks behind it.</summary>
        public ArrayView HostDepth { get; set; }

        /// <summary>width * height floats, to be filled: depth of the nearest surface.</summary>
        public ArrayView Depth { get; set; }

        /// <summary>width * height uints, to be filled: 1 + running number of the nearest mark, 0 = none.</summary>
        public ArrayView Id { get; set; }

        /// <summary>width * height bytes or uints, to be filled: <see cref="MarkClass"/>.</summary>
        public ArrayView Class { get; set; }

        internal void Write(ref hrbfnpr_draw_desc desc, Pins pins)
        {
            desc.flags = (Over ? 1u : 0) | (LinearLight ? 2u : 0);
            desc.host_depth = HostDepth.ToNative(pins, 1, nameof(HostDepth));
            desc.depth = Depth.ToNative(pins, 1, nameof(Depth));
            desc.id = Id.ToNative(pins, 1, nameof(Id));
            desc.class_ = Class.ToNative(pins, 1, nameof(Class));
        }
    }

    /// <summary>What a vertex holds, and where.  A layout that is not added to any more may be shared by threads.</summary>
    /// <example>
    /// <code>var layout = new VertexLayout().Add(VertexAttribute.Position).Add(VertexAttribute.Color);</code>
    /// </example>
    public sealed unsafe class VertexLayout
    {
        private hrbfnpr_vertex_layout native;

        /// <summary>Without attributes.</summary>
        public VertexLayout()
        {
            fixed (hrbfnpr_vertex_layout* layout = &native)
            {
                Errors.Check(NativeMethods.hrbfnpr_vertex_layout_init(layout, (uint)sizeof(hrbfnpr_vertex_layout)));
            }
        }

        /// <summary>Bytes of a vertex: up to the end of its last attribute, and a multiple of 4, unless set.</summary>
        public int Stride { get; set; }

        internal hrbfnpr_vertex_layout Native
        {
            get
            {
                hrbfnpr_vertex_layout layout = native;
                layout.stride = Stride;
                return layout;
            }
        }

        /// <summary>Adds an attribute after the others, in its usual type: colours, classes and IsPaper in bytes.</summary>
        /// <returns>This layout.</returns>
        public VertexLayout Add(VertexAttribute attribute)
        {
            switch (attribute)
            {
                case VertexAttribute.Color:
                case VertexAttribute.Class:
                case VertexAttribute.IsPaper:
                    return Add(attribute, ScalarType.Uint8, End(1));
                case VertexAttribute.Id:
                    return Add(attribute, ScalarType.Uint32, End(4));
                default:
                    return Add(attribute, ScalarType.Float32, End(4));
            }
        }

        /// <summary>Adds an attribute at a place of its own.</summary>
        /// <param name="attribute">At most 16 in a layout.</param>
        /// <param name="scalar">A type that it can have.</param>
        /// <param name="offset">Bytes from the start of the vertex.</param>
        /// <returns>This layout.</returns>
        /// <exception cref="InvalidArgumentException">There are 16 already.</exception>
        public VertexLayout Add(VertexAttribute attribute, ScalarType scalar, int offset)
        {
            if (native.attribute_count >= 16)
            {
                throw new InvalidArgumentException("a vertex has 16 attributes at most");
            }
            fixed (hrbfnpr_vertex_attribute* first = &native.attributes0)
            {
                hrbfnpr_vertex_attribute* added = first + native.attribute_count++;
                added->attribute = unchecked((uint)attribute);
                added->scalar = (uint)scalar;
                added->offset = unchecked((uint)offset);
            }
            Stride = Math.Max(Stride, (offset + Size(attribute, scalar) + 3) / 4 * 4);
            return this;
        }

        private static int Size(VertexAttribute attribute, ScalarType scalar)
        {
            int bytes = scalar == ScalarType.Uint8 ? 1 : 4;
            switch (attribute)
            {
                case VertexAttribute.Color:
                    return 4 * bytes;
                case VertexAttribute.Position:
                case VertexAttribute.Window:
                case VertexAttribute.Normal:
                case VertexAttribute.Direction:
                    return 3 * bytes;
                default:
                    return bytes;
            }
        }

        private int End(int alignment)
        {
            int end = 0;
            fixed (hrbfnpr_vertex_attribute* first = &native.attributes0)
            {
                for (uint i = 0; i < native.attribute_count; ++i)
                {
                    int size = Size((VertexAttribute)first[i].attribute, (ScalarType)first[i].scalar);
                    end = Math.Max(end, (int)first[i].offset + size);
                }
            }
            return (end + alignment - 1) / alignment * alignment;
        }
    }
}
