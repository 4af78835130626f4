// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>What a drawing holds, and what making it took.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_drawing_info")]
    public struct DrawingInfo
    {
        internal uint StructSize;
        private readonly uint reserved;

        /// <summary>Items that were drawn.</summary>
        public readonly long Items;

        /// <summary>Layers of ink.</summary>
        public readonly long Layers;

        /// <summary>Dots of ink.</summary>
        public readonly long Dots;

        /// <summary>Strokes.</summary>
        public readonly long Strokes;

        /// <summary>Points of all strokes.</summary>
        public readonly long StrokePoints;

        /// <summary>Marks of the layers that the styles use: the sum of those outside, front, back, silhouette, culled.</summary>
        public readonly long Marks;

        /// <summary>Outside the frustum.</summary>
        public readonly long Outside;

        /// <summary>Of those inside: facing the eye.</summary>
        public readonly long Front;

        /// <summary>Facing away.</summary>
        public readonly long Back;

        /// <summary>Of the contour.</summary>
        public readonly long Silhouette;

        /// <summary>Of no class, since no tone or contour could show them.</summary>
        public readonly long Culled;

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

        /// <summary>Discs of paper, or marks that depth layers were found from.</summary>
        public readonly long Splats;

        /// <summary>Nanoseconds to transform, classify and shade.</summary>
        public readonly long NanosecondsClassify;

        /// <summary>Nanoseconds to find what hides what.</summary>
        public readonly long NanosecondsVisibility;

        /// <summary>Nanoseconds to order.</summary>
        public readonly long NanosecondsSort;

        /// <summary>Bytes kept by the drawing.</summary>
        public readonly long Bytes;

        /// <summary>Bytes kept by its renderer, drawings left out.</summary>
        public readonly long ScratchBytes;

        /// <summary>Curves that lines were drawn from.</summary>
        public readonly long LineCurves;

        /// <summary>Cusps of these.</summary>
        public readonly long LineCusps;

        /// <summary>Crossings of their images, where the farther one changes its visibility.</summary>
        public readonly long LineCrossings;

        /// <summary>Curves that end inside the surface, and places where one was missed.</summary>
        public readonly long LineBroken;

        /// <summary>Curves whose visibility did not add up: each part is as a ray of its own says.</summary>
        public readonly long LineSettled;

        /// <summary>Of these, curves with a part whose ray was not certain.</summary>
        public readonly long LineContradictions;

        /// <summary>Nanoseconds to trace lines, and to find what hides them.</summary>
        public readonly long NanosecondsLines;

        /// <summary>
        /// Curves whose visibility did not add up at first: they, and those that cross them, were made finer.
        /// </summary>
        public readonly long LineRefined;

        /// <summary>
        /// Cells of the image, four pixels wide or more, with so many crossings that none was taken: lines run to and
        /// fro over one another there, as on a flat face seen edge-on.
        /// </summary>
        public readonly long LineTangles;
    }

    /// <summary>
    /// A layer of a drawing: ink of one layer of marks, of the front or of contours, or of an item's lines.
    /// </summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_drawing_layer_info")]
    public unsafe struct DrawingLayerInfo
    {
        internal uint StructSize;
        private readonly uint markClass;

        /// <summary>Number of the item.</summary>
        public readonly long Item;

        /// <summary>Number of the layer in the item's point set; -1: of lines.</summary>
        public readonly long Layer;

        private readonly uint kind;
        private readonly uint shape;
        private fixed byte name[64];
        private fixed float ink[4];

        /// <summary>Dots in the layer.</summary>
        public readonly long Dots;

        /// <summary>Strokes in the layer.</summary>
        public readonly long Strokes;

        /// <summary>Front or Silhouette.</summary>
        public MarkClass MarkClass
        {
            get { return (MarkClass)markClass; }
        }

        /// <summary>What the marks are; Any of lines.</summary>
        public LayerKind Kind
        {
            get { return Layer < 0 ? LayerKind.Any : (LayerKind)kind; }
        }

        /// <summary>What the lines are; null of marks.</summary>
        public LineKind? LineKind
        {
            get { return Layer < 0 ? (LineKind?)kind : null; }
        }

        /// <summary>How they are drawn.</summary>
        public Shape Shape
        {
            get { return (Shape)shape; }
        }

        /// <summary>What the layer of marks is called; empty of lines.</summary>
        public string Name
        {
            get
            {
                fixed (byte* text = name)
                {
                    return Errors.Utf8(text);
                }
            }
        }

        /// <summary>Its colour.</summary>
        public Color Ink
        {
            get
            {
                fixed (float* channels = ink)
                {
                    return Color.Read(channels);
                }
            }
        }
    }

    /// <summary>What an id in a drawing stands for.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mark_identity")]
    public struct MarkIdentity
    {
        internal uint StructSize;

        /// <summary>1 + running number of the mark, over items and layers in order.</summary>
        public readonly uint Id;

        /// <summary>Number of the item.</summary>
        public readonly long Item;

        /// <summary>Number of the layer in the item's point set.</summary>
        public readonly long Layer;

        /// <summary>Number of the mark in the layer.</summary>
        public readonly long Mark;

        /// <summary>Number of its stroke in the layer; -1 = of none.</summary>
        public readonly long Stroke;

        /// <summary>Its place along the stroke.</summary>
        public readonly long Place;
    }
}
