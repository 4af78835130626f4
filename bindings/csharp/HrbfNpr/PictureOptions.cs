// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Globalization;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// One field that is changed on top of all that was chosen; see <see cref="PictureOptions.Set(string, string)"/>.
    /// </summary>
    public sealed class Change
    {
        /// <summary>A field and its value.</summary>
        /// <param name="field">As <see cref="Field"/>.</param>
        /// <param name="value">As <see cref="Value"/>.</param>
        public Change(string field, string value)
        {
            Field = field ?? throw new ArgumentNullException(nameof(field));
            Value = value ?? throw new ArgumentNullException(nameof(value));
        }

        /// <summary>The path of a field, such as "style.halo_width".</summary>
        public string Field { get; }

        /// <summary>
        /// A number, several with commas between, #rrggbb or #rrggbbaa of a colour, or the name of a constant, such as
        /// "blue-noise".
        /// </summary>
        public string Value { get; }

        internal unsafe void Write(hrbfnpr_change* change, Pins pins)
        {
            Errors.Check(NativeMethods.hrbfnpr_change_init(change, (uint)sizeof(hrbfnpr_change)));
            change->field = pins.Text(Field);
            change->value = pins.Text(Value);
        }
    }

    /// <summary>
    /// A stroke of a brush on the surface: within its radius tone, density or direction go towards a value.
    /// </summary>
    public sealed class Dab
    {
        /// <summary>What is painted; Tone by default.</summary>
        public DabMap Map { get; set; }

        /// <summary>The middle, on the surface.</summary>
        public Vector3d Position { get; set; }

        /// <summary>Unit: what faces away from it is not painted.</summary>
        public Vector3d Normal { get; set; }

        /// <summary>In the unit of the model, above 0.</summary>
        public double Radius { get; set; }

        /// <summary>In the middle, 0 to 1; it falls to 0 at the radius; 1.</summary>
        public double Strength { get; set; } = 1;

        /// <summary>What Tone and Density go towards, 0 to 1; 0.</summary>
        public double Value { get; set; }

        /// <summary>What the map Direction turns hatching towards.</summary>
        public Vector3d Direction { get; set; }

        internal unsafe void Write(hrbfnpr_dab* dab)
        {
            Errors.Check(NativeMethods.hrbfnpr_dab_init(dab, (uint)sizeof(hrbfnpr_dab)));
            dab->map = (uint)Map;
            *(Vector3d*)dab->position = Position;
            *(Vector3d*)dab->normal = Normal;
            dab->radius = Radius;
            dab->strength = Strength;
            dab->value = Value;
            *(Vector3d*)dab->direction = Direction;
        }
    }

    /// <summary>
    /// How a picture is made and drawn.  A new one makes a good picture of any source; null, 0 or NaN stands for what
    /// the library chooses, where a line says so.  Plain data: it may be changed and used again.
    /// </summary>
    /// <example>
    /// <code>
    /// var options = new PictureOptions { Preset = Preset.Etching, Width = 800, Height = 600, Azimuth = 45 };
    /// options.Set("style.hatch.ink", "#202040").Set("style.halo_width", 2);
    /// </code>
    /// </example>
    public sealed class PictureOptions
    {
        // ---- Style

        /// <summary>The style; ContourAndStipple.</summary>
        public Preset Preset { get; set; } = Preset.ContourAndStipple;

        /// <summary>
        /// The name of a preset, such as "engraving", in place of <see cref="Preset"/>; null = that one.
        /// </summary>
        public string StyleName { get; set; }

        /// <summary>
        /// A style that is used as it is, with lengths in pixels of this picture; null = that of the preset, scaled by
        /// the pen.  <see cref="Preset"/> then says which layers of marks there are.
        /// </summary>
        public Style Style { get; set; }

        /// <summary>What these options leave at their defaults; null = nothing.</summary>
        public Settings Settings { get; set; }

        /// <summary>Fields that are changed on top of all that was chosen, in this order.</summary>
        public IList<Change> Changes { get; } = new List<Change>();

        /// <summary>What is painted on the surface.</summary>
        public IList<Dab> Dabs { get; } = new List<Dab>();

        /// <summary>How notes and errors name options; Fields.</summary>
        public Wording Wording { get; set; }

        // ---- Size, in pixels

        /// <summary>Pixels, 1 to 32768, with <see cref="Height"/>; 0 = from <see cref="Size"/>.</summary>
        public int Width { get; set; }

        /// <summary>Pixels, 1 to 32768, with <see cref="Width"/>; 0 = from <see cref="Size"/>.</summary>
        public int Height { get; set; }

        /// <summary>
        /// Pixels of the longer side, 1 to 32768; the shorter one is as the object needs it; 0 = 1600.
        /// </summary>
        public int Size { get; set; }

        /// <summary>Which sides of the surfaces marks are drawn on; Auto.</summary>
        public PictureSides Sides { get; set; }

        /// <summary>
        /// Radius of the pen, which styles vary a little, pixels; 0 = an 800th of the longer side, at least 0.75.
        /// </summary>
        public double Pen { get; set; }

        /// <summary>Width of contours, pixels; other lines are finer; 0 = that of the style.</summary>
        public double LineWidth { get; set; }

        // ---- Camera

        /// <summary>A camera that is used as it is, with its viewport as size; null = one is chosen.</summary>
        public Camera Camera { get; set; }

        /// <summary>Which way is up; null = by the format and the shape, y where neither tells.</summary>
        public Vector3d? Up { get; set; }

        /// <summary>
        /// Degrees, of the camera about the up axis; null = 30, and another where that sees the back of an open
        /// surface.
        /// </summary>
        public double? Azimuth { get; set; }

        /// <summary>Degrees, of the camera above the horizon; null = 20.</summary>
        public double? Elevation { get; set; }

        /// <summary>From the eye into the scene, in place of azimuth and elevation; null = by these.</summary>
        public Vector3d? Direction { get; set; }

        /// <summary>Place of the eye, which looks at <see cref="Target"/>; null = where it sees all.</summary>
        public Vector3d? Eye { get; set; }

        /// <summary>What an eye looks at; null = the middle of the model.</summary>
        public Vector3d? Target { get; set; }

        /// <summary>
        /// Vertical angle of view, degrees, 0 to 179, 0 = orthographic; null = 30, 0 of the style Archaeological.
        /// </summary>
        public double? Fov { get; set; }

        /// <summary>Share that is free on each side, 0 to 0.45; null = 0.05.</summary>
        public double? Margin { get; set; }

        /// <summary>
        /// Degrees of an orbit that starts here: the picture has room for all of it; 0 = a still (default).
        /// </summary>
        public double Turn { get; set; }

        /// <summary>Drawings of that orbit, 1 and more; 36.</summary>
        public int TurnFrames { get; set; } = 36;

        // ---- From the source to a surface

        /// <summary>What is known of the normals of points; Auto.</summary>
        public Normals Normals { get; set; } = Normals.Auto;

        /// <summary>
        /// Samples of a mesh, or chosen from points; 0 = as many as a mesh needs, of points all up to 4096.
        /// </summary>
        public long Samples { get; set; }

        /// <summary>
        /// Samples are chosen until all is this near, in the unit of the source; 0 = 0.002 diagonals of a mesh, no such
        /// end of points.
        /// </summary>
        public double Tolerance { get; set; }

        /// <summary>The most samples that are chosen; 0 = 8000 of a mesh, no limit of points.</summary>
        public long MaximumCentres { get; set; }

        /// <summary>Which components of a mesh are kept; Outer.</summary>
        public MeshParts Parts { get; set; }

        /// <summary>Which edges of a mesh stay sharp; AsGiven.</summary>
        public PictureEdges Edges { get; set; }

        /// <summary>The angle of <see cref="PictureEdges.Sharp"/>, degrees, 5 to 175; 30.</summary>
        public double EdgeAngle { get; set; } = 30;

        /// <summary>
        /// Degrees, 0 to 180: faces that meet at a sharper angle do not share their normals; null = 60.
        /// </summary>
        public double? CreaseAngle { get; set; }

        /// <summary>
        /// How often faces are divided into four towards something round, 0 to 6; -1 = where they are coarse and no
        /// edges stand out (default).
        /// </summary>
        public int Subdivide { get; set; } = -1;

        /// <summary>Whether an upright section stands beside the drawing; Auto.</summary>
        public Profile Profile { get; set; }

        /// <summary>
        /// Where the scanner stood: open surfaces without normals look to it; null = as the source tells.
        /// </summary>
        public Vector3d? Viewpoint { get; set; }

        /// <summary>
        /// Factor of the width over which the image of a depth camera is smoothed, 0 to 1000; 0 leaves its points where
        /// they are; null = 1.
        /// </summary>
        public double? DepthSmoothing { get; set; }

        /// <summary>Seed of all that is random, any number; 1.</summary>
        public ulong RandomSeed { get; set; } = 1;

        // ---- Marks, lines, and what stands beside the drawing

        /// <summary>
        /// Kinds of layers with commas between, such as "stipples,hatch"; null = those of the style.
        /// </summary>
        public string MarkKinds { get; set; }

        /// <summary>n points where marks of <see cref="Distribution.Published"/> start; not given by default.</summary>
        public ArrayView SeedPoints { get; set; }

        /// <summary>Degrees by which all lines of hatching are turned, -360 to 360; 0.</summary>
        public double HatchAngle { get; set; }

        /// <summary>
        /// Kinds of lines with commas between: contour, suggestive, ridges, valleys, apparent, parabolic,
        /// isophotes=0.3:0.6, section=z:20, border, crease; "none": contours by marks; null = those of the style.
        /// </summary>
        public string Lines { get; set; }

        /// <summary>
        /// The unit of a scale bar below the drawing; "none" = no bar; null = "units" of the style Archaeological, else
        /// "none".
        /// </summary>
        public string ScaleBar { get; set; }

        // ---- What is left in, and what is left out

        /// <summary>Whether drawing what can hardly be seen is no error; no by default.</summary>
        public bool AllowBlank { get; set; }

        /// <summary>Whether all normals are turned, whatever they look like; no by default.</summary>
        public bool Flip { get; set; }

        /// <summary>
        /// Whether the surface goes on beyond open data, as the fit has it; no by default: it ends there.
        /// </summary>
        public bool Close { get; set; }

        /// <summary>Whether an open mesh is one surface also where its parts cross; no by default.</summary>
        public bool Together { get; set; }

        /// <summary>Whether the paper lets all through; no by default.</summary>
        public bool Transparent { get; set; }

        /// <summary>
        /// Whether layers have all their marks also where the style draws lines alone, for marks that are saved; no by
        /// default.
        /// </summary>
        public bool KeepMarks { get; set; }

        /// <summary>
        /// Whether only the surface is made: no camera is chosen, no marks are placed, no lines are looked for; no by
        /// default.
        /// </summary>
        public bool SurfaceOnly { get; set; }

        /// <summary>
        /// Whether the source is a part of a solid: then nothing is said of it, and no up is looked for; no by default.
        /// </summary>
        public bool IsSolid { get; set; }

        /// <summary>
        /// Called with what happens while the picture is made, and later when it is drawn or written, on the thread
        /// that made the call.  What it throws cancels the call and comes out in a <see cref="CallbackException"/>.
        /// null = none.
        /// </summary>
        public Action<PictureEvent> OnEvent { get; set; }

        /// <summary>Changes one field on top of all that was chosen.</summary>
        /// <param name="field">
        /// The path of a field: style.F of the style (style.ink is that of all layers, lines and contours);
        /// style.KIND.F of a kind of layers, such as style.hatch.ink; style.layers.F of all layers; style.LINE.F of a
        /// kind of lines, such as style.ridge.width; style.lines.F of all lines; fit.F; mesh_fit.F; marks.F;
        /// marks.KIND.F of a kind of layers of marks; marks.layers.F of all of them; line_set.F.  F is a field of the
        /// library's struct: a property's name in small letters with underscores, such as halo_width. Lengths in pixels
        /// are those of this picture: they are not scaled by the pen.
        /// </param>
        /// <param name="value">As <see cref="Change.Value"/>.</param>
        /// <returns>These options.</returns>
        public PictureOptions Set(string field, string value)
        {
            Changes.Add(new Change(field, value));
            return this;
        }

        /// <summary>Changes one field that is a number.</summary>
        /// <param name="field">As of the other <c>Set</c>.</param>
        /// <param name="value">The number.</param>
        /// <returns>These options.</returns>
        public PictureOptions Set(string field, double value)
        {
            return Set(field, value.ToString("R", CultureInfo.InvariantCulture));
        }

        internal unsafe void Write(ref hrbfnpr_picture_desc desc, Pins pins)
        {
            desc.flags = (AllowBlank ? 1u : 0) | (Flip ? 2u : 0) | (Close ? 4u : 0) | (Together ? 8u : 0)
                | (Transparent ? 16u : 0) | (KeepMarks ? 32u : 0) | (SurfaceOnly ? 64u : 0) | (IsSolid ? 128u : 0);
            desc.preset = unchecked((uint)Preset);
            desc.wording = (uint)Wording;
            desc.style_name = pins.Text(StyleName);
            desc.width = Width;
            desc.height = Height;
            desc.size = Size;
            desc.sides = (uint)Sides;
            desc.pen = Pen;
            desc.line_width = LineWidth;
            desc.azimuth = Azimuth ?? double.NaN;
            desc.elevation = Elevation ?? double.NaN;
            desc.fov = Fov ?? double.NaN;
            desc.margin = Margin ?? double.NaN;
            desc.turn = Turn;
            desc.turn_frames = TurnFrames;
            desc.normals = (uint)Normals;
            desc.samples = Samples;
            desc.tolerance = Tolerance;
            desc.maximum_centres = MaximumCentres;
            desc.parts = (uint)Parts;
            desc.edges = (uint)Edges;
            desc.edge_angle = EdgeAngle;
            desc.crease_angle = CreaseAngle ?? double.NaN;
            desc.subdivide = Subdivide;
            desc.profile = (uint)Profile;
            desc.depth_smoothing = DepthSmoothing ?? double.NaN;
            desc.random_seed = RandomSeed;
            desc.mark_kinds = pins.Text(MarkKinds);
            desc.seed_points = SeedPoints.ToNative(pins, 3, nameof(SeedPoints));
            desc.hatch_angle = HatchAngle;
            desc.lines = pins.Text(Lines);
            desc.scale_bar = pins.Text(ScaleBar);
            var nothing = new Vector3d(double.NaN, double.NaN, double.NaN);
            fixed (hrbfnpr_picture_desc* to = &desc)
            {
                *(Vector3d*)to->up = Up.GetValueOrDefault();
                *(Vector3d*)to->direction = Direction.GetValueOrDefault();
                *(Vector3d*)to->eye = Eye ?? nothing;
                *(Vector3d*)to->target = Target ?? nothing;
                *(Vector3d*)to->viewpoint = Viewpoint ?? nothing;
            }
        }
    }

    /// <summary>The descriptor of one call that makes a picture, and all that it points to.</summary>
    internal sealed unsafe class PictureCall : IDisposable
    {
        internal hrbfnpr_picture_desc Desc;
        private readonly Pins pins = new Pins();
        private readonly HeldHandles held = new HeldHandles();
        private readonly Memory memory = new Memory();
        private readonly List<UserHandle> users = new List<UserHandle>();

        /// <param name="sources">null of a picture that is restyled.</param>
        /// <param name="options">All defaults if null.</param>
        /// <param name="origins">What the sources are made with.</param>
        internal PictureCall(
            IReadOnlyList<PictureSource> sources, PictureOptions options, PictureOrigins origins)
        {
            options = options ?? new PictureOptions();
            try
            {
                fixed (hrbfnpr_picture_desc* desc = &Desc)
                {
                    Errors.Check(
                        NativeMethods.hrbfnpr_picture_desc_init(desc, (uint)sizeof(hrbfnpr_picture_desc)));
                }
                options.Write(ref Desc, pins);
                DescribeSources(sources);
                DescribeChanges(options.Changes);
                DescribeDabs(options.Dabs);
                if (options.Settings != null)
                {
                    Desc.settings = held.Hold(options.Settings.Handle);
                }
                if (options.Camera != null)
                {
                    Desc.camera = pins.Pin(new[] { options.Camera.Native });
                }
                State = new PictureState(options.OnEvent, DescribeStyle(options.Style), origins.Functions);
                Desc.on_event = PictureState.Function;
                Desc.event_user = Add(State);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>What the picture calls.</summary>
        internal PictureState State { get; }

        /// <summary>The picture is made: it takes over what its native part goes on using.</summary>
        internal void GiveTo(PictureHandle made, PictureOrigins origins)
        {
            made.Keep(origins.Anchors, users);
            users.Clear();
        }

        public void Dispose()
        {
            pins.Dispose();
            held.Dispose();
            memory.Dispose();
            foreach (UserHandle user in users)
            {
                user.Dispose();
            }
            users.Clear();
        }

        private IntPtr Add(CallbackState state)
        {
            // Weak: a picture keeps its states alive, and a state may refer to its picture.
            users.Add(new UserHandle(state, GCHandleType.Weak));
            return users[users.Count - 1].Pointer;
        }

        private void DescribeSources(IReadOnlyList<PictureSource> sources)
        {
            if (sources == null)
            {
                return;
            }
            var structs = new hrbfnpr_picture_source[sources.Count];
            var first = (hrbfnpr_picture_source*)pins.Pin(structs);
            for (int i = 0; i < structs.Length; ++i)
            {
                sources[i].Write(first + i, pins, held);
            }
            Desc.sources = structs.Length == 0 ? IntPtr.Zero : (IntPtr)first;
            Desc.source_count = structs.Length;
        }

        private void DescribeChanges(IList<Change> changes)
        {
            if (changes.Count == 0)
            {
                return;
            }
            var structs = new hrbfnpr_change[changes.Count];
            var first = (hrbfnpr_change*)pins.Pin(structs);
            for (int i = 0; i < structs.Length; ++i)
            {
                Change change = changes[i] ?? throw new ArgumentNullException(nameof(PictureOptions.Changes));
                change.Write(first + i, pins);
            }
            Desc.changes = (IntPtr)first;
            Desc.change_count = structs.Length;
        }

        private void DescribeDabs(IList<Dab> dabs)
        {
            if (dabs.Count == 0)
            {
                return;
            }
            var structs = new hrbfnpr_dab[dabs.Count];
            var first = (hrbfnpr_dab*)pins.Pin(structs);
            for (int i = 0; i < structs.Length; ++i)
            {
                Dab dab = dabs[i] ?? throw new ArgumentNullException(nameof(PictureOptions.Dabs));
                dab.Write(first + i);
            }
            Desc.dabs = (IntPtr)first;
            Desc.dab_count = structs.Length;
        }

        /// <summary>The state of the style's tone function; null without.</summary>
        private ToneState DescribeStyle(Style style)
        {
            if (style == null)
            {
                return null;
            }
            if (style.ToneFunction == null && style.NativeTone != null)
            {
                throw new InvalidArgumentException("Style is that of a painted picture: give its Dabs instead");
            }
            memory.Begin(StyleMemory.Size(style));
            hrbfnpr_style* native = StyleMemory.Write(style, memory);
            Desc.style = (IntPtr)native;
            if (style.ToneFunction == null)
            {
                return null;
            }
            var tone = new ToneState(style.ToneFunction);
            native->tone_function = ToneState.Function;
            native->tone_user = Add(tone);
            return tone;
        }
    }
}
