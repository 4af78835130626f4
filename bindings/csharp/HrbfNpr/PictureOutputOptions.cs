// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>The paper and the pens with which a picture is written; a new one holds all defaults.</summary>
    public sealed class PicturePageOptions
    {
        /// <summary>Format, tolerance, speeds, pens and the like; default: a page with all defaults.</summary>
        /// <remarks>
        /// Its annotations and its size are not used.  Its title, description and metadata are chosen where they are
        /// null.
        /// </remarks>
        public PageOptions Page { get; set; } = new PageOptions();

        /// <summary>
        /// Paper that the drawing fills, turned as it fits better: "a0" to "a6", "letter", "legal", "tabloid", or width
        /// and height in mm, such as "210x297"; default null = a pixel is 25.4 / 96 mm.
        /// </summary>
        public string Paper { get; set; }

        /// <summary>Free margin on each side of the paper, in mm; 0 or more; default 10.</summary>
        public double PaperMargin { get; set; } = 10;

        /// <summary>
        /// Widths of the pens at hand, in mm, ascending; default null = as <see cref="Page"/> says.  Each group gets
        /// the pen nearest to the median width of its lines.
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
        /// Whether to draw a centre line for each plane of symmetry through the middle, in each view that sees the
        /// plane as a line; default false.
        /// </summary>
        public bool CentreLines { get; set; }

        /// <summary>
        /// Whether to write the name of each view above it; default false.  Sections always have their names.
        /// </summary>
        public bool Labels { get; set; }

        /// <summary>
        /// Whether the format of the source is in metres, as glTF is; default false.  A <see cref="UnitMm"/> of 0 then
        /// means 1000.
        /// </summary>
        public bool UnitIsMetre { get; set; }

        /// <summary>
        /// Whether rays are compared with all drawn lines, so that wrong pieces are repaired; default false.
        /// <see cref="ViewsInfo"/> and the description of the page have the counts.
        /// </summary>
        public bool Verify { get; set; }

        /// <summary>Where views stand; default First.</summary>
        public ProjectionAngle Projection { get; set; }

        /// <summary>How hidden edges are drawn; default Dashed.</summary>
        public HiddenEdges Hidden { get; set; }

        /// <summary>How tangent edges are drawn; default Short.</summary>
        public TangentEdges Tangent { get; set; }

        /// <summary>
        /// Names of views with commas between: front, back, left, right, top, bottom, iso; default null =
        /// "front,left,top,iso", or "front,right,top,iso" with third angle.
        /// </summary>
        public string Views { get; set; }

        /// <summary>
        /// Cutting planes with semicolons between: "z:20" cuts at z = 20, "z" through the middle, "1:1:0:5" at x + y =
        /// 5; default null = none.
        /// </summary>
        /// <remarks>
        /// "+z:20" is seen from above and "-z:20" from below.  An axis without a sign is seen from the front, from
        /// above, or from the side that is drawn.
        /// </remarks>
        public string Sections { get; set; }

        /// <summary>
        /// Paper: "a0" to "a6", "letter", "legal" or "tabloid", in landscape format, or width and height in mm, such as
        /// "297x210"; default null = "auto" = the smallest of a4 to a0 that has room at the scale, or a3 if the scale
        /// is "auto", too.
        /// </summary>
        public string Paper { get; set; }

        /// <summary>
        /// Scale, such as "1:2" for half the size; default null = "auto" = the largest of 1, 2 and 5 times a power of
        /// ten that has room on the paper.
        /// </summary>
        public string Scale { get; set; }

        /// <summary>
        /// Thin lines where the surface bends without an edge, as kinds with commas between: ridges, valleys,
        /// suggestive; default null = "none".
        /// </summary>
        public string Smooth { get; set; }

        /// <summary>
        /// Title in the title block; default null = <see cref="Model"/> without the ending of its name.
        /// </summary>
        public string Title { get; set; }

        /// <summary>Name of the file in the title block; default null = <see cref="PictureSource.Name"/>.</summary>
        public string Model { get; set; }

        /// <summary>
        /// Size of a unit of the model, in mm; above 0, up to 1e9; default 0 = 1, or 1000 with
        /// <see cref="UnitIsMetre"/>.
        /// </summary>
        public double UnitMm { get; set; }

        /// <summary>
        /// Angle between two faces of a mesh, in degrees, above which their edge is sharp; above 0, up to 1e9; default
        /// 30.  Larger: fewer edges.
        /// </summary>
        public double CreaseAngle { get; set; } = 30;

        /// <summary>Width of outlines, in mm; 0.01 to 1000; default 0.5.  Thin lines are half as wide.</summary>
        public double LineWidth { get; set; } = 0.5;

        /// <summary>Distance between the lines in cut faces, in mm; 0.01 to 1000; default 3.</summary>
        public double HatchSpacing { get; set; } = 3;

        /// <summary>Free space between views, in mm; above 0, up to 1e9; default 15.</summary>
        public double Spacing { get; set; } = 15;

        /// <summary>
        /// Format, tolerance, speeds and the like; default null = their defaults with a tolerance of 0.02.
        /// </summary>
        /// <remarks>Its annotations, pens and size are not used.</remarks>
        public PageOptions Page { get; set; }

        internal unsafe void Write(hrbfnpr_views_desc* desc, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_views_desc_init(desc, (uint)sizeof(hrbfnpr_views_desc)));
            desc->flags = (CentreLines ? 1u : 0) | (Labels ? 2u : 0) | (UnitIsMetre ? 4u : 0)
                | (Verify ? 8u : 0);
            desc->projection = (uint)Projection;
            desc->hidden = (uint)Hidden;
            desc->tangent = (uint)Tangent;
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
        /// <summary>Writes options of a page as a struct that stays in place as long as the pins.</summary>
        internal static hrbfnpr_page_desc* Describe(PageOptions options, PageFormat? format, Pins pins)
        {
            var page = (hrbfnpr_page_desc*)pins.Pin(new hrbfnpr_page_desc[1]);
            options.Write(page, pins);
            page->format = (uint)(format ?? options.Format);
            return page;
        }
    }
}
