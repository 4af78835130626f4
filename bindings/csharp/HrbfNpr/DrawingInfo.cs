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

        /// <summary>Number of items that were drawn.</summary>
        public readonly long Items;

        /// <summary>Number of layers of ink.</summary>
        public readonly long Layers;

        /// <summary>Number of dots of ink.</summary>
        public readonly long Dots;

        /// <summary>Number of strokes of marks and of lines.</summary>
        public readonly long Strokes;

        /// <summary>Number of points of all strokes.</summary>
        public readonly long StrokePoints;

        /// <summary>
        /// Number of marks of the layers that the styles use: those outside, front, back, silhouette and culled.
        /// </summary>
        public readonly long Marks;

        /// <summary>Number of marks outside the view frustum.</summary>
        public readonly long Outside;

        /// <summary>Number of marks inside the frustum that face the eye.</summary>
        public readonly long Front;

        /// <summary>Number of marks inside the frustum that face away from the eye.</summary>
        public readonly long Back;

        /// <summary>Number of marks inside the frustum near a contour; 0 without Visibility.Published.</summary>
        public readonly long Silhouette;

        /// <summary>
        /// Number of marks without a class, because no tone could show them and they were skipped; 0 with
        /// Visibility.Published.
        /// </summary>
        public readonly long Culled;

        /// <summary>Number of marks drawn as ink.</summary>
        public readonly long Shown;

        /// <summary>Number of front marks not shown because of light or share.</summary>
        public readonly long DroppedTone;

        /// <summary>Number of front and silhouette marks not shown because of their distance.</summary>
        public readonly long DroppedDepth;

        /// <summary>Number of front marks not shown because of the zoom.</summary>
        public readonly long DroppedZoom;

        /// <summary>
        /// Number of marks not drawn because the surface in front of them lets nothing of them through.
        /// </summary>
        public readonly long DroppedHidden;

        /// <summary>
        /// Number of marks from which depth layers were found; with Visibility.Published, number of discs of paper.
        /// </summary>
        public readonly long Splats;

        /// <summary>Time for transforms, classes and tones, in nanoseconds.</summary>
        public readonly long NanosecondsClassify;

        /// <summary>Time for finding what hides marks, in nanoseconds.</summary>
        public readonly long NanosecondsVisibility;

        /// <summary>Time for ordering ink, in nanoseconds.</summary>
        public readonly long NanosecondsSort;

        /// <summary>Bytes that the drawing keeps.</summary>
        public readonly long Bytes;

        /// <summary>Bytes that its renderer keeps, without drawings.</summary>
        public readonly long ScratchBytes;

        /// <summary>Number of curves that lines were drawn from.</summary>
        public readonly long LineCurves;

        /// <summary>Number of cusps of these curves.</summary>
        public readonly long LineCusps;

        /// <summary>Number of crossings of their images at which the farther curve changes its visibility.</summary>
        public readonly long LineCrossings;

        /// <summary>Number of curves that end inside the surface, and of places where a curve was missed.</summary>
        public readonly long LineBroken;

        /// <summary>Number of curves whose visibility did not add up.  A ray decided for each of their parts.</summary>
        public readonly long LineSettled;

        /// <summary>Number of these curves that have a part whose ray was not certain.</summary>
        public readonly long LineContradictions;

        /// <summary>Time for lines, in nanoseconds.</summary>
        public readonly long NanosecondsLines;

        /// <summary>
        /// Number of curves whose visibility did not add up at first.  They, and those that cross them, were refined.
        /// </summary>
        public readonly long LineRefined;

        /// <summary>
        /// Number of cells of the image, four pixels wide or more, with too many crossings, of which none was used.  Lines
        /// run to and fro over each other there, as on a flat face seen edge-on.
        /// </summary>
        public readonly long LineTangles;

        /// <summary>
        /// Number of visible and hidden parts of lines that rays were compared with (<see cref="Style.VerifyLines"/>).
        /// </summary>
        public readonly long LinePieces;

        /// <summary>Number of these parts whose decided rays all agree with the drawing.</summary>
        public readonly long LineAgreeing;

        /// <summary>
        /// Number of these parts without a decided ray: they are within 0.4 pixels of an edge, in the image or in depth.
        /// </summary>
        public readonly long LineUndecided;

        /// <summary>Number of parts that were divided, or drawn otherwise than counted, because rays disagreed.</summary>
        public readonly long LineRepaired;
    }

    /// <summary>A layer of a drawing: the ink of one layer of marks, or of lines of an item.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_drawing_layer_info")]
    public unsafe struct DrawingLayerInfo
    {
        internal uint StructSize;
        private readonly uint markClass;

        /// <summary>Number of the item.</summary>
        public readonly long Item;

        /// <summary>Number of the layer in the item's point set; -1 = lines.</summary>
        public readonly long Layer;

        private readonly uint kind;
        private readonly uint shape;
        private fixed byte name[64];
        private fixed float ink[4];

        /// <summary>Number of dots in the layer.</summary>
        public readonly long Dots;

        /// <summary>Number of strokes in the layer.</summary>
        public readonly long Strokes;

        /// <summary>Number of the ink in <see cref="Style.Palette"/>; -1 = the layer's own ink.</summary>
        public readonly int InkNumber;

        private readonly uint reserved;

        /// <summary>Class of the marks: Front or Silhouette.</summary>
        public MarkClass MarkClass
        {
            get { return (MarkClass)markClass; }
        }

        /// <summary>Kind of the layer of marks; Any for lines.</summary>
        public LayerKind Kind
        {
            get { return Layer < 0 ? LayerKind.Any : (LayerKind)kind; }
        }

        /// <summary>Kind of the lines; null for marks.</summary>
        public LineKind? LineKind
        {
            get { return Layer < 0 ? (LineKind?)kind : null; }
        }

        /// <summary>Shape of the ink.</summary>
        public Shape Shape
        {
            get { return (Shape)shape; }
        }

        /// <summary>Name of the layer of marks; for lines that of their style, or empty.</summary>
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

        /// <summary>Colour of the ink.</summary>
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

    /// <summary>The mark that an id belongs to.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mark_identity")]
    public struct MarkIdentity
    {
        internal uint StructSize;

        /// <summary>The id: 1 + the number of the mark over all items and layers in order.</summary>
        public readonly uint Id;

        /// <summary>Number of the item.</summary>
        public readonly long Item;

        /// <summary>Number of the layer in the item's point set.</summary>
        public readonly long Layer;

        /// <summary>Number of the mark in the layer.</summary>
        public readonly long Mark;

        /// <summary>Number of its stroke in the layer; -1 = it is in no stroke.</summary>
        public readonly long Stroke;

        /// <summary>Its place along the stroke, from 0.</summary>
        public readonly long Place;
    }
}
