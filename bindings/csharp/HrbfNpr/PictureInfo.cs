// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Counts, sizes and seconds of a picture.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_picture_info")]
    public struct PictureInfo
    {
        internal uint StructSize;
        private readonly uint preset;

        /// <summary>Surfaces, or 1 of a point set.</summary>
        public readonly long Parts;

        /// <summary>Marks of all parts.</summary>
        public readonly long Marks;

        /// <summary>How many notes there are.</summary>
        public readonly long Notes;

        /// <summary>How many stages are over.</summary>
        public readonly long Stages;

        /// <summary>Width of the drawing, pixels.</summary>
        public readonly int Width;

        /// <summary>Height of the drawing, pixels.</summary>
        public readonly int Height;

        /// <summary>Corner of the box of all parts.</summary>
        public readonly Vector3d BoundsMin;

        /// <summary>The opposite corner.</summary>
        public readonly Vector3d BoundsMax;

        /// <summary>Which way is up, as used.</summary>
        public readonly Vector3d Up;

        /// <summary>Radius of the pen, as used; pixels.</summary>
        public readonly double Pen;

        /// <summary>Seconds to make the picture, without drawing it.</summary>
        public readonly double Seconds;

        /// <summary>The style.</summary>
        public Preset Preset
        {
            get { return (Preset)preset; }
        }
    }

    /// <summary>One surface of a picture, for the calls that take its parts one by one.</summary>
    /// <remarks>Its objects go on living without the picture, and may be disposed of as any others.</remarks>
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

        /// <summary>The surface; null of a point set.</summary>
        public Model Model { get; }

        /// <summary>Its marks; null with <see cref="PictureOptions.SurfaceOnly"/>.</summary>
        public PointSet PointSet { get; }

        /// <summary>Its lines; null without lines.</summary>
        public LineSet LineSet { get; }

        /// <summary>The mesh as it was fitted to; null if the source is none.</summary>
        public TriangleMesh Mesh { get; }

        /// <summary>The sides that marks are drawn on, as used.</summary>
        public Sides Sides { get; }
    }

    /// <summary>What was drawn on a sheet of views.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_views_info")]
    public unsafe struct ViewsInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Views, sections among them.</summary>
        public readonly long Views;

        /// <summary>Bytes of the file.</summary>
        public readonly long Bytes;

        /// <summary>Width of the page, mm.</summary>
        public readonly double Width;

        /// <summary>Height of the page, mm.</summary>
        public readonly double Height;

        /// <summary>0.5 of 1:2.</summary>
        public readonly double Scale;

        /// <summary>Millimetres of a unit of the model, as used.</summary>
        public readonly double UnitMm;

        private fixed byte scaleText[64];
        private fixed byte paper[64];

        /// <summary>The scale as it is written, such as "1:2".</summary>
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
