// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>On which paper a picture is written, and with which pens; a new one holds all defaults.</summary>
    public sealed class PicturePageOptions
    {
        /// <summary>
        /// Format, tolerance, speeds, pens and the like.  Its annotations and its size are not used; its title,
        /// description and metadata are chosen where they are null.
        /// </summary>
        public PageOptions Page { get; set; } = new PageOptions();

        /// <summary>
        /// "a0" to "a6", "letter", "legal", "tabloid", or "210x297" in mm: the drawing fills it, turned as it fits
        /// better; null = a pixel is 25.4 / 96 mm (default).
        /// </summary>
        public string Paper { get; set; }

        /// <summary>Free margin on each side of the paper, mm; 10.</summary>
        public double PaperMargin { get; set; } = 10;

        /// <summary>
        /// Widths of the pens at hand, mm, ascending: each group gets the one nearest to its lines' median width; null
        /// = as drawn (default).
        /// </summary>
        public double[] PenWidths { get; set; }

        internal unsafe void Write(hrbfnpr_picture_page_desc* desc, PageFormat? format, Pins pins)
        {
            Errors.Check(
                NativeMethods.hrbfnpr_picture_page_desc_init(desc, (uint)sizeof(hrbfnpr_picture_page_desc)));
            desc->page = (IntPtr)PictureOutputs.Describe(Page ?? new PageOptions(), format, pins);
            desc->paper = pins.Text(Paper);
            desc->paper_margin = PaperMargin;
            desc->pen_widths = ((ArrayView)PenWidths).ToNative(pins, 1, nameof(PenWidths));
        }
    }

    /// <summary>How a sheet of views is drawn; a new one holds all defaults.</summary>
    public sealed class ViewsOptions
    {
        /// <summary>
        /// Whether planes of symmetry through the middle have a centre line in each view that sees them as a line; no
        /// by default.
        /// </summary>
        public bool CentreLines { get; set; }

        /// <summary>
        /// Whether the name of each view stands above it; no by default.  That of a section always does.
        /// </summary>
        public bool Labels { get; set; }

        /// <summary>
        /// Whether the source's format is in metres, as glTF: a <see cref="UnitMm"/> of 0 is 1000; no by default.
        /// </summary>
        public bool UnitIsMetre { get; set; }

        /// <summary>Where views stand; First.</summary>
        public ProjectionAngle Projection { get; set; }

        /// <summary>How hidden edges are drawn; Dashed.</summary>
        public HiddenEdges Hidden { get; set; }

        /// <summary>
        /// Names with commas between: front, back, left, right, top, bottom, iso; null = "front,left,top,iso", of third
        /// angle "front,right,top,iso".
        /// </summary>
        public string Views { get; set; }

        /// <summary>
        /// Planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle, "1:1:0:5" at x + y = 5.  An
        /// axis without a sign is seen from the front, from above or from the side that is drawn; "+z:20" from above,
        /// "-z:20" from below.  null = none.
        /// </summary>
        public string Sections { get; set; }

        /// <summary>
        /// "a0" to "a6", "letter", "legal" or "tabloid", lying, or "297x210", width and height in mm; null = "auto",
        /// the smallest of a4 to a0 that has room at the scale, a3 where that is "auto", too.
        /// </summary>
        public string Paper { get; set; }

        /// <summary>
        /// "1:2" = half as large as it is; null = "auto", the largest of 1, 2 and 5 times a power of ten that has room.
        /// </summary>
        public string Scale { get; set; }

        /// <summary>
        /// Thin lines where the surface bends without an edge: kinds with commas between, ridges, valleys, suggestive;
        /// null = none.
        /// </summary>
        public string Smooth { get; set; }

        /// <summary>Title in the title block; null = <see cref="Model"/> without the ending of its name.</summary>
        public string Title { get; set; }

        /// <summary>Name of the file in the title block; null = <see cref="PictureSource.Name"/>.</summary>
        public string Model { get; set; }

        /// <summary>
        /// Millimetres of a unit of the model, up to 1e9; 0 = 1, or 1000 with <see cref="UnitIsMetre"/> (default).
        /// </summary>
        public double UnitMm { get; set; }

        /// <summary>
        /// Degrees, above 0: edges of a mesh are sharp if its faces meet at more than it; 30.  Larger: fewer edges.
        /// </summary>
        public double CreaseAngle { get; set; } = 30;

        /// <summary>Width of outlines, mm, 0.01 to 1000; thin lines are half as wide; 0.5.</summary>
        public double LineWidth { get; set; } = 0.5;

        /// <summary>Distance of the lines in cut faces, mm, 0.01 to 1000; 3.</summary>
        public double HatchSpacing { get; set; } = 3;

        /// <summary>Free space between views, mm, above 0; 15.</summary>
        public double Spacing { get; set; } = 15;

        /// <summary>
        /// Format, tolerance, speeds and the like; null = their defaults with a tolerance of 0.02.  Its annotations,
        /// pens and size are not used.
        /// </summary>
        public PageOptions Page { get; set; }

        internal unsafe void Write(hrbfnpr_views_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_views_desc_init(desc, (uint)sizeof(hrbfnpr_views_desc)));
            desc->flags = (CentreLines ? 1u : 0) | (Labels ? 2u : 0) | (UnitIsMetre ? 4u : 0);
            desc->projection = (uint)Projection;
            desc->hidden = (uint)Hidden;
            desc->views = pins.Text(Views);
            desc->sections = pins.Text(Sections);
            desc->paper = pins.Text(Paper);
            desc->scale = pins.Text(Scale);
            desc->smooth = pins.Text(Smooth);
            desc->title = pins.Text(Title);
            desc->model = pins.Text(Model);
            desc->unit_mm = UnitMm;
            desc->crease_angle = CreaseAngle;
            desc->line_width = LineWidth;
            desc->hatch_spacing = HatchSpacing;
            desc->spacing = Spacing;
            desc->page = Page == null ? IntPtr.Zero : (IntPtr)PictureOutputs.Describe(Page, null, pins);
        }
    }

    internal static unsafe class PictureOutputs
    {
        /// <summary>Options of a page as a struct that stays where it is as long as the pins.</summary>
        internal static hrbfnpr_page_desc* Describe(PageOptions options, PageFormat? format, Pins pins)
        {
            var page = (hrbfnpr_page_desc*)pins.Pin(new hrbfnpr_page_desc[1]);
            options.Write(page, pins);
            page->format = (uint)(format ?? options.Format);
            return page;
        }
    }
}
