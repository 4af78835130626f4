// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>A drawing on a page.  Places are in mm from the page's top-left corner, y down.</summary>
    public sealed class PageItem
    {
        /// <summary>Size of a pixel of 1/96 inch, as in CSS, in mm.</summary>
        public const double Pixel = 25.4 / 96;

        /// <summary>Creates an item at the page's top-left corner, with pixels of 1/96 inch.</summary>
        /// <param name="drawing">The drawing.  What lies beyond its viewport is cut off.</param>
        public PageItem(Drawing drawing)
        {
            Drawing = drawing ?? throw new ArgumentNullException(nameof(drawing));
        }

        /// <summary>The drawing.  What lies beyond its viewport is cut off.</summary>
        public Drawing Drawing { get; }

        /// <summary>Place of the viewport's left edge, in mm; -1e6 to 1e6; default 0.</summary>
        public double X { get; set; }

        /// <summary>Place of the viewport's top edge, in mm; -1e6 to 1e6; default 0.</summary>
        public double Y { get; set; }

        /// <summary>Size of a pixel, in mm; above 0, up to 1e6; default <see cref="Pixel"/>.</summary>
        public double Scale { get; set; } = Pixel;

        /// <summary>Name of the group around the drawing; default null = no name.</summary>
        public string Name { get; set; }

        internal unsafe void Write(hrbfnpr_page_item* item, Pins pins, HeldHandles held)
        {
            Errors.Check(NativeMethods.hrbfnpr_page_item_init(item, (uint)sizeof(hrbfnpr_page_item)));
            item->drawing = held.Hold(Drawing.Handle);
            item->x = X;
            item->y = Y;
            item->scale = Scale;
            item->name = pins.Text(Name);
        }
    }

    /// <summary>A pen that draws some groups of a page.  The last pen that fits a group draws it.</summary>
    public sealed class Pen
    {
        /// <summary>Creates a pen for some groups, or for all.</summary>
        /// <param name="groups">The groups, as in <see cref="Groups"/>.</param>
        public Pen(string groups = null)
        {
            Groups = groups;
        }

        /// <summary>The groups: a name, or the beginning of names and a '*'; default null = all groups.</summary>
        public string Groups { get; set; }

        /// <summary>
        /// Width of all lines, in mm; 0 to 1e6; default 0 = as drawn.  For plotters it is the width of the pen, 0.3 if
        /// it is 0.
        /// </summary>
        public double Width { get; set; }

        /// <summary>Colour of the ink; default null = as drawn, and so is a colour with alpha 0.</summary>
        public Color? Ink { get; set; }

        /// <summary>Number of a plotter's pen; 1 to 255; default 1.</summary>
        public int Number { get; set; } = 1;

        /// <summary>Type of the lines; default AsDrawn.</summary>
        public LineType LineType { get; set; }

        internal unsafe void Write(hrbfnpr_pen* pen, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_pen_init(pen, (uint)sizeof(hrbfnpr_pen)));
            pen->groups = pins.Text(Groups);
            pen->width = Width;
            pen->number = unchecked((uint)Number);
            pen->line_type = (uint)LineType;
            if (Ink.HasValue)
            {
                Ink.Value.Write(pen->ink);
            }
        }
    }

    /// <summary>A line or a text beside the drawings of a page.</summary>
    public sealed class Annotation
    {
        /// <summary>Creates a line through points, or a text.</summary>
        /// <param name="points">The points, as in <see cref="Points"/>.</param>
        /// <param name="text">The text, as in <see cref="Text"/>; null = a line.</param>
        public Annotation(ArrayView points, string text = null)
        {
            Points = points;
            Text = text;
        }

        /// <summary>
        /// Points of the line, two at least, or the start of the text's baseline, in mm: x and y of n points, float or
        /// double.
        /// </summary>
        public ArrayView Points { get; set; }

        /// <summary>
        /// A text; default null = the points are a line.  Hpgl writes texts as labels, Gcode leaves them out.
        /// </summary>
        public string Text { get; set; }

        /// <summary>
        /// Name of its group, 1 to 95 bytes of UTF-8; default "annotations".  Consecutive annotations of one group
        /// share its layer and pen, and the ink and line type of the first of them.
        /// </summary>
        public string Group { get; set; } = "annotations";

        /// <summary>
        /// Width of the line, or height of the text's capitals, in mm; above 0, up to 1e6; default 0.35.
        /// </summary>
        public double Width { get; set; } = 0.35;

        /// <summary>Colour of the ink; default black.</summary>
        public Color Ink { get; set; } = new Color(0, 0, 0);

        /// <summary>Type of the line; default Continuous.</summary>
        public LineType LineType { get; set; } = LineType.Continuous;

        internal unsafe void Write(hrbfnpr_annotation* annotation, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_annotation_init(annotation, (uint)sizeof(hrbfnpr_annotation)));
            annotation->points = Points.ToNative(pins, 2, nameof(Points));
            annotation->text = pins.Text(Text);
            annotation->group = pins.Text(Group);
            annotation->width = Width;
            Ink.Write(annotation->ink);
            annotation->line_type = (uint)LineType;
        }
    }

    /// <summary>Writes drawings as vectors: SVG, PDF, HPGL, G-code and DXF.</summary>
    /// <remarks>
    /// Strokes become curves within a tolerance of the drawing's lines; for plotters they become straight lines.  Ink
    /// is in named groups, the layers of a file.  The group of a layer of marks has that layer's name, such as
    /// "stipples" or "hatch-2".  Groups of lines are called "contour", "suggestive", "ridge", "section" and so on.  Ink
    /// behind n layers of surface has " hidden n" at the end of its name.
    /// </remarks>
    public static class Page
    {
        /// <summary>Writes a page.</summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <param name="items">The drawings; may be empty if there are annotations.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="InvalidArgumentException">There is no drawing and no annotation, the page is empty, a
        /// number is out of its range, or a drawing with Visibility.Published, which has discs of paper, is written for
        /// a plotter or in plot order.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public static unsafe PageInfo Write(
            Stream stream, IReadOnlyList<PageItem> items, PageOptions options = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken),
            Context context = null)
        {
            if (items == null)
            {
                throw new ArgumentNullException(nameof(items));
            }
            var state = new StreamState(stream);
            context = Context.Resolve(context);
            using (var pins = new Pins())
            using (var held = new HeldHandles())
            using (var user = new UserHandle(state))
            using (var call = new LongCall(context.Handle, progress, cancellationToken))
            {
                hrbfnpr_page_desc desc;
                (options ?? new PageOptions()).Write(&desc, pins);
                WriteItems(&desc, items, pins, held);
                PageInfo info;
                Errors.Check(NativeMethods.hrbfnpr_page_info_init(&info, (uint)sizeof(PageInfo)));
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_page_write(
                    context.Handle, &desc, StreamState.Write, user.Pointer, &info, call.Operation, &error);
                state.CheckStream();
                call.Check(status, &error);
                return info;
            }
        }

        private static unsafe void WriteItems(
            hrbfnpr_page_desc* desc, IReadOnlyList<PageItem> items, Pins pins, HeldHandles held)
        {
            if (items.Count == 0)
            {
                return;
            }
            var structs = new hrbfnpr_page_item[items.Count];
            var first = (hrbfnpr_page_item*)pins.Pin(structs);
            for (int i = 0; i < structs.Length; ++i)
            {
                PageItem item = items[i] ?? throw new ArgumentNullException(nameof(items));
                item.Write(first + i, pins, held);
            }
            desc->items = (IntPtr)first;
            desc->item_count = structs.Length;
        }
    }
}
