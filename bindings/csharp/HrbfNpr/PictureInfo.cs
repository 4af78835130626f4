// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Counts, sizes and times of a picture.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_picture_info")]
    public struct PictureInfo
    {
        internal uint StructSize;
        private readonly uint preset;

        /// <summary>Number of surfaces; 1 for a point set.</summary>
        public readonly long Parts;

        /// <summary>Number of marks of all parts.</summary>
        public readonly long Marks;

        /// <summary>Number of notes.</summary>
        public readonly long Notes;

        /// <summary>Number of stages that have ended.</summary>
        public readonly long Stages;

        /// <summary>Width of the drawing, in pixels; 0 with <see cref="PictureOptions.SurfaceOnly"/>.</summary>
        public readonly int Width;

        /// <summary>Height of the drawing, in pixels; 0 with <see cref="PictureOptions.SurfaceOnly"/>.</summary>
        public readonly int Height;

        /// <summary>Lower corner of the box around all parts.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>Upper corner of the box.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Direction that is up, as used.</summary>
        public readonly Vector3d Up;

        /// <summary>Radius of the pen as used, in pixels.</summary>
        public readonly double Pen;

        /// <summary>Time that it took to make the picture, in seconds; drawing is not included.</summary>
        public readonly double Seconds;

        /// <summary>The preset that was used.</summary>
        public Preset Preset
        {
            get { return (Preset)preset; }
        }
    }

    /// <summary>One surface of a picture.  Its objects can be passed to the calls of the other classes.</summary>
    /// <remarks>The objects stay alive without the picture, and may be disposed of like any others.</remarks>
    public sealed class PicturePart
    {
        internal PicturePart(Model model, PointSet pointSet, LineSet lineSet, TriangleMesh mesh, Sides sides)
        {
            Model = model;
            PointSet = pointSet;
            LineSet = lineSet;
            Mesh = mesh;
            Sides = sides;
        }

        /// <summary>The surface; null for a point set.</summary>
        public Model Model { get; }

        /// <summary>The marks; null with <see cref="PictureOptions.SurfaceOnly"/>.</summary>
        public PointSet PointSet { get; }

        /// <summary>The lines; null without lines.</summary>
        public LineSet LineSet { get; }

        /// <summary>The mesh that the surface was fitted to; null for other sources.</summary>
        public TriangleMesh Mesh { get; }

        /// <summary>Sides on which marks are drawn, as used.</summary>
        public Sides Sides { get; }
    }

    /// <summary>The sheet of views that was written.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_views_info")]
    public unsafe struct ViewsInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Number of views and sections.</summary>
        public readonly long Views;

        /// <summary>Bytes that were written.</summary>
        public readonly long Bytes;

        /// <summary>Width of the page, in mm.</summary>
        public readonly double Width;

        /// <summary>Height of the page, in mm.</summary>
        public readonly double Height;

        /// <summary>Scale as a number: 0.5 for 1:2.</summary>
        public readonly double Scale;

        /// <summary>Size of a unit of the model, as used, in mm.</summary>
        public readonly double UnitMm;

        private fixed byte scaleText[64];
        private fixed byte paper[64];

        /// <summary>Number of drawn pieces of lines that rays were compared with (<see cref="ViewsOptions.Verify"/>).</summary>
        public readonly long Pieces;

        /// <summary>Number of pieces whose decided rays all agree with the drawing.</summary>
        public readonly long Agreeing;

        /// <summary>
        /// Number of pieces without a decided ray: they are within 0.05 mm of an edge, in the view or in depth.
        /// </summary>
        public readonly long Undecided;

        /// <summary>Number of pieces that were divided, or drawn otherwise, because rays disagreed.</summary>
        public readonly long Repaired;

        /// <summary>Scale in words, such as "1:2".</summary>
        public string ScaleText
        {
            get
            {
                fixed (byte* text = scaleText)
                {
                    return Errors.Utf8(text);
                }
            }
        }

        /// <summary>The paper, such as "a3" or "297 x 210".</summary>
        public string Paper
        {
            get
            {
                fixed (byte* text = paper)
                {
                    return Errors.Utf8(text);
                }
            }
        }
    }
}
