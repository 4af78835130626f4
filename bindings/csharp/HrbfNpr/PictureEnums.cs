// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>Which edges of a mesh a picture keeps sharp.</summary>
    [NativeConstants("HRBFNPR_PICTURE_EDGES_")]
    public enum PictureEdges
    {
        /// <summary>As Auto; where faces are coarse, as the normals of the file tell if they do (default).</summary>
        AsGiven = 0,
        /// <summary>Sharp where they stand out, as those of machine parts do.</summary>
        Auto = 1,
        /// <summary>None: the surface is one smooth fit, which rounds them.</summary>
        Smooth = 2,
        /// <summary>Wherever faces meet at more than <see cref="PictureOptions.EdgeAngle"/>.</summary>
        Sharp = 3,
    }

    /// <summary>Whether an upright section through the middle stands beside the drawing.</summary>
    [NativeConstants("HRBFNPR_PROFILE_")]
    public enum Profile
    {
        /// <summary>With the style Archaeological alone (default).</summary>
        Auto = 0,
        /// <summary>It does.</summary>
        Yes = 1,
        /// <summary>It does not.</summary>
        No = 2,
    }

    /// <summary>Which sides of a picture's surfaces marks are drawn on.</summary>
    [NativeConstants("HRBFNPR_PICTURE_SIDES_")]
    public enum PictureSides
    {
        /// <summary>Both of a surface that ends, else the front (default).</summary>
        Auto = 0,
        /// <summary>The front.</summary>
        Front = 1,
        /// <summary>Both.</summary>
        Both = 2,
    }

    /// <summary>How notes and errors name the options that they speak of.</summary>
    [NativeConstants("HRBFNPR_WORDING_")]
    public enum Wording
    {
        /// <summary>samples 400 (default).</summary>
        Fields = 0,
        /// <summary>--samples 400, of a command line.</summary>
        Options = 1,
        /// <summary>samples=400, of a call in Python.</summary>
        Arguments = 2,
    }

    /// <summary>What a source is.</summary>
    [NativeConstants("HRBFNPR_SOURCE_KIND_")]
    public enum SourceKind
    {
        /// <summary>Points, with normals or without.</summary>
        Points = 1,
        /// <summary>A mesh of triangles.</summary>
        Mesh = 2,
        /// <summary>A model.</summary>
        Model = 3,
        /// <summary>A point set alone.</summary>
        PointSet = 4,
    }

    /// <summary>Which way the normals of a source look.</summary>
    [NativeConstants("HRBFNPR_NORMALS_LOOK_")]
    public enum NormalsLook
    {
        /// <summary>There are none, or the source cannot be drawn.</summary>
        Unknown = 0,
        /// <summary>Outward.</summary>
        Outward = 1,
        /// <summary>Inward.</summary>
        Inward = 2,
        /// <summary>Some outward, others inward.</summary>
        Mixed = 3,
        /// <summary>They agree, and the surface encloses nothing.</summary>
        Open = 4,
        /// <summary>They belong to other points; told of points along curves.</summary>
        Foreign = 5,
    }

    /// <summary>What a stroke of a brush paints.</summary>
    [NativeConstants("HRBFNPR_DAB_")]
    public enum DabMap
    {
        /// <summary>Tone: 1 = light, 0 = dark (default).</summary>
        Tone = 0,
        /// <summary>How dense marks are.</summary>
        Density = 1,
        /// <summary>The direction of hatching.</summary>
        Direction = 2,
    }

    /// <summary>A part of the work on a picture.  More may come.</summary>
    [NativeConstants("HRBFNPR_STAGE_")]
    public enum Stage
    {
        /// <summary>Looking at a mesh: welding, turning faces.</summary>
        Mesh = 1,
        /// <summary>Choosing samples.</summary>
        Sample = 2,
        /// <summary>Looking for normals.</summary>
        Orient = 3,
        /// <summary>Smoothing the image of a depth camera.</summary>
        Smooth = 4,
        /// <summary>Fitting.</summary>
        Fit = 5,
        /// <summary>Comparing the surface with the mesh.</summary>
        Compare = 6,
        /// <summary>Looking for the end of the surface.</summary>
        End = 7,
        /// <summary>Placing marks.</summary>
        Marks = 8,
        /// <summary>Looking for lines.</summary>
        Lines = 9,
        /// <summary>Drawing.</summary>
        Frame = 10,
        /// <summary>Drawing the views of a sheet.</summary>
        Views = 11,
    }

    /// <summary>How much a note matters.</summary>
    [NativeConstants("HRBFNPR_SEVERITY_")]
    public enum Severity
    {
        /// <summary>A measurement.</summary>
        Info = 0,
        /// <summary>Something was chosen, repaired or left out.</summary>
        Note = 1,
        /// <summary>The result may be wrong there.</summary>
        Warning = 2,
        /// <summary>There is no result: the error of the call, in full length.</summary>
        Failure = 3,
    }

    /// <summary>What a note is about.  In brackets the figures of each.  More may come.</summary>
    [NativeConstants("HRBFNPR_NOTE_")]
    public enum NoteCode
    {
        /// <summary>Faces with corners that are not finite were left out [faces].</summary>
        FacesNotFinite = 1,
        /// <summary>Points at a value that stands for none were left out [points, value].</summary>
        NoData = 2,
        /// <summary>Points far from all others were left out [points].</summary>
        Strays = 3,
        /// <summary>There are many points, and only some of them get normals [points, used].</summary>
        SomeOriented = 4,
        /// <summary>There were no normals, and they were made [points].</summary>
        NormalsMade = 5,
        /// <summary>The normals that were found may be wrong [confidence].</summary>
        NormalsNotSure = 6,
        /// <summary>Nothing tells which side of an open surface is its front.</summary>
        FrontNotTold = 7,
        /// <summary>Some points were chosen as samples [points, used].</summary>
        SamplesChosen = 8,
        /// <summary>Points without a position or a normal were left out [points].</summary>
        PointsNotUsable = 9,
        /// <summary>Several normals at one place became their mean [places].</summary>
        NormalsJoined = 10,
        /// <summary>Places with opposite normals were left out [places].</summary>
        NormalsOpposite = 11,
        /// <summary>A terrain that looked down was turned [axis].</summary>
        TerrainTurned = 12,
        /// <summary>All normals looked inward, and were turned.</summary>
        NormalsTurned = 13,
        /// <summary>Normals were repaired [turned, made, a number of <see cref="Normals"/>: what they were].</summary>
        NormalsRepaired = 14,
        /// <summary>Normals are against those around them [normals, of].</summary>
        NormalsAgainst = 15,
        /// <summary>Some parts look outward, others inward [share].</summary>
        NormalsMixed = 16,
        /// <summary>Most normals of an open surface look inward.</summary>
        NormalsInward = 17,
        /// <summary>A viewpoint was given that nothing is decided by.</summary>
        ViewpointNotUsed = 18,
        /// <summary>Pixels of a depth camera that are on no surface were left out [pixels].</summary>
        PixelsLeftOut = 19,
        /// <summary>How noisy the image of a depth camera is [noise, depth].</summary>
        DepthNoise = 20,
        /// <summary>The samples have noise, and the surface does not go through all of them.</summary>
        Smoothed = 21,
        /// <summary>Samples at the same place were merged [samples].</summary>
        SamplesMerged = 22,
        /// <summary>Samples very near to another were merged with it [samples].</summary>
        SamplesNear = 23,
        /// <summary>Samples were dropped as strays [samples].</summary>
        SamplesDropped = 24,
        /// <summary>Samples had a flipped normal, which was repaired [samples].</summary>
        SamplesFlipped = 25,
        /// <summary>Samples look like strays, and stay [samples].</summary>
        LikeStrays = 26,
        /// <summary>Samples look as if their normals were flipped, and stay [samples].</summary>
        LikeFlipped = 27,
        /// <summary>There are few points, and the surface is a guess [points].</summary>
        FewPoints = 28,
        /// <summary>All points are on a line.</summary>
        OnALine = 29,
        /// <summary>All points are in a plane.</summary>
        InAPlane = 30,
        /// <summary>Points are along curves, and the surface between these is drawn, too.</summary>
        AlongCurves = 31,
        /// <summary>Where the surface ends was not found.</summary>
        EndNotFound = 32,
        /// <summary>Another direction than y is up [x, y, z].</summary>
        Up = 33,
        /// <summary>Faces against those beside them were turned [faces].</summary>
        FacesTurned = 34,
        /// <summary>A mesh, or parts of it, was inside out and was turned [parts].</summary>
        InsideOut = 35,
        /// <summary>Faces without area, or given twice, were left out [faces].</summary>
        FacesLeftOut = 36,
        /// <summary>Parts inside others were left out [parts, faces].</summary>
        PartsInside = 37,
        /// <summary>The mesh is of one side, or crosses itself [edges].</summary>
        ContraryEdges = 38,
        /// <summary>Parts far from all others were left out [parts, faces].</summary>
        PartsFar = 39,
        /// <summary>Faces on an edge of two others were left out [faces].</summary>
        Flaps = 40,
        /// <summary>All faces are flat by the normals of the file.</summary>
        AllFlat = 41,
        /// <summary>Some edges are sharp by the normals of the file.</summary>
        EdgesByNormals = 42,
        /// <summary>
        /// Coarse faces were divided [times, vertices moved, places between them raised, off a round surface; shares
        /// of the diagonal].
        /// </summary>
        Divided = 43,
        /// <summary>Faces are coarse, but nothing round goes through them.</summary>
        CoarseFlat = 44,
        /// <summary>Parts that cross are surfaces of their own [parts, groups].</summary>
        Groups = 45,
        /// <summary>
        /// The tolerance was not reached [tolerance, share of the mesh, share of the surface, farthest; of the
        /// diagonal].
        /// </summary>
        NotReached = 46,
        /// <summary>Edges that could not be cut are smooth [their length in diagonals].</summary>
        EdgesStaySmooth = 47,
        /// <summary>The surface is off a share of the mesh [share, farthest].</summary>
        OffMesh = 48,
        /// <summary>Parts of surface that the mesh does not have were left out [parts].</summary>
        MadeByFit = 49,
        /// <summary>The tolerance is too large for parts of a mesh.</summary>
        PartsTooThin = 50,
        /// <summary>There are fewer marks than fill the darkest tone [wanted, made].</summary>
        MarksLimited = 51,
        /// <summary>There are fewer levels of the published recursion than wanted [wanted, taken].</summary>
        LevelsLimited = 52,
        /// <summary>The picture is seen from the depth camera's side [azimuth].</summary>
        SeenFromCamera = 53,
        /// <summary>The picture is seen from the front of an open surface [azimuth].</summary>
        SeenFromFront = 54,
        /// <summary>Lines need a model, and the source is a point set.</summary>
        NoLinesOfMarks = 55,
        /// <summary>
        /// The surface is thinner than the cells that lines are looked for in [triangles turned, of, samples
        /// missed].
        /// </summary>
        LinesThin = 56,
        /// <summary>Lines show where the surface ends beyond its samples [borders, support, share].</summary>
        LinesEnd = 57,
        /// <summary>Curves end inside the surface [curves].</summary>
        LinesBroken = 58,
        /// <summary>The visibility of lines contradicts itself [lines].</summary>
        LinesDoubted = 59,
        /// <summary>Places have too many crossings of lines [places].</summary>
        LinesTangled = 60,
        /// <summary>Hardly anything can be seen [shown, marks, share of ink].</summary>
        Blank = 61,
        /// <summary>Pens were chosen by the widths at hand.</summary>
        Pens = 62,
        /// <summary>What a plotter does [metres drawn, metres travelled, seconds].</summary>
        Plotted = 63,
        /// <summary>Settings do not hold all of it.</summary>
        NotInSettings = 64,
        /// <summary>The unit of the format is the metre.</summary>
        UnitIsMetre = 65,
        /// <summary>There is no symmetry for centre lines.</summary>
        NoSymmetry = 66,
        /// <summary>Outlines of a cut are not closed [outlines].</summary>
        SectionOpen = 67,
        /// <summary>Normals were not of length 1, and were made so [normals].</summary>
        NormalsNotUnit = 68,
        /// <summary>All points are at one place.</summary>
        AtOnePlace = 69,
        /// <summary>The source is far from the origin for its size.</summary>
        FarFromOrigin = 70,
        /// <summary>Vertices at the place of another were joined with it [vertices].</summary>
        VerticesJoined = 71,
        /// <summary>Vertices of no face were left out [vertices].</summary>
        VerticesUnused = 72,
        /// <summary>Edges have more than two faces [edges].</summary>
        NonmanifoldEdges = 73,
        /// <summary>The mesh has borders [borders, their edges].</summary>
        MeshOpen = 74,
        /// <summary>The mesh has several parts [parts].</summary>
        SeveralParts = 75,
        /// <summary>Why a source cannot be drawn.</summary>
        NotUsable = 76,
    }

    /// <summary>Where views stand on a sheet [ISO 5456-2].</summary>
    [NativeConstants("HRBFNPR_VIEWS_ANGLE_")]
    public enum ProjectionAngle
    {
        /// <summary>First angle: the left view at the right, the top view below (default).</summary>
        First = 0,
        /// <summary>Third angle: the left view at the left, the top view above.</summary>
        Third = 1,
    }

    /// <summary>How hidden edges of views are drawn.  Sections never have any [ISO 128-3].</summary>
    [NativeConstants("HRBFNPR_VIEWS_HIDDEN_")]
    public enum HiddenEdges
    {
        /// <summary>As dashed thin lines (default).</summary>
        Dashed = 0,
        /// <summary>They are not drawn.</summary>
        None = 1,
        /// <summary>As continuous thin lines.</summary>
        Shown = 2,
    }
}
