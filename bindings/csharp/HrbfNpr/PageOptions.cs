// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    /// <summary>How a page is written; a new one holds all defaults.</summary>
    public sealed class PageOptions
    {
        /// <summary>SVG by default.</summary>
        public PageFormat Format { get; set; }

        /// <summary>How strokes are written whose width varies; Outlines by default.</summary>
        public Widths Widths { get; set; }

        /// <summary>How dots are written; Circles by default.</summary>
        public DotShape Dots { get; set; }

        /// <summary>
        /// Whether groups are sorted so that a pen travels little, and what it cannot resolve is left out, as Hpgl and
        /// Gcode always are; no by default.  Lines may be turned round, closed ones begin elsewhere, and lines whose
        /// ends are nearer than <see cref="Join"/> become one.
        /// </summary>
        public bool InPlotOrder { get; set; }

        /// <summary>
        /// Whether a line that is wider than its pen is drawn once, along its centre, and circles are drawn round; no
        /// by default: Hpgl and Gcode, and pens in plot order, fill both by several passes.
        /// </summary>
        public bool SinglePass { get; set; }

        /// <summary>
        /// Whether the page is filled with the paper of its first drawing, and viewports with another paper with
        /// theirs; yes by default.  Plotters draw none.
        /// </summary>
        public bool WithPaper { get; set; } = true;

        /// <summary>Of the page, mm, 0 or more; 0 = as far as the drawings reach (default).</summary>
        public double Width { get; set; }

        /// <summary>Of the page, mm, 0 or more; 0 = as far as the drawings reach (default).</summary>
        public double Height { get; set; }

        /// <summary>Between what is drawn and what is written, mm, 0.001 to 10; 0.05.</summary>
        public double Tolerance { get; set; } = 0.05;

        /// <summary>Ratio of neighbouring classes of widths, 1.01 to 4; 1.25.</summary>
        public double WidthStep { get; set; } = 1.25;

        /// <summary>In plot order: see there; mm, 0 or more; 0 = the pen's width (default).</summary>
        public double Join { get; set; }

        /// <summary>
        /// In plot order: shorter lines are dropped; mm, 0 or more; 0 = half the pen's width (default).
        /// </summary>
        public double Shortest { get; set; }

        /// <summary>
        /// In plot order: dots nearer to one that stays are dropped; mm, 0 or more; 0 = half the pen's width (default).
        /// </summary>
        public double DotDistance { get; set; }

        /// <summary>Of a plotter's pen, mm/s, more than 0; 30.</summary>
        public double DrawSpeed { get; set; } = 30;

        /// <summary>Of a plotter's pen, mm/s, more than 0; 80.</summary>
        public double TravelSpeed { get; set; } = 80;

        /// <summary>What a plotter takes to lower or to raise its pen, 0 or more; 0.15.</summary>
        public double PenSeconds { get; set; } = 0.15;

        /// <summary>Of Gcode: lines that lower the pen; null = "G1 Z0".</summary>
        public string PenDown { get; set; }

        /// <summary>Of Gcode: lines that raise the pen; null = "G0 Z5".</summary>
        public string PenUp { get; set; }

        /// <summary>Of the file, or null.</summary>
        public string Title { get; set; }

        /// <summary>Of the file, or null.</summary>
        public string Description { get; set; }

        /// <summary>Text on the model, the camera, the style, or null; the library's version is added.</summary>
        public string Metadata { get; set; }

        /// <summary>What groups are drawn with; of those that fit a group the last one is taken.</summary>
        public IList<Pen> Pens { get; } = new List<Pen>();

        /// <summary>Lines and texts beside the drawings.</summary>
        public IList<Annotation> Annotations { get; } = new List<Annotation>();

        internal unsafe void Write(hrbfnpr_page_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_page_desc_init(desc, (uint)sizeof(hrbfnpr_page_desc)));
            desc->format = (uint)Format;
            desc->flags = (InPlotOrder ? 1u : 0) | (WithPaper ? 0 : 2u) | (SinglePass ? 4u : 0);
            desc->widths = (uint)Widths;
            desc->dots = (uint)Dots;
            desc->width = Width;
            desc->height = Height;
            desc->tolerance = Tolerance;
            desc->width_step = WidthStep;
            desc->join = Join;
            desc->shortest = Shortest;
            desc->dot_distance = DotDistance;
            desc->draw_speed = DrawSpeed;
            desc->travel_speed = TravelSpeed;
            desc->pen_seconds = PenSeconds;
            desc->pen_down = pins.Text(PenDown);
            desc->pen_up = pins.Text(PenUp);
            desc->title = pins.Text(Title);
            desc->description = pins.Text(Description);
            desc->metadata = pins.Text(Metadata);
            WritePens(desc, pins);
            WriteAnnotations(desc, pins);
        }

        private unsafe void WritePens(hrbfnpr_page_desc* desc, Pins pins)
        {
            if (Pens.Count == 0)
            {
                return;
            }
            var pens = new hrbfnpr_pen[Pens.Count];
            var first = (hrbfnpr_pen*)pins.Pin(pens);
            for (int i = 0; i < pens.Length; ++i)
            {
                Pen pen = Pens[i] ?? throw new ArgumentNullException(nameof(Pens));
                pen.Write(first + i, pins);
            }
            desc->pens = (IntPtr)first;
            desc->pen_count = pens.Length;
        }

        private unsafe void WriteAnnotations(hrbfnpr_page_desc* desc, Pins pins)
        {
            if (Annotations.Count == 0)
            {
                return;
            }
            var annotations = new hrbfnpr_annotation[Annotations.Count];
            var first = (hrbfnpr_annotation*)pins.Pin(annotations);
            for (int i = 0; i < annotations.Length; ++i)
            {
                Annotation annotation = Annotations[i] ?? throw new ArgumentNullException(nameof(Annotations));
                annotation.Write(first + i, pins);
            }
            desc->annotations = (IntPtr)first;
            desc->annotation_count = annotations.Length;
        }
    }
}
