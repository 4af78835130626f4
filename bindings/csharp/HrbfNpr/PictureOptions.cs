// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Globalization;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>
    /// A field to change after everything was chosen; see <see cref="PictureOptions.Set(string, string)"/>.
    /// </summary>
    public sealed class Change
    {
        /// <summary>Creates a change of a field.</summary>
        /// <param name="field">The path of the field, as in <see cref="Field"/>.</param>
        /// <param name="value">The new value, as in <see cref="Value"/>.</param>
        public Change(string field, string value)
        {
            Field = field ?? throw new ArgumentNullException(nameof(field));
            Value = value ?? throw new ArgumentNullException(nameof(value));
        }

        /// <summary>Path of the field, such as "style.halo_width".</summary>
        public string Field { get; }

        /// <summary>
        /// New value: a number, several numbers with commas between, a colour as #rrggbb or #rrggbbaa, or the name of a
        /// constant, such as "blue-noise".
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
    /// A dab of a brush: a ball on the surface in which the painted map moves towards a value.  Dabs act one after the
    /// other.
    /// </summary>
    public sealed class Dab
    {
        /// <summary>What the dab paints; default Tone.</summary>
        public DabMap Map { get; set; }

        /// <summary>Middle of the ball, in coordinates of the source.</summary>
        public Vector3d Position { get; set; }

        /// <summary>Unit normal of the surface there.  Surface that faces away from it is not painted.</summary>
        public Vector3d Normal { get; set; }

        /// <summary>Radius of the ball, in units of the source; above 0.</summary>
        public double Radius { get; set; }

        /// <summary>Strength in the middle; 0 to 1; default 1.  It falls to 0 at the radius.</summary>
        public double Strength { get; set; } = 1;

        /// <summary>Value of Tone and Density; 0 to 1; default 0.</summary>
        public double Value { get; set; }

        /// <summary>Direction that hatching follows, with <see cref="DabMap.Direction"/>.</summary>
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

    /// <summary>How a picture is made.  A new one makes a good picture of any source.</summary>
    /// <remarks>
    /// The picture chooses values for null, 0 or NaN, as the text of a property says.  Options are plain data: they may
    /// be changed and used again.
    /// </remarks>
    /// <example>
    /// <code>
    /// var options = new PictureOptions { Preset = Preset.Etching, Width = 800, Height = 600, Azimuth = 45 };
    /// options.Set("style.hatch.ink", "#202040").Set("style.halo_width", 2);
    /// </code>
    /// </example>
    public sealed class PictureOptions
    {
        // ---- Style

        /// <summary>Named style; default ContourAndStipple.</summary>
        public Preset Preset { get; set; } = Preset.ContourAndStipple;

        /// <summary>
        /// Name of a preset, such as "engraving", in place of <see cref="Preset"/>; default null = <see cref="Preset"/>
        /// is used.
        /// </summary>
        public string StyleName { get; set; }

        /// <summary>
        /// A style to use as it is, with lengths in pixels of this picture; default null = the preset, scaled by the
        /// pen.  <see cref="Preset"/> then says which layers of marks there are.
        /// </summary>
        public Style Style { get; set; }

        /// <summary>Settings for what these options leave at their defaults; default null = none.</summary>
        public Settings Settings { get; set; }

        /// <summary>Fields to change after everything was chosen, in this order; default empty.</summary>
        public IList<Change> Changes { get; } = new List<Change>();

        /// <summary>Dabs that paint the surface; default empty.</summary>
        public IList<Dab> Dabs { get; } = new List<Dab>();

        /// <summary>How notes and errors write options; default Fields.</summary>
        public Wording Wording { get; set; }

        // ---- Size, in pixels

        /// <summary>
        /// Width of the drawing, in pixels, given with <see cref="Height"/>; 1 to 32768; default 0 = from
        /// <see cref="Size"/>.
        /// </summary>
        public int Width { get; set; }

        /// <summary>
        /// Height of the drawing, in pixels, given with <see cref="Width"/>; 1 to 32768; default 0 = from
        /// <see cref="Size"/>.
        /// </summary>
        public int Height { get; set; }

        /// <summary>
        /// Longer side of the drawing, in pixels; 1 to 32768; default 0 = 1600.  The shorter side is as the object
        /// needs it.
        /// </summary>
        public int Size { get; set; }

        /// <summary>Sides on which marks are drawn; default Auto.</summary>
        public PictureSides Sides { get; set; }

        /// <summary>
        /// Radius of the pen, in pixels, which styles vary a little; 1e-6 to 1e6; default 0 = an 800th of the longer
        /// side, at least 0.75.
        /// </summary>
        public double Pen { get; set; }

        /// <summary>
        /// Width of contours, in pixels; 1e-6 to 1e6; default 0 = that of the style.  Other lines are finer.
        /// </summary>
        public double LineWidth { get; set; }

        // ---- Camera

        /// <summary>A camera to use as it is, with its viewport as the size; default null = one is chosen.</summary>
        public Camera Camera { get; set; }

        /// <summary>
        /// Direction that is up; default null = by the format and the shape, or y where neither tells.
        /// </summary>
        public Vector3d? Up { get; set; }

        /// <summary>
        /// Azimuth of the camera about the up axis, from the front to the right, in degrees; default null = 30, and
        /// another where that sees the back of an open surface.
        /// </summary>
        public double? Azimuth { get; set; }

        /// <summary>Elevation of the camera above the horizon, in degrees; default null = 20.</summary>
        public double? Elevation { get; set; }

        /// <summary>
        /// Direction from the eye into the scene, in place of azimuth and elevation; default null = not given.
        /// </summary>
        public Vector3d? Direction { get; set; }

        /// <summary>Place of the eye, which looks at <see cref="Target"/>; default null = not given.</summary>
        public Vector3d? Eye { get; set; }

        /// <summary>Place that the eye looks at; default null = the middle of the model.</summary>
        public Vector3d? Target { get; set; }

        /// <summary>
        /// Vertical angle of view, in degrees; 0.01 to 179; 0 = orthographic; default null = 30, or 0 in the style
        /// Archaeological.
        /// </summary>
        public double? Fov { get; set; }

        /// <summary>Share of the picture that is free on each side; 0 to 0.45; default null = 0.05.</summary>
        public double? Margin { get; set; }

        /// <summary>
        /// Angle of an orbit that starts here, in degrees; default 0 = a still picture.  The picture has room for all
        /// of the orbit.
        /// </summary>
        public double Turn { get; set; }

        /// <summary>Number of frames of that orbit; 1 to 1000000; default 36.</summary>
        public int TurnFrames { get; set; } = 36;

        // ---- From the source to a surface

        /// <summary>How far the normals of points can be trusted; default Auto.</summary>
        public Normals Normals { get; set; } = Normals.Auto;

        /// <summary>
        /// Number of samples of a mesh, or chosen from points; 0 to 1e9; default 0 = as many as a mesh needs, and of
        /// points all up to 4096.
        /// </summary>
        public long Samples { get; set; }

        /// <summary>
        /// Samples are chosen until the surface is this near to the mesh, or to all points, in units of the source; 0
        /// or more; default 0 = 0.002 diagonals for a mesh, and no such end for points.
        /// </summary>
        public double Tolerance { get; set; }

        /// <summary>
        /// Largest number of samples that are chosen; 0 or more; default 0 = 8000 for a mesh, and no limit for points.
        /// </summary>
        public long MaximumCentres { get; set; }

        /// <summary>Components of a mesh that are kept; default Auto.</summary>
        public MeshParts Parts { get; set; } = MeshParts.Auto;

        /// <summary>Edges of a mesh that are sharp; default AsGiven.</summary>
        public PictureEdges Edges { get; set; }

        /// <summary>
        /// Angle between the normals of two faces, in degrees, above which their edge is sharp, with
        /// <see cref="PictureEdges.Sharp"/>; 5 to 175; default 30.
        /// </summary>
        public double EdgeAngle { get; set; } = 30;

        /// <summary>
        /// Angle between the normals of two faces, in degrees, above which they do not share corner normals; 0 to 180;
        /// default null = 60.
        /// </summary>
        public double? CreaseAngle { get; set; }

        /// <summary>
        /// How often faces are divided into four towards a round surface; 0 to 6; default -1 = where faces are coarse
        /// and no edges stand out.
        /// </summary>
        public int Subdivide { get; set; } = -1;

        /// <summary>Whether an upright section is drawn beside the drawing; default Auto.</summary>
        public Profile Profile { get; set; }

        /// <summary>
        /// Place where the scanner stood, to which open surfaces without normals look; default null = as the source
        /// says.
        /// </summary>
        public Vector3d? Viewpoint { get; set; }

        /// <summary>
        /// Factor of the width over which the image of a depth camera is smoothed; 0 to 100; default null = 1; 0 leaves
        /// its points where they are.
        /// </summary>
        public double? DepthSmoothing { get; set; }

        /// <summary>Seed of all random numbers; any number; default 1.</summary>
        public ulong RandomSeed { get; set; } = 1;

        // ---- Marks, lines, and what stands beside the drawing

        /// <summary>
        /// Kinds of layers of marks with commas between, such as "stipples,hatch"; default null = those of the style.
        /// </summary>
        public string MarkKinds { get; set; }

        /// <summary>
        /// n points where marks of <see cref="Distribution.Published"/> start; float or double; default not given =
        /// chosen.
        /// </summary>
        public ArrayView SeedPoints { get; set; }

        /// <summary>Angle by which all lines of hatching are turned, in degrees; -360 to 360; default 0.</summary>
        public double HatchAngle { get; set; }

        /// <summary>
        /// Whether the picture has a ground, on which only the object's shadow is drawn, and where; default None.
        /// </summary>
        public PictureGround Ground { get; set; }

        /// <summary>
        /// Height of the ground with <see cref="PictureGround.Height"/>, along the up direction, in units of the source;
        /// default 0.
        /// </summary>
        public double GroundHeight { get; set; }

        /// <summary>Kinds of lines with commas between; "none" = no lines; default null = those of the style.</summary>
        /// <remarks>
        /// The kinds are contour, suggestive, ridges, valleys, apparent, parabolic, isophotes=0.3:0.6, section=z:20,
        /// border and crease.  With "none", contours are drawn by marks with Visibility.Published only.
        /// </remarks>
        public string Lines { get; set; }

        /// <summary>
        /// Unit of a scale bar below the drawing; "none" = no bar; default null = "units" in the style Archaeological,
        /// else "none".
        /// </summary>
        public string ScaleBar { get; set; }

        // ---- Switches

        /// <summary>Whether to allow a drawing in which hardly anything can be seen; default false.</summary>
        public bool AllowBlank { get; set; }

        /// <summary>Whether to turn all normals, whatever they look like; default false.</summary>
        public bool Flip { get; set; }

        /// <summary>Whether the surface goes on beyond open data, as the fit has it; default false.</summary>
        public bool Close { get; set; }

        /// <summary>Whether to fit an open mesh as one surface, even where its parts cross; default false.</summary>
        public bool Together { get; set; }

        /// <summary>Whether the paper is transparent; default false.</summary>
        public bool Transparent { get; set; }

        /// <summary>
        /// Whether all layers get all their marks, even if the style draws lines only, and even those that the planned
        /// camera does not need; for marks that are saved, or drawn by a <see cref="Renderer"/>; default false.
        /// </summary>
        public bool KeepMarks { get; set; }

        /// <summary>
        /// Whether to make the model only: choose no camera, place no marks, find no lines; default false.
        /// </summary>
        public bool SurfaceOnly { get; set; }

        /// <summary>Whether the source is a part of a solid, so that up is y; default false.</summary>
        public bool IsSolid { get; set; }

        /// <summary>
        /// Whether rays are compared with all lines, so that wrong parts are repaired; a note has the counts; default
        /// false.
        /// </summary>
        public bool Verify { get; set; }

        /// <summary>
        /// Receives events while the picture is made, and later while it is drawn or written, on the thread that made
        /// the call; default null.  If it throws, the call is cancelled and throws a <see cref="CallbackException"/>.
        /// </summary>
        public Action<PictureEvent> OnEvent { get; set; }

        /// <summary>Changes one field after everything was chosen.</summary>
        /// <remarks>
        /// <c>style.F</c> is a field of the style; <c>style.ink</c> is the ink of all layers, lines and contours.
        /// <c>style.KIND.F</c> is a field of one kind of layers, such as <c>style.hatch.ink</c>, and
        /// <c>style.layers.F</c> of all layers.  <c>style.LINE.F</c> is a field of one kind of lines, such as
        /// <c>style.ridge.width</c>, and <c>style.lines.F</c> of all lines.  <c>fit.F</c>, <c>mesh_fit.F</c> and
        /// <c>line_set.F</c> are fields of these options.  <c>marks.F</c> is a field of <see cref="GenerateOptions"/>,
        /// <c>marks.KIND.F</c> of one kind of its layers, and <c>marks.layers.F</c> of all of them.  F is a property's
        /// name in small letters with underscores, such as <c>halo_width</c>.  Lengths in pixels are those of this
        /// picture: they are not scaled by the pen.
        /// </remarks>
        /// <param name="field">The path of the field; see the remarks.</param>
        /// <param name="value">The new value, as in <see cref="Change.Value"/>.</param>
        /// <returns>These options.</returns>
        public PictureOptions Set(string field, string value)
        {
            Changes.Add(new Change(field, value));
            return this;
        }

        /// <summary>Changes one field that is a number.</summary>
        /// <param name="field">The path of the field, as in the other <c>Set</c>.</param>
        /// <param name="value">The number.</param>
        /// <returns>These options.</returns>
        public PictureOptions Set(string field, double value)
        {
            return Set(field, value.ToString("R", CultureInfo.InvariantCulture));
        }

        internal unsafe void Write(ref hrbfnpr_picture_desc desc, Pins pins)
        {
            desc.flags = (AllowBlank ? 1u : 0) | (Flip ? 2u : 0) | (Close ? 4u : 0) | (Together ? 8u : 0)
                | (Transparent ? 16u : 0) | (KeepMarks ? 32u : 0) | (SurfaceOnly ? 64u : 0) | (IsSolid ? 128u : 0)
                | (Verify ? 256u : 0);
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
            desc.ground = (uint)Ground;
            desc.ground_height = GroundHeight;
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

    /// <summary>The descriptor of one call that makes a picture, and everything that it points to.</summary>
    internal sealed unsafe class PictureCall : IDisposable
    {
        internal hrbfnpr_picture_desc Desc;
        private readonly Pins pins = new Pins();
        private readonly HeldHandles held = new HeldHandles();
        private readonly Memory memory = new Memory();
        private readonly List<UserHandle> users = new List<UserHandle>();

        /// <param name="sources">The sources; null if a picture is restyled.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="origins">The models and marks that the sources are made of.</param>
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

        /// <summary>The functions that the picture runs.</summary>
        internal PictureState State { get; }

        /// <summary>Gives a new picture everything that its native part goes on using.</summary>
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
            // Weak, because a picture keeps its states alive, and a state may refer to its picture.
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

        /// <summary>Writes the style, and returns the state of its tone function; null if it has none.</summary>
        private ToneState DescribeStyle(Style style)
        {
            if (style == null)
            {
                return null;
            }
            if (style.ToneFunction == null && style.NativeTone != null)
            {
                throw new InvalidArgumentException("Style comes from a painted picture; set Dabs instead of Style");
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
