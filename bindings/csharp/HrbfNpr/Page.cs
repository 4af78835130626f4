// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>A drawing on a page, in millimetres from the page's top-left corner, y down.</summary>
    public sealed class PageItem
    {
        /// <summary>Millimetres of a pixel of 1/96 inch, as in CSS.</summary>
        public const double Pixel = 25.4 / 96;

        /// <summary>A drawing at the page's corner, with pixels of 1/96 inch.</summary>
        /// <param name="drawing">What lies beyond its viewport is cut off.</param>
        public PageItem(Drawing drawing)
        {
            Drawing = drawing ?? throw new ArgumentNullException(nameof(drawing));
        }

        /// <summary>What lies beyond its viewport is cut off.</summary>
        public Drawing Drawing { get; }

        /// <summary>The viewport's left edge, mm; 0.</summary>
        public double X { get; set; }

        /// <summary>The viewport's top edge, mm; 0.</summary>
        public double Y { get; set; }

        /// <summary>Millimetres of a pixel, more than 0; <see cref="Pixel"/>.</summary>
        public double Scale { get; set; } = Pixel;

        /// <summary>Of the group around it; null = none.</summary>
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

    /// <summary>What some groups of a page are drawn with.</summary>
    public sealed class Pen
    {
        /// <summary>For some groups, or for all.</summary>
        /// <param name="groups">As <see cref="Groups"/>.</param>
        public Pen(string groups = null)
        {
            Groups = groups;
        }

        /// <summary>A group's name, or the beginning of names and a '*'; null = all.</summary>
        public string Groups { get; set; }

        /// <summary>mm, 0 or more; 0 = as drawn (default), of plotters 0.3.</summary>
        public double Width { get; set; }

        /// <summary>null, or one of alpha 0, = as drawn.</summary>
        public Color? Ink { get; set; }

        /// <summary>Of a plotter's pen, 1 to 255; 1.</summary>
        public int Number { get; set; } = 1;

        /// <summary>AsDrawn by default.</summary>
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
        /// <summary>A line through points, or a text.</summary>
        /// <param name="points">As <see cref="Points"/>.</param>
        /// <param name="text">As <see cref="Text"/>.</param>
        public Annotation(ArrayView points, string text = null)
        {
            Points = points;
            Text = text;
        }

        /// <summary>
        /// x and y of n points, float or double, mm: the line, or in the first one where the text's baseline begins.
        /// </summary>
        public ArrayView Points { get; set; }

        /// <summary>null = the points are a line.  Of plotters' formats, Hpgl writes labels, Gcode none.</summary>
        public string Text { get; set; }

        /// <summary>
        /// Of 1 to 95 bytes of UTF-8; "annotations".  Those of one group that follow each other are one layer, in the
        /// ink and line type of the first.
        /// </summary>
        public string Group { get; set; } = "annotations";

        /// <summary>mm, more than 0: of the line, or the height of the text's capitals; 0.35.</summary>
        public double Width { get; set; } = 0.35;

        /// <summary>Black by default.</summary>
        public Color Ink { get; set; } = new Color(0, 0, 0);

        /// <summary>Continuous by default.</summary>
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

    /// <summary>Drawings as vectors: SVG, PDF, HPGL and G-code.</summary>
    /// <remarks>
    /// Strokes are curves within a tolerance of the drawing's, or for plotters straight lines.  Ink stands in named
    /// groups, the layers of a file: of marks the layer's name in its point set, such as "stipples" or "hatch-2"; of
    /// lines "contour", "suggestive", "ridge", "section" and so on.  What is behind n layers of surface has
    /// " hidden n" at its end.
    /// </remarks>
    public static class Page
    {
        /// <summary>Writes a page.</summary>
        /// <param name="stream">Written to on this thread, and not closed.</param>
        /// <param name="items">The drawings; may be none if there are annotations.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="progress">May be null; called on this thread with a number in [0, 1].</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="InvalidArgumentException">Neither a drawing nor an annotation, an empty page, a number out
        /// of its range, or discs of paper, which Published frames have, for plotters or in plot order.</exception>
        /// <exception cref="StreamException">The stream failed.</exception>
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
