// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>What a call of the library ended with; the numbers are fixed for ever.</summary>
    [NativeConstants("HRBFNPR_STATUS_")]
    public enum Status
    {
        /// <summary>Success.</summary>
        Ok = 0,
        /// <summary>An argument was wrong.</summary>
        InvalidArgument = -1,
        /// <summary>The allocator said no.</summary>
        OutOfMemory = -2,
        /// <summary>A destination was too small.</summary>
        BufferTooSmall = -3,
        /// <summary>The library is older than this assembly and does not know a field that was set.</summary>
        UnsupportedStruct = -4,
        /// <summary>The fit has no (numerically) unique solution.</summary>
        SingularSystem = -5,
        /// <summary>An iteration ended short of its goal.</summary>
        NotConverged = -6,
        /// <summary>The call was cancelled.</summary>
        Cancelled = -7,
        /// <summary>A stream failed.</summary>
        Io = -8,
        /// <summary>The data is not ours, truncated or damaged.</summary>
        CorruptData = -9,
        /// <summary>The data, or this assembly, is too new for the library.</summary>
        VersionMismatch = -10,
        /// <summary>A function of the program failed.</summary>
        Callback = -11,
        /// <summary>A bug in the library.</summary>
        Internal = -99,
    }

    /// <summary>Type of the numbers in an array.</summary>
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

    /// <summary>Channels of pixels in the order of memory, sRGB-encoded.</summary>
    [NativeConstants("HRBFNPR_FORMAT_")]
    public enum PixelFormat
    {
        /// <summary>Straight RGBA (default).</summary>
        Rgba8 = 1,
        /// <summary>Straight BGRA.</summary>
        Bgra8 = 2,
        /// <summary>RGBA, colour times alpha.</summary>
        Rgba8Premultiplied = 3,
        /// <summary>BGRA, colour times alpha.</summary>
        Bgra8Premultiplied = 4,
        /// <summary>Straight RGBA, 4 float in [0, 1], aligned to 4 bytes.</summary>
        Rgba32f = 5,
        /// <summary>The same, colour times alpha.</summary>
        Rgba32fPremultiplied = 6,
        /// <summary>1 byte: how much of the pixel ink covers, whatever its colour.</summary>
        Coverage8 = 7,
    }

    /// <summary>How important a line of the log is.</summary>
    [NativeConstants("HRBFNPR_LOG_")]
    public enum LogLevel
    {
        /// <summary>For who works on the library.</summary>
        Debug = 0,
        /// <summary>What was done.</summary>
        Info = 1,
        /// <summary>What may be wrong.</summary>
        Warning = 2,
    }

    /// <summary>Who runs the library's tasks; the results are the same bits from all.</summary>
    [NativeConstants("HRBFNPR_THREAD_BACKEND_")]
    public enum ThreadBackend
    {
        /// <summary><see cref="ContextOptions.RunTasks"/> where that is given, else the pool.</summary>
        Auto = 0,
        /// <summary>Threads of the context's own, which a processor that is busy elsewhere hardly hurts.</summary>
        Pool = 1,
        /// <summary>The OpenMP runtime's, for processors that nobody else wants.</summary>
        Openmp = 2,
        /// <summary>The program's own task runner.</summary>
        RunTasks = 3,
        /// <summary>The calling thread alone.</summary>
        Serial = 4,
    }

    /// <summary>Vector instructions of the processor.</summary>
    [NativeConstants("HRBFNPR_INSTRUCTION_SET_")]
    public enum InstructionSet
    {
        /// <summary>The best that build and processor have.</summary>
        Auto = 0,
        /// <summary>What the library was compiled for.</summary>
        Baseline = 1,
        /// <summary>AVX2 with FMA.</summary>
        Avx2 = 2,
        /// <summary>AVX-512.</summary>
        Avx512 = 3,
        /// <summary>NEON.</summary>
        Neon = 4,
    }

    /// <summary>Radial functions phi(r) [NPAR 4.1].</summary>
    [NativeConstants("HRBFNPR_KERNEL_")]
    public enum Kernel
    {
        /// <summary>r^3 (default); no radius.</summary>
        Triharmonic = 0,
        /// <summary>exp(-r^2 / 2 radius^2).</summary>
        Gaussian = 1,
        /// <summary>(1 - r/radius)^4 (4 r/radius + 1) within the radius.</summary>
        WendlandC2 = 2,
        /// <summary>Reported for a model made from a function.</summary>
        Custom = 3,
        /// <summary>Reported for a solid put together from others.</summary>
        Csg = 4,
    }

    /// <summary>How the linear system of a fit is solved.</summary>
    [NativeConstants("HRBFNPR_SOLVER_")]
    public enum Solver
    {
        /// <summary>The library chooses (default).</summary>
        Auto = 0,
        /// <summary>Dense factorisation: memory about 64 N^2 bytes, time N^3.</summary>
        Direct = 1,
        /// <summary>Preconditioned conjugate gradients: memory about 2 to 6 kB a sample.</summary>
        Iterative = 2,
    }

    /// <summary>Why the solver that was used is the one.</summary>
    [NativeConstants("HRBFNPR_SOLVER_REASON_")]
    public enum SolverReason
    {
        /// <summary>The caller named it.</summary>
        Requested = 0,
        /// <summary>The direct one is the faster one.</summary>
        Small = 1,
        /// <summary>The direct one would take too much memory or time.</summary>
        Large = 2,
        /// <summary>The iterative one did not reach its tolerance.</summary>
        NotConverged = 3,
        /// <summary>The iterative one needs a definite system.</summary>
        NotDefinite = 4,
    }

    /// <summary>What becomes of samples that look wrong; they are counted in any case.</summary>
    [NativeConstants("HRBFNPR_REPAIR_")]
    public enum Repair
    {
        /// <summary>Nothing (default).</summary>
        Keep = 0,
        /// <summary>They are left out.</summary>
        Drop = 1,
        /// <summary>Of flipped normals only: turned round.</summary>
        Reorient = 2,
    }

    /// <summary>What is known of given normals.</summary>
    [NativeConstants("HRBFNPR_NORMALS_")]
    public enum Normals
    {
        /// <summary>They are right, and point outward.</summary>
        Given = 0,
        /// <summary>There are none, or none to go by.</summary>
        None = 1,
        /// <summary>Directions are right, signs are not.</summary>
        Unoriented = 2,
        /// <summary>Most signs are right, too; some patches are turned.</summary>
        Mixed = 3,
        /// <summary>Right, but for all pointing inward.</summary>
        Inward = 4,
        /// <summary>Find out which of these it is, and do what that calls for.</summary>
        Auto = 5,
    }

    /// <summary>Whether a fitted surface ends where its samples do.</summary>
    [NativeConstants("HRBFNPR_TRIM_")]
    public enum TrimMode
    {
        /// <summary>It goes on, to the end of the search box.</summary>
        Never = 0,
        /// <summary>That of an open surface does (default); a closed one stays as it is.</summary>
        Auto = 1,
    }

    /// <summary>Which sides of a surface its marks are drawn on.</summary>
    [NativeConstants("HRBFNPR_SIDES_")]
    public enum Sides
    {
        /// <summary>That which the normals look to (default): a solid's inside is never seen.</summary>
        Front = 0,
        /// <summary>Of a surface that ends, the other one, too, where it looks to the camera.</summary>
        Both = 1,
    }

    /// <summary>How it was decided which side is outward.</summary>
    [NativeConstants("HRBFNPR_OUTWARD_")]
    public enum OutwardBy
    {
        /// <summary>The other side is inside.</summary>
        Inside = 0,
        /// <summary>The side that up points to.</summary>
        Up = 1,
        /// <summary>The side that is seen.</summary>
        Viewpoint = 2,
        /// <summary>Most given normals say so.</summary>
        AsGiven = 3,
    }

    /// <summary>Where the regularization of a fit comes from.</summary>
    [NativeConstants("HRBFNPR_REGULARIZATION_")]
    public enum RegularizationMode
    {
        /// <summary><see cref="FitOptions.Regularization"/> (default).</summary>
        Given = 0,
        /// <summary>From the noise of the samples.</summary>
        Auto = 1,
    }

    /// <summary>What became of a point that was to be projected.</summary>
    [NativeConstants("HRBFNPR_PROJECTION_")]
    public enum ProjectionStatus : byte
    {
        /// <summary>It lies on the surface.</summary>
        Converged = 0,
        /// <summary>Evaluation limit, or no step lowers f^2.</summary>
        NotConverged = 1,
        /// <summary>Stuck at a critical point off the surface.</summary>
        ZeroGradient = 2,
        /// <summary>f or its gradient was not finite.</summary>
        NotFinite = 3,
    }

    /// <summary>What became of a ray.</summary>
    [NativeConstants("HRBFNPR_RAY_")]
    public enum RayStatus : byte
    {
        /// <summary>One hit or more.</summary>
        Hit = 0,
        /// <summary>None.</summary>
        Miss = 1,
        /// <summary>There are more hits than were asked for (two or more).</summary>
        Truncated = 2,
        /// <summary>Given up on; what was found before is kept.</summary>
        EvaluationLimit = 3,
        /// <summary>f or its gradient was not finite; what was found before is kept.</summary>
        NotFinite = 4,
    }

    /// <summary>What the marks of a layer are.  More kinds may come: treat an unknown one like Own.</summary>
    [NativeConstants("HRBFNPR_LAYER_KIND_")]
    public enum LayerKind
    {
        /// <summary>In styles only: layers of every kind.</summary>
        Any = 0,
        /// <summary>Scattered marks.</summary>
        Stipples = 1,
        /// <summary>
        /// Lines along a field of directions: evenly spaced and nested with <see cref="Distribution.BlueNoise"/>, level 0
        /// the coarsest, those of each further level midway between all before [Knoeppel et al. 2015]; strokes along the
        /// directions and across them with <see cref="Distribution.Published"/> [NPAR 5].
        /// </summary>
        Hatch = 2,
        /// <summary>Marks or strokes of the program's own.</summary>
        Own = 3,
    }

    /// <summary>
    /// Kinds of lines.  Those marked "once" are found when a line set is made, for each of its
    /// <see cref="LineSetOptions.Lines"/>; the others with every drawing.  Strengths have no unit: lengths are in
    /// diagonals of the model.
    /// </summary>
    [NativeConstants("HRBFNPR_LINE_KIND_")]
    public enum LineKind
    {
        /// <summary>Occluding contours: the line of sight is tangent to the surface.</summary>
        Contour = 1,
        /// <summary>
        /// Where a contour would appear soon; strength: the derivative of the radial curvature towards the eye; needs
        /// <see cref="LineSetOptions.WithCurvature"/> [DeCarlo 2003].
        /// </summary>
        SuggestiveContour = 2,
        /// <summary>
        /// Once; strength: curvature across the ridge less that along it [Ohtake, Belyaev and Seidel 2004].
        /// </summary>
        Ridge = 3,
        /// <summary>Once; the same.</summary>
        Valley = 4,
        /// <summary>
        /// Strength: view-dependent curvature; needs <see cref="LineSetOptions.WithCurvature"/> [Judd 2007].
        /// </summary>
        ApparentRidge = 5,
        /// <summary>Once; Gaussian curvature 0.</summary>
        Parabolic = 6,
        /// <summary>
        /// n . l = <see cref="LineStyle.Levels"/>, l the style's light; needs
        /// <see cref="LineSetOptions.WithCurvature"/>.
        /// </summary>
        Isophote = 7,
        /// <summary>Once; parallel planes.</summary>
        Section = 8,
        /// <summary>Where the surface ends: at the search box.</summary>
        Border = 9,
        /// <summary>Once; polylines of the program's own, such as creases of a mesh.</summary>
        Own = 10,
        /// <summary>
        /// Where smooth sheets of the surface meet, of models that have such edges; strength: the angle between their
        /// normals, degrees.  Where one sheet faces the eye and the other does not, a crease is part of the contour.
        /// </summary>
        Crease = 11,
    }

    /// <summary>Creases by the way that the surface bends there.</summary>
    [NativeConstants("HRBFNPR_CREASES_")]
    public enum Creases
    {
        /// <summary>All of them (default).</summary>
        All = 0,
        /// <summary>Edges.</summary>
        Convex = 1,
        /// <summary>Grooves, and where something stands on a face.</summary>
        Concave = 2,
    }

    /// <summary>How marks are spread.</summary>
    [NativeConstants("HRBFNPR_DISTRIBUTION_")]
    public enum Distribution
    {
        /// <summary>Evenly, in a progressive order each prefix of which is even (default).</summary>
        BlueNoise = 0,
        /// <summary>The published recursion, with random ranks [NPAR 5, 6.2].</summary>
        Published = 1,
    }

    /// <summary>What the lines of <see cref="LayerKind.Hatch"/> follow.</summary>
    [NativeConstants("HRBFNPR_HATCH_GUIDE_")]
    public enum HatchGuide
    {
        /// <summary>The direction in which the surface bends most (default); published strokes: both principal directions.</summary>
        Curvature = 0,
        /// <summary>Stark's combing direction; published strokes: both of his directions [NPAR 5.3].</summary>
        Combing = 1,
        /// <summary>Sections by planes across <see cref="Layer.Axis"/>.</summary>
        Sections = 2,
        /// <summary>Away from the light of <see cref="Layer.GuideDirection"/>.</summary>
        Light = 3,
        /// <summary>As the silhouette runs that is seen from <see cref="Layer.GuideDirection"/>.</summary>
        Silhouette = 4,
    }

    /// <summary>Where marks start from.</summary>
    [NativeConstants("HRBFNPR_SEED_")]
    public enum SeedSource
    {
        /// <summary>The model's samples if they are well spread, else the box (default).</summary>
        Auto = 0,
        /// <summary>The model's samples; not of a model from a function.</summary>
        Samples = 1,
        /// <summary>A jittered grid in the bounds, projected.</summary>
        Box = 2,
        /// <summary><see cref="GenerateOptions.SeedPoints"/>, projected.</summary>
        Points = 3,
    }

    /// <summary>What the strokes of <see cref="Distribution.Published"/> start from.</summary>
    [NativeConstants("HRBFNPR_STROKE_START_")]
    public enum StrokeStart
    {
        /// <summary>The seeds (default).</summary>
        Seeds = 0,
        /// <summary>The stipples up to a level.</summary>
        Stipples = 1,
    }

    /// <summary>How dense stipples are over the surface.</summary>
    [NativeConstants("HRBFNPR_DENSITY_")]
    public enum Density
    {
        /// <summary>As many per area everywhere (default).</summary>
        Uniform = 0,
        /// <summary>More where the surface bends.</summary>
        Curvature = 1,
        /// <summary>As <see cref="Layer.DensityFunction"/> says.</summary>
        Callback = 2,
    }

    /// <summary>Which tones the ranks of each layer cover.</summary>
    [NativeConstants("HRBFNPR_TONE_RANGES_")]
    public enum ToneRanges
    {
        /// <summary>Each layer's ranks cover all tones (default).</summary>
        Full = 0,
        /// <summary>One layer, or direction of strokes, after the other: hatching builds up from light to dark.</summary>
        InTurn = 1,
    }

    /// <summary>What is known of each mark of a layer, and of each of its S strokes.</summary>
    [NativeConstants("HRBFNPR_MARK_ATTRIBUTE_")]
    public enum MarkAttribute
    {
        /// <summary>3 float, relative to <see cref="PointSetInfo.Origin"/>.</summary>
        Position = 0,
        /// <summary>3 float, unit, outward.</summary>
        Normal = 1,
        /// <summary>3 float, unit, tangent: along the stroke; for a mark of none the u of its basis [NPAR 5.2].</summary>
        Direction = 2,
        /// <summary>3 float: k1, k2, confidence; absent where not generated.</summary>
        Curvature = 3,
        /// <summary>1 float in [0, 1): the u of [NPAR 6.2]; a mark is shown where u >= tau.</summary>
        Rank = 4,
        /// <summary>1 byte: the refinement step, or the pass of strokes, that placed the mark.</summary>
        Level = 5,
        /// <summary>2 uint: stroke (2 number + direction, 0 or 1) and the mark's place along it.</summary>
        Stroke = 6,
        /// <summary>1 float in (0, 1]: relative width; absent where all are 1.</summary>
        Width = 7,
        /// <summary>
        /// S + 1 uint: stroke s has the marks order[first[s]] to order[first[s + 1] - 1]; absent without strokes.
        /// </summary>
        StrokeFirst = 8,
        /// <summary>1 uint: that order; absent where marks stand stroke by stroke already.</summary>
        StrokeOrder = 9,
        /// <summary>3 float, unit: the normal that tone goes by; absent: Normal.</summary>
        ToneNormal = 10,
    }
}
