// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    /// <summary>How a page is written; a new one holds all defaults.</summary>
    public sealed class PageOptions
    {
        /// <summary>Format of the file; default Svg.</summary>
        public PageFormat Format { get; set; }

        /// <summary>How strokes of varying width are written; default Outlines.</summary>
        public Widths Widths { get; set; }

        /// <summary>How dots are written; default Circles.</summary>
        public DotShape Dots { get; set; }

        /// <summary>How the curves of lines of one width are written; default Arcs.</summary>
        public Curves Curves { get; set; }

        /// <summary>
        /// Whether to sort each group so that a pen travels little; default false.  Hpgl and Gcode are always sorted.
        /// </summary>
        /// <remarks>
        /// Lines may be turned round, closed lines may begin elsewhere, and lines whose ends are nearer than
        /// <see cref="Join"/> become one.
        /// </remarks>
        public bool InPlotOrder { get; set; }

        /// <summary>
        /// Whether to draw a line that is wider than its pen once, along its centre; default false.  Otherwise Hpgl,
        /// Gcode and pens in plot order fill such a line by several passes, side by side.
        /// </summary>
        public bool SinglePass { get; set; }

        /// <summary>
        /// Whether the page has the paper of its first drawing, and drawings with another paper have theirs; default
        /// true.  Plotters never draw paper.
        /// </summary>
        public bool WithPaper { get; set; } = true;

        /// <summary>Width of the page, in mm; 0 to 1e6; default 0 = as far as the drawings reach.</summary>
        public double Width { get; set; }

        /// <summary>Height of the page, in mm; 0 to 1e6; default 0 = as far as the drawings reach.</summary>
        public double Height { get; set; }

        /// <summary>
        /// Greatest distance between drawn and written lines, in mm; 0.001 to 10; default 0.05.  Larger: smaller files,
        /// rougher curves.
        /// </summary>
        public double Tolerance { get; set; } = 0.05;

        /// <summary>
        /// Ratio of the widths of two consecutive classes, with <see cref="HrbfNpr.Widths.Classes"/>; 1.01 to 4;
        /// default 1.25.
        /// </summary>
        public double WidthStep { get; set; } = 1.25;

        /// <summary>
        /// In plot order, distance between the ends of two lines below which they become one, in mm; 0 to 1e6; default
        /// 0 = the pen's width.
        /// </summary>
        public double Join { get; set; }

        /// <summary>
        /// In plot order, length below which lines are dropped, in mm; 0 to 1e6; default 0 = half the pen's width.
        /// </summary>
        public double Shortest { get; set; }

        /// <summary>
        /// In plot order, distance from a dot that stays below which other dots are dropped, in mm; 0 to 1e6; default 0
        /// = half the pen's width.
        /// </summary>
        public double DotDistance { get; set; }

        /// <summary>
        /// In plot order, length that the pen draws at most before it is raised, in mm; 1 to 1e6; default 0 = no limit.
        /// A longer line is cut into equal parts.
        /// </summary>
        public double Longest { get; set; }

        /// <summary>Speed of a plotter's pen on the paper, in mm/s; above 0, up to 1e6; default 30.</summary>
        public double DrawSpeed { get; set; } = 30;

        /// <summary>Speed of a plotter's pen above the paper, in mm/s; above 0, up to 1e6; default 80.</summary>
        public double TravelSpeed { get; set; } = 80;

        /// <summary>Time that it takes to lower or to raise the pen, in seconds; 0 to 3600; default 0.15.</summary>
        public double PenSeconds { get; set; } = 0.15;

        /// <summary>Gcode: lines that lower the pen; default null = "G1 Z0".</summary>
        public string PenDown { get; set; }

        /// <summary>Gcode: lines that raise the pen; default null = "G0 Z5".</summary>
        public string PenUp { get; set; }

        /// <summary>Title of the file; default null = none.</summary>
        public string Title { get; set; }

        /// <summary>Description of the file; default null = none.</summary>
        public string Description { get; set; }

        /// <summary>
        /// Text about the model, the camera or the style; default null = none.  The library's version is added.
        /// </summary>
        public string Metadata { get; set; }

        /// <summary>The pens; default empty.  The last pen that fits a group draws it.</summary>
        public IList<Pen> Pens { get; } = new List<Pen>();

        /// <summary>Lines and texts beside the drawings; default empty.</summary>
        public IList<Annotation> Annotations { get; } = new List<Annotation>();

        internal unsafe void Write(hrbfnpr_page_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_page_desc_init(desc, (uint)sizeof(hrbfnpr_page_desc)));
            desc->format = (uint)Format;
            desc->flags = (InPlotOrder ? 1u : 0) | (WithPaper ? 0 : 2u) | (SinglePass ? 4u : 0);
            desc->widths = (uint)Widths;
            desc->dots = (uint)Dots;
            desc->curves = (uint)Curves;
            desc->width = Width;
            desc->height = Height;
            desc->tolerance = Tolerance;
            desc->width_step = WidthStep;
            desc->join = Join;
            desc->shortest = Shortest;
            desc->dot_distance = DotDistance;
            desc->longest = Longest;
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
