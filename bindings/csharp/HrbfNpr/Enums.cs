// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>The status with which a call of the library ends.  The numbers never change.</summary>
    [NativeConstants("HRBFNPR_STATUS_")]
    public enum Status
    {
        /// <summary>Success.</summary>
        Ok = 0,
        /// <summary>An argument is wrong: the message names it and says what to do.</summary>
        InvalidArgument = -1,
        /// <summary>The allocator returned no memory.</summary>
        OutOfMemory = -2,
        /// <summary>A destination is too small; only the needed size was written.</summary>
        BufferTooSmall = -3,
        /// <summary>The library is older than this assembly and does not know a field that was set.</summary>
        UnsupportedStruct = -4,
        /// <summary>The linear system of the fit has no numerically unique solution.</summary>
        SingularSystem = -5,
        /// <summary>An iteration ended before it reached its goal.</summary>
        NotConverged = -6,
        /// <summary>The call was cancelled.</summary>
        Cancelled = -7,
        /// <summary>A stream failed.</summary>
        Io = -8,
        /// <summary>The data has another format, or is truncated or damaged.</summary>
        CorruptData = -9,
        /// <summary>
        /// A newer library wrote the data, or the library has another ABI version than this assembly.
        /// </summary>
        VersionMismatch = -10,
        /// <summary>A function of the program failed or gave invalid results.</summary>
        Callback = -11,
        /// <summary>A bug in the library: please report it.</summary>
        Internal = -99,
    }

    /// <summary>The type of the numbers in an array.</summary>
    [NativeConstants("HRBFNPR_SCALAR_")]
    public enum ScalarType
    {
        /// <summary><see cref="float"/>.</summary>
        Float32 = 1,
        /// <summary><see cref="double"/>.</summary>
        Float64 = 2,
        /// <summary><see cref="byte"/>.</summary>
        Uint8 = 3,
        /// <summary><see cref="uint"/>.</summary>
        Uint32 = 4,
        /// <summary><see cref="int"/>.</summary>
        Int32 = 5,
        /// <summary><see cref="long"/>.</summary>
        Int64 = 6,
    }

    /// <summary>
    /// The format of an image's pixels.  The name gives the order of the channels in memory; colours are sRGB-encoded.
    /// </summary>
    [NativeConstants("HRBFNPR_FORMAT_")]
    public enum PixelFormat
    {
        /// <summary>Straight RGBA, 4 bytes (default).</summary>
        Rgba8 = 1,
        /// <summary>Straight BGRA, 4 bytes.</summary>
        Bgra8 = 2,
        /// <summary>RGBA with colours multiplied by alpha, 4 bytes.</summary>
        Rgba8Premultiplied = 3,
        /// <summary>BGRA with colours multiplied by alpha, 4 bytes.</summary>
        Bgra8Premultiplied = 4,
        /// <summary>Straight RGBA, 4 floats from 0 to 1, aligned to 4 bytes.</summary>
        Rgba32f = 5,
        /// <summary>RGBA with colours multiplied by alpha, 4 floats from 0 to 1, aligned to 4 bytes.</summary>
        Rgba32fPremultiplied = 6,
        /// <summary>One byte: the share of the pixel that ink covers, of any colour.</summary>
        Coverage8 = 7,
    }

    /// <summary>The level of a message in the log.</summary>
    [NativeConstants("HRBFNPR_LOG_")]
    public enum LogLevel
    {
        /// <summary>Details for developers of the library.</summary>
        Debug = 0,
        /// <summary>What a call did, with counts and times.</summary>
        Info = 1,
        /// <summary>The result may not be what the caller expects.</summary>
        Warning = 2,
    }

    /// <summary>Which threads run the library's tasks.  The choice does not change the bits of any result.</summary>
    [NativeConstants("HRBFNPR_THREAD_BACKEND_")]
    public enum ThreadBackend
    {
        /// <summary><see cref="ContextOptions.RunTasks"/> if it is given, else the pool (default).</summary>
        Auto = 0,
        /// <summary>
        /// Threads that the context owns.  A processor that is busy with other work costs little time.
        /// </summary>
        Pool = 1,
        /// <summary>The threads of the OpenMP runtime.  Use them only if no other work needs the processors.</summary>
        Openmp = 2,
        /// <summary>The program's task runner, <see cref="ContextOptions.RunTasks"/>.</summary>
        RunTasks = 3,
        /// <summary>The calling thread alone.</summary>
        Serial = 4,
    }

    /// <summary>Instruction sets of processors.</summary>
    [NativeConstants("HRBFNPR_INSTRUCTION_SET_")]
    public enum InstructionSet
    {
        /// <summary>The best one that both the build and the processor have (default).</summary>
        Auto = 0,
        /// <summary>The one that the library was compiled for.</summary>
        Baseline = 1,
        /// <summary>AVX2 with FMA: x86, 256 bits.</summary>
        Avx2 = 2,
        /// <summary>AVX-512: x86, 512 bits.</summary>
        Avx512 = 3,
        /// <summary>NEON: Arm, 128 bits.</summary>
        Neon = 4,
    }

    /// <summary>Radial functions phi(r) [NPAR 4.1].</summary>
    [NativeConstants("HRBFNPR_KERNEL_")]
    public enum Kernel
    {
        /// <summary>r^3, without a radius (default).</summary>
        Triharmonic = 0,
        /// <summary>exp(-r^2 / (2 radius^2)).</summary>
        Gaussian = 1,
        /// <summary>(1 - r/radius)^4 (4 r/radius + 1) for r &lt; radius, else 0.</summary>
        WendlandC2 = 2,
        /// <summary>Not for fits: reported for a model made from a function.</summary>
        Custom = 3,
        /// <summary>Not for fits: reported for a solid.</summary>
        Csg = 4,
    }

    /// <summary>How the linear system of a fit is solved.</summary>
    [NativeConstants("HRBFNPR_SOLVER_")]
    public enum Solver
    {
        /// <summary>Direct for few samples, Iterative for many (default).</summary>
        Auto = 0,
        /// <summary>Dense factorization: memory grows with N^2, time with N^3.</summary>
        Direct = 1,
        /// <summary>Preconditioned conjugate gradients: memory grows with N.</summary>
        Iterative = 2,
    }

    /// <summary>Why a fit used the solver that it used.</summary>
    [NativeConstants("HRBFNPR_SOLVER_REASON_")]
    public enum SolverReason
    {
        /// <summary>The caller named it.</summary>
        Requested = 0,
        /// <summary>Auto took Direct, which is faster for few samples.</summary>
        Small = 1,
        /// <summary>Auto took Iterative: Direct would need too much memory or time.</summary>
        Large = 2,
        /// <summary>Auto took Direct, because Iterative did not reach its tolerance.</summary>
        NotConverged = 3,
        /// <summary>Auto took Direct, because Iterative needs a definite system.</summary>
        NotDefinite = 4,
    }

    /// <summary>What a fit does with samples that look wrong.  It counts them in any case.</summary>
    [NativeConstants("HRBFNPR_REPAIR_")]
    public enum Repair
    {
        /// <summary>Uses them as they are (default).</summary>
        Keep = 0,
        /// <summary>Leaves them out.</summary>
        Drop = 1,
        /// <summary>Turns their normals round; for flipped normals only.</summary>
        Reorient = 2,
    }

    /// <summary>How far given normals can be trusted.</summary>
    [NativeConstants("HRBFNPR_NORMALS_")]
    public enum Normals
    {
        /// <summary>They are correct and point outward.</summary>
        Given = 0,
        /// <summary>There are none, or they are useless: all are made.</summary>
        None = 1,
        /// <summary>The directions are correct, the signs are not.</summary>
        Unoriented = 2,
        /// <summary>The directions and most signs are correct; some patches are turned.</summary>
        Mixed = 3,
        /// <summary>They are consistent, but all point inward.</summary>
        Inward = 4,
        /// <summary>Find out which of these holds, and repair accordingly.</summary>
        Auto = 5,
    }

    /// <summary>Whether a fitted surface ends where its samples end.</summary>
    [NativeConstants("HRBFNPR_TRIM_")]
    public enum TrimMode
    {
        /// <summary>The surface goes on to the end of the search box.</summary>
        Never = 0,
        /// <summary>An open surface ends where its samples end; a closed surface stays whole (default).</summary>
        Auto = 1,
    }

    /// <summary>The sides of an item's surface on which its marks are drawn.</summary>
    [NativeConstants("HRBFNPR_SIDES_")]
    public enum Sides
    {
        /// <summary>The side that the normals point to (default).  The inside of a solid is never seen.</summary>
        Front = 0,
        /// <summary>Both sides, for a surface that ends, such as a bowl or a leaf.</summary>
        Both = 1,
    }

    /// <summary>How it was decided which side of a surface is outward.</summary>
    [NativeConstants("HRBFNPR_OUTWARD_")]
    public enum OutwardBy
    {
        /// <summary>The surface encloses the other side.</summary>
        Inside = 0,
        /// <summary><see cref="OrientationOptions.Up"/> points to this side.</summary>
        Up = 1,
        /// <summary>The viewpoint is on this side.</summary>
        Viewpoint = 2,
        /// <summary>Most given normals point to this side.</summary>
        AsGiven = 3,
    }

    /// <summary>Where the regularization of a fit comes from.</summary>
    [NativeConstants("HRBFNPR_REGULARIZATION_")]
    public enum RegularizationMode
    {
        /// <summary><see cref="FitOptions.Regularization"/> (default).</summary>
        Given = 0,
        /// <summary>The measured noise of the samples; 0 for samples without noise.</summary>
        Auto = 1,
    }

    /// <summary>What became of a projected point.</summary>
    [NativeConstants("HRBFNPR_PROJECTION_")]
    public enum ProjectionStatus : byte
    {
        /// <summary>The point is on the surface, within the tolerance.</summary>
        Converged = 0,
        /// <summary>The evaluation limit was reached, or no step lowers f^2.</summary>
        NotConverged = 1,
        /// <summary>The point is stuck off the surface, where the gradient vanishes.</summary>
        ZeroGradient = 2,
        /// <summary>f or its gradient is not finite.</summary>
        NotFinite = 3,
    }

    /// <summary>What became of a ray.</summary>
    [NativeConstants("HRBFNPR_RAY_")]
    public enum RayStatus : byte
    {
        /// <summary>The ray has one or several hits.</summary>
        Hit = 0,
        /// <summary>The ray has no hit.</summary>
        Miss = 1,
        /// <summary>
        /// The ray has more hits than <see cref="CastOptions.MaximumHits"/>; reported only if that is 2 or more.
        /// </summary>
        Truncated = 2,
        /// <summary>The search ended at the evaluation limit; earlier hits are kept.</summary>
        EvaluationLimit = 3,
        /// <summary>f or its gradient is not finite; earlier hits are kept.</summary>
        NotFinite = 4,
    }

    /// <summary>The kind of a layer's marks.  Later versions may add kinds: treat an unknown one like Own.</summary>
    [NativeConstants("HRBFNPR_LAYER_KIND_")]
    public enum LayerKind
    {
        /// <summary>Layers of every kind; for styles only.</summary>
        Any = 0,
        /// <summary>Scattered marks.</summary>
        Stipples = 1,
        /// <summary>
        /// Lines along a field of directions.  With <see cref="Distribution.BlueNoise"/> they are evenly spaced and
        /// nested; with <see cref="Distribution.Published"/> they are strokes along the directions and across them
        /// [NPAR 5].
        /// </summary>
        /// <remarks>
        /// Lines of level 0 are the coarsest.  Lines of each further level lie midway between all before [Knoeppel et
        /// al. 2015].
        /// </remarks>
        Hatch = 2,
        /// <summary>Marks or strokes of the program.</summary>
        Own = 3,
    }

    /// <summary>
    /// Kinds of lines.  Kinds marked "once" are found when a line set is made, for each of its
    /// <see cref="LineSetOptions.Lines"/>.  Borders and creases are found then, too, without an element of that list.
    /// All others are found for every drawing, except Shadow and Terminator, which are found with a
    /// <see cref="Shading"/>.
    /// </summary>
    /// <remarks>
    /// The strength says how marked a line is at a place.  It has no unit, because lengths are measured in diagonals of
    /// the model.
    /// </remarks>
    [NativeConstants("HRBFNPR_LINE_KIND_")]
    public enum LineKind
    {
        /// <summary>Occluding contours: the line of sight is tangent to the surface there.</summary>
        Contour = 1,
        /// <summary>
        /// Curves that become contours in a nearby view.  Strength: the derivative of the radial curvature towards the
        /// eye [DeCarlo et al. 2003].  Needs <see cref="LineSetOptions.WithCurvature"/>.
        /// </summary>
        SuggestiveContour = 2,
        /// <summary>
        /// Convex ridges; once.  Strength: the curvature across the ridge minus the absolute value of the one along it
        /// [Ohtake, Belyaev and Seidel 2004].
        /// </summary>
        Ridge = 3,
        /// <summary>Concave valleys; once.  The strength is that of ridges.</summary>
        Valley = 4,
        /// <summary>
        /// Extrema of the view-dependent curvature, which is also the strength [Judd, Durand and Adelson 2007].  Needs
        /// <see cref="LineSetOptions.WithCurvature"/>.
        /// </summary>
        ApparentRidge = 5,
        /// <summary>Curves of Gaussian curvature 0; once.</summary>
        Parabolic = 6,
        /// <summary>
        /// Curves on which n . l is one of <see cref="LineStyle.Levels"/>, where n is the normal and l the direction to
        /// the style's light.  Needs <see cref="LineSetOptions.WithCurvature"/>.
        /// </summary>
        Isophote = 7,
        /// <summary>Cuts of the surface by parallel planes; once.</summary>
        Section = 8,
        /// <summary>
        /// Curves where the surface ends: at the search box, or beyond the last samples
        /// (<see cref="LineSetOptions.Support"/>).
        /// </summary>
        Border = 9,
        /// <summary>Polylines of the program, such as creases of a mesh; once.</summary>
        Own = 10,
        /// <summary>
        /// Edges and grooves in which smooth sheets of the surface meet, in models that have them.  Strength: the angle
        /// between the normals of both sheets, in degrees.
        /// </summary>
        /// <remarks>
        /// Where one sheet faces the eye and the other faces away, the crease is part of the contour and is drawn as
        /// Contour.
        /// </remarks>
        Crease = 11,
        /// <summary>
        /// Borders of the shadows that fall on the item, of lights with a shadow.  Strength: the light's
        /// <see cref="Light.Shadow"/>.  Needs <see cref="ShadingOptions.WithLines"/>.
        /// </summary>
        Shadow = 12,
        /// <summary>
        /// Borders between light and shade where the item turns away from a light with a shadow, n . l = 0, and nothing
        /// else shades the place; as Shadow.
        /// </summary>
        Terminator = 13,
        /// <summary>
        /// Edges and folds that are round, such as the worn rim of a base; once.  Strength: the angle by which the surface
        /// turns within a few cells of the line, less the turns beside that, in degrees.  <see cref="LineStyle.Fade"/> makes
        /// the line narrower and not paler.
        /// </summary>
        SoftEdge = 14,
        /// <summary>
        /// Curves in which the surface of the item crosses that of another item with a line set.  Strength: the mean angle
        /// between both surfaces along a curve, in degrees.
        /// </summary>
        /// <remarks>
        /// If both items draw them, they are lines of the item with the smaller mesh cells.  Parts of one model meet in
        /// creases.
        /// </remarks>
        Intersection = 15,
        /// <summary>
        /// Edges of a part along which two surfaces touch without a kink, such as those of a fillet; once.  The caller gives
        /// them as polylines, as Own.  <see cref="TriangleMesh.FindEdges"/> finds them in a mesh.
        /// </summary>
        TangentEdge = 16,
    }

    /// <summary>Which creases are drawn.</summary>
    [NativeConstants("HRBFNPR_CREASES_")]
    public enum Creases
    {
        /// <summary>All creases (default).</summary>
        All = 0,
        /// <summary>Convex creases: edges.</summary>
        Convex = 1,
        /// <summary>Concave creases: grooves, and where something stands on a face.</summary>
        Concave = 2,
    }

    /// <summary>How marks are distributed over a surface.</summary>
    [NativeConstants("HRBFNPR_DISTRIBUTION_")]
    public enum Distribution
    {
        /// <summary>Evenly, in a progressive order every prefix of which is evenly spread (default).</summary>
        BlueNoise = 0,
        /// <summary>By the published recursion, with random ranks [NPAR 5, 6.2].</summary>
        Published = 1,
    }

    /// <summary>The directions that lines of <see cref="LayerKind.Hatch"/> follow.</summary>
    [NativeConstants("HRBFNPR_HATCH_GUIDE_")]
    public enum HatchGuide
    {
        /// <summary>
        /// The direction in which the surface bends most (default); with Published, strokes along both principal
        /// directions.
        /// </summary>
        Curvature = 0,
        /// <summary>
        /// Stark's combing direction; with Published, strokes along both of his directions [NPAR 5.3].
        /// </summary>
        Combing = 1,
        /// <summary>
        /// Sections of the surface by planes perpendicular to <see cref="Layer.Axis"/>; not with Published.
        /// </summary>
        Sections = 2,
        /// <summary>
        /// The tangent part of <see cref="Layer.GuideDirection"/>, which points to the light; not with Published.
        /// </summary>
        Light = 3,
        /// <summary>
        /// The direction conjugate to <see cref="Layer.GuideDirection"/>, which points to the eye: near the silhouette,
        /// lines run along it; not with Published.
        /// </summary>
        Silhouette = 4,
    }

    /// <summary>The seeds from which marks start.</summary>
    [NativeConstants("HRBFNPR_SEED_")]
    public enum SeedSource
    {
        /// <summary>The model's samples if it has them, else the box (default).</summary>
        Auto = 0,
        /// <summary>The model's samples; not for a model without samples.</summary>
        Samples = 1,
        /// <summary>A jittered grid in the bounds, projected onto the surface.</summary>
        Box = 2,
        /// <summary><see cref="GenerateOptions.SeedPoints"/>, projected onto the surface.</summary>
        Points = 3,
    }

    /// <summary>Where the strokes of <see cref="Distribution.Published"/> start.</summary>
    [NativeConstants("HRBFNPR_STROKE_START_")]
    public enum StrokeStart
    {
        /// <summary>At the seeds (default).</summary>
        Seeds = 0,
        /// <summary>At the stipples up to <see cref="Layer.StartLevel"/>.</summary>
        Stipples = 1,
    }

    /// <summary>How densely the stipples of <see cref="Distribution.BlueNoise"/> lie.</summary>
    [NativeConstants("HRBFNPR_DENSITY_")]
    public enum Density
    {
        /// <summary>The same number of stipples per area everywhere (default).</summary>
        Uniform = 0,
        /// <summary>More stipples where the surface bends.</summary>
        Curvature = 1,
        /// <summary>The density of <see cref="Layer.DensityFunction"/>.</summary>
        Callback = 2,
        /// <summary>The density of <see cref="Layer.DensityField"/>.</summary>
        Field = 3,
    }

    /// <summary>The values of a <see cref="HrbfNpr.Field"/>.</summary>
    [NativeConstants("HRBFNPR_FIELD_KIND_")]
    public enum FieldKind
    {
        /// <summary>One number (default).</summary>
        Scalar = 0,
        /// <summary>r, g and b; sRGB-encoded, 0 to 1.</summary>
        Colour = 1,
        /// <summary>x, y and z.  Only the tangent part counts; its sign does not.</summary>
        Direction = 2,
    }

    /// <summary>The tones in which layers appear, if they have no tone range of their own.</summary>
    [NativeConstants("HRBFNPR_TONE_RANGES_")]
    public enum ToneRanges
    {
        /// <summary>Each layer covers all tones (default).</summary>
        Full = 0,
        /// <summary>
        /// The layers follow each other, each over an equal part of the tones: hatching builds up from light to dark.
        /// </summary>
        InTurn = 1,
    }

    /// <summary>The arrays of a layer, with one element for each mark or for each of its S strokes.</summary>
    [NativeConstants("HRBFNPR_MARK_ATTRIBUTE_")]
    public enum MarkAttribute
    {
        /// <summary>Place relative to <see cref="PointSetInfo.Origin"/>; 3 float.</summary>
        Position = 0,
        /// <summary>Normal, unit and outward; 3 float.</summary>
        Normal = 1,
        /// <summary>
        /// Direction along the stroke, unit and tangent; for a mark without a stroke the u of its basis [NPAR 5.2]; 3
        /// float.
        /// </summary>
        Direction = 2,
        /// <summary>k1, k2 and confidence; 3 float; absent if they were not generated.</summary>
        Curvature = 3,
        /// <summary>Rank u in [0, 1) [NPAR 6.2]: the mark is shown where u >= tau; 1 float.</summary>
        Rank = 4,
        /// <summary>
        /// Refinement step that placed the mark; for blue-noise Hatch the level of its line there; 1 byte.
        /// </summary>
        Level = 5,
        /// <summary>2 * number + direction (0 or 1) of the stroke, and the mark's place along it; 2 uint.</summary>
        Stroke = 6,
        /// <summary>Width as a factor of the style's radius, in (0, 1]; 1 float; absent if all are 1.</summary>
        Width = 7,
        /// <summary>
        /// S + 1 uint: stroke s has the marks order[first[s]] to order[first[s + 1] - 1], where order is
        /// <see cref="StrokeOrder"/>; absent for a layer without strokes.
        /// </summary>
        StrokeFirst = 8,
        /// <summary>
        /// Numbers of marks, stroke by stroke; 1 uint; absent if the marks themselves are in this order.
        /// </summary>
        StrokeOrder = 9,
        /// <summary>
        /// Unit normal that sets the tone, averaged over <see cref="Layer.ToneSmoothing"/>; 3 float; absent if it is
        /// Normal.
        /// </summary>
        ToneNormal = 10,
    }
}
