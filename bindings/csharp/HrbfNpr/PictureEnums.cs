// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>Which edges of a mesh are sharp in a picture.</summary>
    [NativeConstants("HRBFNPR_PICTURE_EDGES_")]
    public enum PictureEdges
    {
        /// <summary>
        /// As with Auto.  Where faces are coarse, the normals of the file decide if they say anything about edges
        /// (default).
        /// </summary>
        AsGiven = 0,
        /// <summary>
        /// Edges are sharp if they stand out from the faces beside them, as those of machine parts do.
        /// </summary>
        Auto = 1,
        /// <summary>No edge is sharp: the surface is one smooth fit, which rounds all edges.</summary>
        Smooth = 2,
        /// <summary>Edges are sharp that bend by more than <see cref="PictureOptions.EdgeAngle"/>.</summary>
        Sharp = 3,
    }

    /// <summary>Whether an upright section through the middle is drawn beside the drawing.</summary>
    [NativeConstants("HRBFNPR_PROFILE_")]
    public enum Profile
    {
        /// <summary>A section is drawn in the style Archaeological only (default).</summary>
        Auto = 0,
        /// <summary>A section is drawn.</summary>
        Yes = 1,
        /// <summary>No section is drawn.</summary>
        No = 2,
    }

    /// <summary>The sides of a picture's surfaces on which marks are drawn.</summary>
    [NativeConstants("HRBFNPR_PICTURE_SIDES_")]
    public enum PictureSides
    {
        /// <summary>Both sides of a surface that ends, and the front of other surfaces (default).</summary>
        Auto = 0,
        /// <summary>The front.</summary>
        Front = 1,
        /// <summary>Both sides.</summary>
        Both = 2,
    }

    /// <summary>The ground of a picture, on which only the object's shadow is drawn.</summary>
    [NativeConstants("HRBFNPR_PICTURE_GROUND_")]
    public enum PictureGround
    {
        /// <summary>No ground (default).</summary>
        None = 0,
        /// <summary>At the lowest place of the object along the up direction.</summary>
        Lowest = 1,
        /// <summary>At a given height along the up direction.</summary>
        Height = 2,
    }

    /// <summary>How notes and errors write the options that they name.</summary>
    [NativeConstants("HRBFNPR_WORDING_")]
    public enum Wording
    {
        /// <summary>As fields of a descriptor: samples 400 (default).</summary>
        Fields = 0,
        /// <summary>As options of a command line: --samples 400.</summary>
        Options = 1,
        /// <summary>As arguments of a call in Python: samples=400.</summary>
        Arguments = 2,
    }

    /// <summary>The kind of a source.</summary>
    [NativeConstants("HRBFNPR_SOURCE_KIND_")]
    public enum SourceKind
    {
        /// <summary>Points, with or without normals.</summary>
        Points = 1,
        /// <summary>A mesh.</summary>
        Mesh = 2,
        /// <summary>A model, with or without marks.</summary>
        Model = 3,
        /// <summary>A point set without a model.</summary>
        PointSet = 4,
    }

    /// <summary>Which way normals look.</summary>
    [NativeConstants("HRBFNPR_NORMALS_LOOK_")]
    public enum NormalsLook
    {
        /// <summary>There are no normals, or the source cannot be drawn.</summary>
        Unknown = 0,
        /// <summary>All look outward.</summary>
        Outward = 1,
        /// <summary>All look inward.</summary>
        Inward = 2,
        /// <summary>Some look outward, others inward.</summary>
        Mixed = 3,
        /// <summary>They agree, and the surface encloses nothing.</summary>
        Open = 4,
        /// <summary>They belong to other points; found for points along curves only.</summary>
        Foreign = 5,
    }

    /// <summary>What a dab paints.</summary>
    [NativeConstants("HRBFNPR_DAB_")]
    public enum DabMap
    {
        /// <summary>The tone: 1 = light, 0 = dark (default).</summary>
        Tone = 0,
        /// <summary>The density of stipples: 1 = all, 0 = none.</summary>
        Density = 1,
        /// <summary>The direction of hatching.</summary>
        Direction = 2,
    }

    /// <summary>The stages of the work on a picture.  Later versions may add stages.</summary>
    [NativeConstants("HRBFNPR_STAGE_")]
    public enum Stage
    {
        /// <summary>Looks at a mesh: joins vertices, turns faces.</summary>
        Mesh = 1,
        /// <summary>Chooses samples.</summary>
        Sample = 2,
        /// <summary>Finds normals.</summary>
        Orient = 3,
        /// <summary>Smooths the image of a depth camera.</summary>
        Smooth = 4,
        /// <summary>Fits the surface.</summary>
        Fit = 5,
        /// <summary>Compares the surface with the mesh.</summary>
        Compare = 6,
        /// <summary>Finds the end of the surface.</summary>
        End = 7,
        /// <summary>Places marks.</summary>
        Marks = 8,
        /// <summary>Finds lines.</summary>
        Lines = 9,
        /// <summary>Draws.</summary>
        Frame = 10,
        /// <summary>Draws the views of a sheet.</summary>
        Views = 11,
        /// <summary>Finds occlusion and cast shadows.</summary>
        Shade = 12,
    }

    /// <summary>How much a note matters.</summary>
    [NativeConstants("HRBFNPR_SEVERITY_")]
    public enum Severity
    {
        /// <summary>A measurement.</summary>
        Info = 0,
        /// <summary>Something was chosen, repaired or left out.</summary>
        Note = 1,
        /// <summary>The result may be wrong in some place.</summary>
        Warning = 2,
        /// <summary>There is no result: the text is the error of the call, in full length.</summary>
        Failure = 3,
    }

    /// <summary>
    /// Codes of notes.  Each line says when a note is given, with its figures in brackets.  Later versions may add
    /// codes.
    /// </summary>
    /// <remarks>Figures are counts unless a line says otherwise.  Shares are from 0 to 1.</remarks>
    [NativeConstants("HRBFNPR_NOTE_")]
    public enum NoteCode
    {
        /// <summary>Faces with a corner that is not finite are left out [faces].</summary>
        FacesNotFinite = 1,
        /// <summary>Points at a value that means "no data" are left out [points, the value].</summary>
        NoData = 2,
        /// <summary>Points far from all others are left out [points].</summary>
        Strays = 3,
        /// <summary>
        /// Only some of the points get normals, because there are many [points, points with normals].
        /// </summary>
        SomeOriented = 4,
        /// <summary>The points have no normals, and get some [points].</summary>
        NormalsMade = 5,
        /// <summary>Normals that were found are not certain [confidence, 0 to 1].</summary>
        NormalsNotSure = 6,
        /// <summary>The surface is open, and nothing tells which side is its front.</summary>
        FrontNotTold = 7,
        /// <summary>Only some points are used as samples [points, points used].</summary>
        SamplesChosen = 8,
        /// <summary>Points without a usable position or normal are left out [points].</summary>
        PointsNotUsable = 9,
        /// <summary>Places with several normals get the mean of these [places].</summary>
        NormalsJoined = 10,
        /// <summary>Places with opposite normals are left out [places].</summary>
        NormalsOpposite = 11,
        /// <summary>A terrain looked down, and its normals are turned [axis: 1 = y, 2 = z].</summary>
        TerrainTurned = 12,
        /// <summary>All normals looked inward, and are turned.</summary>
        NormalsTurned = 13,
        /// <summary>
        /// Given normals are repaired [normals turned, normals made, what they were: a number of
        /// <see cref="Normals"/>].
        /// </summary>
        NormalsRepaired = 14,
        /// <summary>Some normals look against those around them [these normals, all normals].</summary>
        NormalsAgainst = 15,
        /// <summary>Some parts have outward normals and others inward ones [share that looks inward].</summary>
        NormalsMixed = 16,
        /// <summary>Most of an open surface looks inward.</summary>
        NormalsInward = 17,
        /// <summary>A viewpoint is given, but the source needs none.</summary>
        ViewpointNotUsed = 18,
        /// <summary>Pixels of a depth camera that lie on no surface are left out [pixels].</summary>
        PixelsLeftOut = 19,
        /// <summary>
        /// The noise of a depth camera was measured [standard deviation, depth where it holds; units of the source].
        /// </summary>
        DepthNoise = 20,
        /// <summary>The samples have noise, and the surface does not pass through all of them.</summary>
        Smoothed = 21,
        /// <summary>Samples at the same place are merged [samples].</summary>
        SamplesMerged = 22,
        /// <summary>Samples very near to another are merged with it [samples].</summary>
        SamplesNear = 23,
        /// <summary>Samples are dropped as strays [samples].</summary>
        SamplesDropped = 24,
        /// <summary>Flipped normals of samples are repaired [samples].</summary>
        SamplesFlipped = 25,
        /// <summary>Samples that look like strays are kept [samples].</summary>
        LikeStrays = 26,
        /// <summary>Samples whose normals look flipped are kept [samples].</summary>
        LikeFlipped = 27,
        /// <summary>The surface is a guess, because there are few points [points].</summary>
        FewPoints = 28,
        /// <summary>All points are on a line.</summary>
        OnALine = 29,
        /// <summary>All points are in a plane.</summary>
        InAPlane = 30,
        /// <summary>The points lie along curves, and the surface between these is drawn, too.</summary>
        AlongCurves = 31,
        /// <summary>The end of the surface was not found, and the surface goes on to the end of its box.</summary>
        EndNotFound = 32,
        /// <summary>Another direction than y is chosen as up [x, y, z].</summary>
        Up = 33,
        /// <summary>Faces that looked to the other side than those beside them are turned [faces].</summary>
        FacesTurned = 34,
        /// <summary>A mesh, or some of its parts, is inside out, and is turned [parts].</summary>
        InsideOut = 35,
        /// <summary>Faces without area, and repeated faces, are left out [faces].</summary>
        FacesLeftOut = 36,
        /// <summary>Parts of a mesh inside others are left out [parts, their faces].</summary>
        PartsInside = 37,
        /// <summary>
        /// Faces beside each other look to opposite sides and cannot be turned: the surface has one side, or crosses
        /// itself [edges].
        /// </summary>
        ContraryEdges = 38,
        /// <summary>Parts of a mesh far from all others are left out [parts, their faces].</summary>
        PartsFar = 39,
        /// <summary>Faces that hang on an edge of two others are left out [faces].</summary>
        Flaps = 40,
        /// <summary>All faces stay flat, because the normals of the file say so.</summary>
        AllFlat = 41,
        /// <summary>Some edges are sharp, because the normals of the file say so.</summary>
        EdgesByNormals = 42,
        /// <summary>
        /// Coarse faces are divided towards a round surface [rounds; how far vertices moved; how far places between
        /// them were raised; how far the faces were off a round surface, if they are coarse; shares of the diagonal].
        /// </summary>
        Divided = 43,
        /// <summary>Coarse faces stay flat, because no round surface goes through them.</summary>
        CoarseFlat = 44,
        /// <summary>
        /// Parts of a mesh that cross or are close are fitted in groups, each as a separate surface [parts, groups].
        /// </summary>
        Groups = 45,
        /// <summary>
        /// The fit did not reach its tolerance everywhere [tolerance in diagonals, share of the mesh within it, share
        /// of the surface within it, greatest distance in diagonals].
        /// </summary>
        NotReached = 46,
        /// <summary>Some sharp edges of a mesh stay smooth [their length in diagonals].</summary>
        EdgesStaySmooth = 47,
        /// <summary>
        /// The surface is far from the mesh in some places [share of the mesh, greatest distance in diagonals].
        /// </summary>
        OffMesh = 48,
        /// <summary>The fit made parts of surface that the mesh does not have, and they are left out [parts].</summary>
        MadeByFit = 49,
        /// <summary>
        /// Two parts of a mesh are nearer to each other than the tolerance, so that the surface may join them [numbers
        /// of both parts, from 0; x, y and z of the place].
        /// </summary>
        PartsTooThin = 50,
        /// <summary>A layer has fewer marks than fill the darkest tone [marks wanted, marks made].</summary>
        MarksLimited = 51,
        /// <summary>
        /// The published method makes fewer refinement steps than fill the picture [steps wanted, steps made].
        /// </summary>
        LevelsLimited = 52,
        /// <summary>The image of a depth camera is seen from where the camera stood [azimuth in degrees].</summary>
        SeenFromCamera = 53,
        /// <summary>An open surface is seen from its front [azimuth in degrees].</summary>
        SeenFromFront = 54,
        /// <summary>No lines are drawn, because the source is a point set without a model.</summary>
        NoLinesOfMarks = 55,
        /// <summary>
        /// The surface is thinner than the cells in which lines are searched, so that lines may be missing [triangles
        /// that look away, all triangles, samples missed].
        /// </summary>
        LinesThin = 56,
        /// <summary>
        /// Lines end where the surface ends beyond its samples [borders, support, share of the area left out].
        /// </summary>
        LinesEnd = 57,
        /// <summary>Some curves end inside the surface, or were missed [curves].</summary>
        LinesBroken = 58,
        /// <summary>The visibility of some lines contradicts itself [lines].</summary>
        LinesDoubted = 59,
        /// <summary>Lines cross so often in some places of the picture that no crossing was used [places].</summary>
        LinesTangled = 60,
        /// <summary>
        /// Hardly anything can be seen [marks shown, all marks, share of the picture that ink covers].
        /// </summary>
        Blank = 61,
        /// <summary>Pens are chosen by the widths at hand.</summary>
        Pens = 62,
        /// <summary>A plotter's file is written [metres drawn, metres travelled, seconds].</summary>
        Plotted = 63,
        /// <summary>Something that the picture was made with is not in its settings.</summary>
        NotInSettings = 64,
        /// <summary>The unit of the source is taken as a metre, because its format says so.</summary>
        UnitIsMetre = 65,
        /// <summary>Centre lines are asked for, but no plane of symmetry was found.</summary>
        NoSymmetry = 66,
        /// <summary>Outlines of a cut are not closed, and are not hatched [outlines].</summary>
        SectionOpen = 67,
        /// <summary>Normals get the length 1 [normals].</summary>
        NormalsNotUnit = 68,
        /// <summary>All points are at one place.</summary>
        AtOnePlace = 69,
        /// <summary>The source is so far from the origin that single precision loses its details.</summary>
        FarFromOrigin = 70,
        /// <summary>Vertices at the place of another are joined with it [vertices].</summary>
        VerticesJoined = 71,
        /// <summary>Vertices of no face are left out [vertices].</summary>
        VerticesUnused = 72,
        /// <summary>Edges have more than two faces [edges].</summary>
        NonmanifoldEdges = 73,
        /// <summary>A mesh is open [borders, their edges].</summary>
        MeshOpen = 74,
        /// <summary>A mesh has several parts [parts].</summary>
        SeveralParts = 75,
        /// <summary>A source cannot be drawn; the text says why.</summary>
        NotUsable = 76,
        /// <summary>No ground is drawn; the text says why.</summary>
        NoGround = 77,
        /// <summary>Inks are chosen from the colours of the source [inks].</summary>
        PaletteChosen = 78,
        /// <summary>Borders of shadows are to be drawn, and no light casts shadows.</summary>
        NoShadows = 79,
        /// <summary>
        /// Rays were compared with all parts of lines [decided parts, those that agree, undecided parts, repaired parts].
        /// </summary>
        LinesVerified = 95,
    }

    /// <summary>Where views stand [ISO 5456-2].</summary>
    [NativeConstants("HRBFNPR_VIEWS_ANGLE_")]
    public enum ProjectionAngle
    {
        /// <summary>First angle: the left view stands at the right, the top view below (default).</summary>
        First = 0,
        /// <summary>Third angle: the left view stands at the left, the top view above.</summary>
        Third = 1,
    }

    /// <summary>How hidden edges are drawn.  Sections never have hidden edges [ISO 128-3].</summary>
    [NativeConstants("HRBFNPR_VIEWS_HIDDEN_")]
    public enum HiddenEdges
    {
        /// <summary>Hidden edges are dashed thin lines (default).</summary>
        Dashed = 0,
        /// <summary>Hidden edges are not drawn.</summary>
        None = 1,
        /// <summary>Hidden edges are continuous thin lines.</summary>
        Shown = 2,
    }

    /// <summary>
    /// How tangent edges are drawn, along which two surfaces of a part touch without a kink, such as those of a fillet.
    /// They are continuous thin lines; hidden ones are not drawn.
    /// </summary>
    [NativeConstants("HRBFNPR_VIEWS_TANGENT_")]
    public enum TangentEdges
    {
        /// <summary>
        /// Tangent edges end three widths of an outline before the lines that they would touch (default).
        /// </summary>
        Short = 0,
        /// <summary>Tangent edges go up to the lines that they touch.</summary>
        Thin = 1,
        /// <summary>Tangent edges are not drawn.</summary>
        None = 2,
    }
}
