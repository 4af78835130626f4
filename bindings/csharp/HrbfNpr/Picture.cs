// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// A drawing of any source in one call.  It chooses what a user leaves open, from repairs of the data to camera,
    /// pen, marks and lines, and tells its choices in its notes.
    /// </summary>
    /// <remarks>
    /// <para>A picture is made by the calls of the other classes, and each of its parts can be taken out for these
    /// calls.</para>
    /// <para>A plate is a drawing with the section and the scale bar beside it.  Without these it is the drawing
    /// alone.</para>
    /// <para>Calls of several threads to one picture wait for each other.  Progress is from 0 to 1 and is reported on
    /// the calling thread; it never falls within a call.  Besides the exceptions that a method names, it may throw
    /// <see cref="CancelledException"/>, <see cref="CallbackException"/>, <see cref="NativeOutOfMemoryException"/> and
    /// <see cref="ObjectDisposedException"/>.</para>
    /// </remarks>
    /// <example>
    /// <code>
    /// var options = new PictureOptions { Preset = Preset.Engraving, Width = 800, Height = 600 };
    /// using (Picture picture = Picture.Draw(PictureSource.FromPoints(points, normals), options))
    /// {
    ///     byte[] rgba = picture.Rasterize();
    ///     picture.WriteSvg("drawing.svg");
    /// }
    /// </code>
    /// </example>
    public sealed unsafe partial class Picture : IDisposable
    {
        private const double DrawingBegins = 0.9; // progress of Draw at which the drawing begins
        private readonly object gate = new object();
        private readonly PictureHandle handle;
        private readonly PictureState state;
        private readonly PictureOrigins origins;
        private Drawing drawing;
        private bool working;

        private Picture(PictureHandle handle, PictureState state, PictureOrigins origins)
        {
            this.handle = handle;
            this.state = state;
            this.origins = origins;
        }

        /// <summary>Counts, sizes and times of the picture.</summary>
        public PictureInfo Info
        {
            get
            {
                PictureInfo info;
                Errors.Check(NativeMethods.hrbfnpr_picture_info_init(&info, (uint)sizeof(PictureInfo)));
                hrbfnpr_error error = Errors.New();
                lock (gate)
                {
                    Errors.Check(NativeMethods.hrbfnpr_picture_get_info(handle, &info, &error), &error);
                }
                return info;
            }
        }

        /// <summary>The notes on choices, repairs, measurements and possible faults, in the order of time; a new list.</summary>
        public IReadOnlyList<Note> Notes
        {
            get
            {
                lock (gate)
                {
                    var notes = new Note[Info.Notes];
                    for (int i = 0; i < notes.Length; ++i)
                    {
                        hrbfnpr_note note;
                        Errors.Check(NativeMethods.hrbfnpr_note_init(&note, (uint)sizeof(hrbfnpr_note)));
                        hrbfnpr_error error = Errors.New();
                        Errors.Check(NativeMethods.hrbfnpr_picture_get_note(handle, i, &note, &error), &error);
                        notes[i] = new Note(&note);
                    }
                    GC.KeepAlive(this);
                    return new ReadOnlyCollection<Note>(notes);
                }
            }
        }

        /// <summary>The stages that have ended, each as its last event; a new list.</summary>
        public IReadOnlyList<PictureEvent> Stages
        {
            get
            {
                lock (gate)
                {
                    var stages = new PictureEvent[Info.Stages];
                    for (int i = 0; i < stages.Length; ++i)
                    {
                        hrbfnpr_picture_event stage;
                        Errors.Check(
                            NativeMethods.hrbfnpr_picture_event_init(&stage, (uint)sizeof(hrbfnpr_picture_event)));
                        hrbfnpr_error error = Errors.New();
                        Errors.Check(NativeMethods.hrbfnpr_picture_get_stage(handle, i, &stage, &error), &error);
                        stages[i] = new PictureEvent(&stage);
                    }
                    GC.KeepAlive(this);
                    return new ReadOnlyCollection<PictureEvent>(stages);
                }
            }
        }

        /// <summary>The surfaces with their marks and lines, the largest first; new objects each time.</summary>
        public IReadOnlyList<PicturePart> Parts
        {
            get
            {
                lock (gate)
                {
                    var parts = new PicturePart[Info.Parts];
                    for (int i = 0; i < parts.Length; ++i)
                    {
                        hrbfnpr_picture_part part;
                        Errors.Check(
                            NativeMethods.hrbfnpr_picture_part_init(&part, (uint)sizeof(hrbfnpr_picture_part)));
                        hrbfnpr_error error = Errors.New();
                        Errors.Check(NativeMethods.hrbfnpr_picture_get_part(handle, i, &part, &error), &error);
                        parts[i] = origins.Part(&part, handle.Anchor);
                    }
                    GC.KeepAlive(this); // the library's structs belong to the picture
                    return new ReadOnlyCollection<PicturePart>(parts);
                }
            }
        }

        /// <summary>The style that was chosen, for <see cref="Renderer"/>; a copy.</summary>
        /// <remarks>Use the style of a painted picture only until the picture is disposed of.</remarks>
        /// <exception cref="InvalidArgumentException">The picture was made with SurfaceOnly.</exception>
        public Style Style
        {
            get
            {
                lock (gate)
                {
                    hrbfnpr_style* style;
                    hrbfnpr_error error = Errors.New();
                    Errors.Check(NativeMethods.hrbfnpr_picture_get_style(handle, &style, &error), &error);
                    var copy = new Style(style, handle);
                    GC.KeepAlive(this);
                    return copy;
                }
            }
        }

        /// <summary>
        /// The options with which marks were placed, for <see cref="Model.Generate"/>; a copy; null if the caller gave
        /// the marks.
        /// </summary>
        /// <remarks>Use those of a painted picture only until the picture is disposed of.</remarks>
        /// <exception cref="InvalidArgumentException">The picture was made with SurfaceOnly.</exception>
        public GenerateOptions Marks
        {
            get
            {
                lock (gate)
                {
                    hrbfnpr_generate_desc* marks;
                    hrbfnpr_error error = Errors.New();
                    Errors.Check(NativeMethods.hrbfnpr_picture_get_marks(handle, &marks, &error), &error);
                    GenerateOptions copy = marks == null ? null : GenerateOptions.Read(marks, handle);
                    GC.KeepAlive(this);
                    return copy;
                }
            }
        }

        /// <summary>The camera that was chosen.</summary>
        /// <exception cref="InvalidArgumentException">The picture was made with SurfaceOnly.</exception>
        public Camera Camera
        {
            get
            {
                hrbfnpr_camera camera = NewCamera();
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_picture_get_camera(handle, &camera, &error), &error);
                return new Camera(camera);
            }
        }

        /// <summary>
        /// The drawing for <see cref="Camera"/>, which is made when it is first read.  It belongs to the picture, which
        /// disposes of it.
        /// </summary>
        /// <exception cref="InvalidArgumentException">Hardly anything can be seen, and the message says why; or the
        /// picture was made with SurfaceOnly.</exception>
        public Drawing Drawing
        {
            get { return DrawOnce(null, default(CancellationToken)); }
        }

        /// <summary>Makes a picture of one source, and draws it.</summary>
        /// <param name="source">The source.  A model or a point set converts implicitly.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, the source cannot be drawn, or
        /// hardly anything can be seen; the message says why.</exception>
        /// <exception cref="SingularSystemException">The linear system has no numerically unique solution.</exception>
        /// <exception cref="NotConvergedException">The iterative solver did not reach its tolerance; the message gives
        /// the residual.</exception>
        public static Picture Draw(
            PictureSource source, PictureOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Draw(new[] { source }, options, context, progress, cancellationToken);
        }

        /// <summary>Makes a picture of several sources, each a separate surface, and draws it.</summary>
        /// <param name="sources">One or more sources.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        public static Picture Draw(
            IReadOnlyList<PictureSource> sources, PictureOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            Picture picture = Create(
                sources, options, context, Share.Of(progress, 0, DrawingBegins), cancellationToken);
            try
            {
                picture.DrawOnce(Share.Of(progress, DrawingBegins, 1), cancellationToken);
                return picture;
            }
            catch
            {
                picture.Dispose();
                throw;
            }
        }

        /// <summary>
        /// Makes a picture of one source: fits a surface, places marks and finds lines.  It draws nothing yet.
        /// </summary>
        /// <param name="source">The source.  A model or a point set converts implicitly.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or the source cannot be drawn; the
        /// message says why.</exception>
        /// <exception cref="SingularSystemException">The linear system has no numerically unique solution.</exception>
        /// <exception cref="NotConvergedException">The iterative solver did not reach its tolerance; the message gives
        /// the residual.</exception>
        public static Picture Create(
            PictureSource source, PictureOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Create(new[] { source }, options, context, progress, cancellationToken);
        }

        /// <summary>Makes a picture of several sources, each a separate surface.  It draws nothing yet.</summary>
        /// <param name="sources">One or more sources.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        public static Picture Create(
            IReadOnlyList<PictureSource> sources, PictureOptions options = null, Context context = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            context = Context.Resolve(context);
            var origins = new PictureOrigins(sources);
            using (var described = new PictureCall(sources, options, origins))
            using (var call = new LongCall(
                context.Handle, progress, cancellationToken, described.State.IsWatched))
            {
                described.State.Begin(call.Operation);
                hrbfnpr_error error = Errors.New();
                hrbfnpr_picture_desc desc = described.Desc;
                int status = NativeMethods.hrbfnpr_picture_create(
                    context.Handle, &desc, call.Operation, out IntPtr created, &error);
                return Finish(created, context.Anchor, described, origins, call, status, &error);
            }
        }

        /// <summary>
        /// Makes a picture of the same surfaces in another style, size or view.  It draws nothing yet.  Marks and lines
        /// that fit are used again.
        /// </summary>
        /// <param name="options">The options; null = all defaults.  The options of this picture are not used.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>Another picture, which does not need this one to stay alive.</returns>
        /// <exception cref="InvalidArgumentException">An option is out of its range, or this picture was made with
        /// SurfaceOnly.</exception>
        public Picture Restyle(
            PictureOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            using (var root = new HeldHandles())
            using (var described = new PictureCall(null, options, origins))
            using (var call = new LongCall(handle, progress, cancellationToken, described.State.IsWatched))
            {
                root.Hold(handle); // with everything that it keeps alive
                described.State.Begin(call.Operation);
                hrbfnpr_error error = Errors.New();
                hrbfnpr_picture_desc desc = described.Desc;
                int status = NativeMethods.hrbfnpr_picture_restyle(
                    handle, &desc, call.Operation, out IntPtr created, &error);
                return Finish(created, handle.Anchor, described, origins, call, status, &error);
            }
        }

        /// <summary>Draws the picture.  Lines keep their numbers from one drawing to the next.</summary>
        /// <param name="camera">The camera; null = <see cref="Camera"/>.  Only then is it an error if hardly anything
        /// can be seen.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <returns>A drawing.  If it is disposed of before the next but one is made, its memory is used
        /// again.</returns>
        /// <exception cref="InvalidArgumentException">Hardly anything can be seen, and the message says why; the camera
        /// has no viewport; or the picture was made with SurfaceOnly.</exception>
        public Drawing Draw(
            Camera camera = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            return Work(progress, cancellationToken, call =>
            {
                Camera seen = camera ?? Camera;
                hrbfnpr_camera view = seen.Native;
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_picture_draw(
                    handle, camera == null ? null : &view, call.Operation, out IntPtr created, &error);
                var made = new DrawingHandle();
                made.Take(created, handle.Anchor);
                try
                {
                    state.Check(call, status, &error);
                    return new Drawing(made, seen);
                }
                catch
                {
                    made.Dispose();
                    throw;
                }
            });
        }

        /// <summary>
        /// Makes a camera that looks from another side, with the size, the lens and the margin of the picture.
        /// </summary>
        /// <param name="direction">The direction from the eye into the scene.</param>
        /// <exception cref="InvalidArgumentException">The direction is not finite, or the picture was made with
        /// SurfaceOnly.</exception>
        public Camera Look(Vector3d direction)
        {
            return Look(&direction, double.NaN, double.NaN);
        }

        /// <summary>
        /// Makes a camera that looks from another side, with the size, the lens and the margin of the picture.
        /// </summary>
        /// <param name="azimuth">The azimuth about the up axis, in degrees; null = as planned.</param>
        /// <param name="elevation">The elevation above the horizon, in degrees; null = as planned.</param>
        /// <exception cref="InvalidArgumentException">The picture was made with SurfaceOnly.</exception>
        public Camera Look(double? azimuth = null, double? elevation = null)
        {
            return Look(null, azimuth ?? double.NaN, elevation ?? double.NaN);
        }

        /// <summary>
        /// Returns <see cref="Camera"/>, turned about the up axis through the middle of the model.  If
        /// <see cref="PictureOptions.Eye"/> was given, the axis goes through its target.
        /// </summary>
        /// <param name="degrees">The angle in degrees.</param>
        /// <exception cref="InvalidArgumentException">The picture was made with SurfaceOnly.</exception>
        public Camera Orbit(double degrees)
        {
            hrbfnpr_camera camera = NewCamera();
            hrbfnpr_error error = Errors.New();
            Errors.Check(NativeMethods.hrbfnpr_picture_orbit(handle, degrees, &camera, &error), &error);
            return new Camera(camera);
        }

        /// <summary>
        /// Releases the picture and its <see cref="Drawing"/>.  Other drawings and the parts stay alive.
        /// </summary>
        public void Dispose()
        {
            lock (gate)
            {
                CheckIdle();
                if (drawing != null)
                {
                    drawing.Dispose();
                }
                handle.Dispose();
            }
        }

        private static hrbfnpr_camera NewCamera()
        {
            hrbfnpr_camera camera;
            Errors.Check(NativeMethods.hrbfnpr_camera_init(&camera, (uint)sizeof(hrbfnpr_camera)));
            return camera;
        }

        private static Picture Finish(
            IntPtr created, ContextAnchor anchor, PictureCall described, PictureOrigins origins, LongCall call,
            int status, hrbfnpr_error* error)
        {
            var made = new PictureHandle();
            if (created != IntPtr.Zero)
            {
                made.Take(created, anchor);
                described.GiveTo(made, origins);
            }
            try
            {
                described.State.Check(call, status, error);
                return new Picture(made, described.State, origins);
            }
            catch
            {
                made.Dispose();
                throw;
            }
        }

        private Camera Look(Vector3d* direction, double azimuth, double elevation)
        {
            hrbfnpr_camera camera = NewCamera();
            hrbfnpr_error error = Errors.New();
            Errors.Check(
                NativeMethods.hrbfnpr_picture_look(
                    handle, (double*)direction, azimuth, elevation, &camera, &error),
                &error);
            return new Camera(camera);
        }

        private Drawing DrawOnce(IProgress<double> progress, CancellationToken token)
        {
            lock (gate)
            {
                return drawing ?? (drawing = Draw(null, progress, token));
            }
        }

        /// <summary>
        /// Refuses a call from a function that the picture runs: such a function may read the picture only.
        /// </summary>
        private void CheckIdle()
        {
            if (working)
            {
                throw new InvalidOperationException("the picture is busy; a function that it calls cannot use it");
            }
        }

        /// <summary>Runs a call that changes the picture, one at a time.</summary>
        private T Work<T>(IProgress<double> progress, CancellationToken token, Func<LongCall, T> function)
        {
            lock (gate)
            {
                CheckIdle();
                using (var call = new LongCall(handle, progress, token, state.IsWatched))
                {
                    working = true;
                    state.Begin(call.Operation);
                    try
                    {
                        return function(call);
                    }
                    finally
                    {
                        working = false;
                    }
                }
            }
        }

        /// <summary>The progress of one of several calls.</summary>
        private sealed class Share : IProgress<double>
        {
            private readonly IProgress<double> whole;
            private readonly double begin;
            private readonly double end;

            private Share(IProgress<double> whole, double begin, double end)
            {
                this.whole = whole;
                this.begin = begin;
                this.end = end;
            }

            void IProgress<double>.Report(double value)
            {
                whole.Report(begin + (end - begin) * value);
            }

            /// <summary>Makes the progress of one call; null for null.</summary>
            internal static Share Of(IProgress<double> whole, double begin, double end)
            {
                return whole == null ? null : new Share(whole, begin, end);
            }
        }
    }

    /// <summary>The models and marks that a picture, and pictures of the same surfaces, were made of.</summary>
    internal sealed unsafe class PictureOrigins
    {
        private readonly Dictionary<IntPtr, ContextAnchor> anchors = new Dictionary<IntPtr, ContextAnchor>();
        private readonly Dictionary<IntPtr, FunctionState> functions = new Dictionary<IntPtr, FunctionState>();

        internal PictureOrigins(IReadOnlyList<PictureSource> sources)
        {
            if (sources == null)
            {
                throw new ArgumentNullException(nameof(sources));
            }
            for (int i = 0; i < sources.Count; ++i)
            {
                PictureSource source = sources[i] ?? throw new ArgumentNullException(nameof(sources));
                if (source.Model != null)
                {
                    Functions = FunctionState.Both(Functions, source.Model.Function);
                    functions[source.Model.Handle.DangerousGetHandle()] = source.Model.Function;
                    Add(source.Model.Handle);
                }
                if (source.PointSet != null)
                {
                    Add(source.PointSet.Handle);
                }
            }
        }

        /// <summary>The functions of all models; null if no model is from a function.</summary>
        internal FunctionState Functions { get; }

        /// <summary>The contexts of all sources, which may differ from the picture's.</summary>
        internal IEnumerable<ContextAnchor> Anchors
        {
            get { return anchors.Values; }
        }

        /// <summary>Makes one part, with new references to its objects.</summary>
        internal PicturePart Part(hrbfnpr_picture_part* part, ContextAnchor anchor)
        {
            Model model = null;
            FunctionState function = null;
            if (part->model != IntPtr.Zero)
            {
                functions.TryGetValue(part->model, out function);
                model = new Model(ModelHandle.Of(part->model, AnchorOf(part->model, anchor)), function);
            }
            PointSet marks = part->point_set == IntPtr.Zero ? null
                : new PointSet(PointSetHandle.Of(part->point_set, AnchorOf(part->point_set, anchor)));
            LineSet lines = part->line_set == IntPtr.Zero ? null
                : new LineSet(LineSetHandle.Of(part->line_set, anchor), function);
            TriangleMesh mesh = part->mesh == IntPtr.Zero ? null : new TriangleMesh(MeshHandle.Of(part->mesh, anchor));
            return new PicturePart(model, marks, lines, mesh, (Sides)part->sides);
        }

        private void Add(NativeHandle handle)
        {
            if (handle.IsClosed || handle.Anchor == null)
            {
                throw new ObjectDisposedException("a source of the picture");
            }
            anchors[handle.DangerousGetHandle()] = handle.Anchor;
        }

        private ContextAnchor AnchorOf(IntPtr given, ContextAnchor otherwise)
        {
            return anchors.TryGetValue(given, out ContextAnchor found) ? found : otherwise;
        }
    }
}
