// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Xunit;

namespace HrbfNpr.Tests
{
    public class PictureTest : IDisposable
    {
        private const int Width = 64;
        private const int Height = 48;
        private readonly double[] points = Shapes.Sphere(60);
        private readonly double[] normals;
        private readonly Picture picture;

        public PictureTest()
        {
            normals = points;
            picture = Picture.Draw(PictureSource.FromPoints(points, normals), Small());
        }

        public void Dispose()
        {
            picture.Dispose();
        }

        [Fact]
        public void OneCallDrawsAnImage()
        {
            byte[] rgba = picture.Rasterize();
            Assert.Equal(Width * Height * 4, rgba.Length);
            Assert.InRange(Dark(rgba), 100, Width * Height / 2);
            PictureInfo info = picture.Info;
            Assert.Equal(Width, info.Width);
            Assert.Equal(Height, info.Height);
            Assert.Equal(Preset.ContourAndStipple, info.Preset);
            Assert.Equal(1L, info.Parts);
            Assert.Equal(0.75, info.Pen);
            Assert.True(info.Marks > 100 && info.Seconds > 0);
            Assert.Equal(new Vector3d(0, 1, 0), info.Up);
            Assert.Equal(-1, info.BoundsMin.X, 0.05);
            Assert.Equal(1, info.BoundsMax.Z, 0.05);
        }

        /// <summary>The separate calls give the same picture, byte for byte.</summary>
        [Fact]
        public void TheCallsStepByStepDrawTheSamePicture()
        {
            foreach (Preset preset in new[] { Preset.Stipple, Preset.ContourAndStipple, Preset.Xray })
            {
                PictureOptions options = Small(preset);
                options.KeepMarks = true;
                using (Picture whole = Picture.Draw(PictureSource.FromPoints(points, normals), options))
                using (var renderer = new Renderer())
                {
                    PicturePart part = whole.Parts.Single();
                    PointSet marks = part.Model.Generate(whole.Marks);
                    Assert.Equal(part.PointSet.Count, marks.Count);
                    Assert.Equal(part.PointSet.Layers[0].Positions(), marks.Layers[0].Positions());
                    var item = new Item(marks, whole.Style) { LineSet = part.LineSet, Sides = part.Sides };
                    Assert.Equal(whole.Rasterize(), Shapes.Draw(renderer, item, whole.Camera));
                    Assert.Null(part.Mesh);
                }
            }
        }

        [Fact]
        public void ModelsAndMarksAreSources()
        {
            using (Model model = Model.Fit((ArrayView)points, (ArrayView)normals))
            using (PointSet marks = Shapes.Stipple(model, 1000))
            {
                using (Picture drawn = Picture.Draw(model, Small()))
                {
                    Assert.InRange(Dark(drawn.Rasterize()), 100, Width * Height / 2);
                    Assert.Equal(model.Info.Centres, drawn.Parts[0].Model.Info.Centres);
                }
                PictureOptions stippled = Small(Preset.ContourAndStipple);
                using (Picture drawn = Picture.Draw(PictureSource.FromModel(model, marks), stippled))
                {
                    Assert.Equal(marks.Count, drawn.Info.Marks);
                    Assert.Null(drawn.Marks);
                    Assert.True(drawn.Parts[0].LineSet.Info.Triangles > 100);
                }
                using (Picture drawn = Picture.Draw(marks, stippled))
                {
                    Assert.Equal(marks.Count, drawn.Info.Marks);
                    Assert.Null(drawn.Parts[0].Model);
                    Assert.Null(drawn.Parts[0].LineSet);
                }
                Picture far;
                using (Model ball = Csg.Sphere(0.5, (0, 0, 3)))
                {
                    far = Picture.Create(new PictureSource[] { model, ball }, stippled);
                }
                using (far) // the picture keeps its models
                {
                    Assert.Equal(2L, far.Info.Parts);
                    Assert.Equal(3.5, far.Info.BoundsMax.Z, 0.01);
                    Assert.Equal(far.Info.Marks, far.Parts.Sum(part => part.PointSet.Count));
                    Assert.True(Dark(far.Rasterize()) > 100);
                }
            }
        }

        [Fact]
        public void MeshesAreSources()
        {
            Shapes.Cube(out double[] vertices, out int[] triangles);
            PictureOptions options = Small(Preset.Silhouette);
            PictureSource source = PictureSource.FromMesh(vertices, triangles);
            source.Name = "cube.obj";
            using (Picture cube = Picture.Create(source, options))
            {
                PicturePart part = cube.Parts.Single();
                Assert.Equal(12L, part.Mesh.Info.Faces);
                Assert.True(part.Mesh.Info.Closed);
                Assert.True(part.LineSet.Info.Creases > 0);
                Assert.Equal(1.0, part.Mesh.Info.Volume, 1e-9);
                MeshComparison near = part.Model.Compare(part.Mesh);
                Assert.InRange(near.SurfaceMax, 0, 0.01);
                Assert.InRange(Dark(cube.Rasterize()), 50, Width * Height / 2);
                Assert.Contains("cube.obj", PictureOutputTest.Text(cube, null));
            }
            options.Edges = PictureEdges.Smooth;
            using (Picture smooth = Picture.Create(PictureSource.FromMesh(vertices, triangles), options))
            {
                Assert.Equal(0L, smooth.Parts[0].LineSet.Info.Creases);
            }
            Assert.Throws<ArgumentNullException>(() => PictureSource.FromMesh(vertices, default(ArrayView)));
            triangles[0] = 8;
            InvalidArgumentException wrong = Assert.Throws<InvalidArgumentException>(
                () => Picture.Create(PictureSource.FromMesh(vertices, triangles)));
            Assert.Contains("vertex 8", wrong.Message);
        }

        [Fact]
        public void ASourceIsInspected()
        {
            SourceInfo info = PictureSource.FromPoints(points, normals).Inspect(out IReadOnlyList<Note> notes);
            Assert.Equal(SourceKind.Points, info.Kind);
            Assert.Equal(60L, info.Points);
            Assert.Equal(NormalsLook.Outward, info.NormalsLook);
            Assert.True(info.HasNormals && !info.AlongCurves);
            Assert.Equal(1.0, info.NormalsUnitShare);
            Assert.Equal(0, notes.Count(one => one.Severity == Severity.Failure));
            Shapes.Cube(out double[] vertices, out int[] triangles);
            PictureSource mesh = PictureSource.FromMesh(vertices, triangles);
            mesh.Up = (0, 0, 1);
            mesh.UpBy = "STL files";
            info = mesh.Inspect();
            Assert.Equal(SourceKind.Mesh, info.Kind);
            Assert.Equal(12L, info.Triangles);
            Assert.True(info.Closed && !info.InsideOut);
            Assert.Equal(1.0, info.Volume, 1e-12);
            Assert.Equal(6.0, info.Area, 1e-12);
            Assert.Equal(new Vector3d(0, 0, 1), info.Up);
            Assert.Contains("STL files", info.UpReason);
            Array.Resize(ref triangles, 33); // removes a face
            info = PictureSource.FromMesh(vertices, triangles).Inspect(out notes);
            Assert.Equal(3L, info.BoundaryEdges);
            Note open = notes.Single(one => one.Code == NoteCode.MeshOpen);
            Assert.Equal(new double[] { 1, 3 }, open.Figures.ToArray());
            Assert.Contains("small holes are closed", open.Advice);
            Assert.Contains("drawn as a line", open.Detail);
            info = PictureSource.FromPoints(new[] { double.NaN, 0, 0 }).Inspect(out notes);
            Assert.Equal(1L, info.PointsNotFinite);
            Assert.Equal(Severity.Failure, info.Severity);
            Assert.Equal(NoteCode.NotUsable, notes.Last().Code);
            using (var source = new CancellationTokenSource())
            {
                source.Cancel();
                Cancelled(() => mesh.Inspect(out notes, cancellationToken: source.Token));
            }
        }

        [Fact]
        public void NotesSayWhatWasChosen()
        {
            var happened = new List<PictureEvent>();
            PictureOptions options = Small();
            options.OnEvent = happened.Add;
            using (Picture made = Picture.Draw(PictureSource.FromPoints(points), options))
            {
                Note note = made.Notes.Single(one => one.Code == NoteCode.NormalsMade);
                Assert.Equal(Severity.Note, note.Severity);
                Assert.Equal((double)(points.Length / 3), note.Figures.Single());
                Assert.Contains("normals", note.Text);
                Assert.Equal(note.Text, note.ToString());
                Assert.True(note.Advice == null && note.Detail == null);
                Assert.Equal(made.Notes.Select(one => one.Text).ToArray(),
                    happened.Where(one => one.Note != null).Select(one => one.Note.Text).ToArray());
                Stage[] stages = made.Stages.Select(one => one.Stage).ToArray();
                Assert.Equal(Stage.Orient, stages[0]);
                Assert.Equal(Stage.Frame, stages.Last());
                Assert.True(stages.Contains(Stage.Fit) && stages.Contains(Stage.Marks) && stages.Contains(Stage.Lines));
                Assert.Equal(stages, happened.Where(one => one.Fraction == 1).Select(one => one.Stage).ToArray());
                Assert.True(made.Stages.All(one => one.Fraction == 1 && one.Says != null && one.Seconds >= 0));
                PictureEvent begins = happened.First(one => one.Stage == Stage.Marks);
                Assert.Equal("place marks", begins.Name);
                Assert.Equal("placing marks", begins.Doing);
                Assert.Equal(0.0, begins.Fraction);
                Assert.Null(begins.Says);
                int before = happened.Count;
                made.Draw(made.Orbit(30)).Dispose(); // events are reported for later calls, too
                // Another camera needs other marks, so all are placed.
                Assert.Equal(new[] { Stage.Marks, Stage.Frame }, happened.Skip(before).Select(one => one.Stage).Distinct().ToArray());
                before = happened.Count;
                made.Draw(made.Orbit(60)).Dispose();
                Assert.True(happened.Skip(before).All(one => one.Stage == Stage.Frame) && happened.Count > before);
            }
        }

        [Fact]
        public void ChangesAndOwnStylesAreApplied()
        {
            byte[] plain = picture.Rasterize();
            PictureOptions options = Small();
            options.Set("style.ink", "#ff0000").Set("style.halo_width", 2);
            using (Picture red = Picture.Draw(PictureSource.FromPoints(points, normals), options))
            {
                Assert.Equal(new Color(1, 0, 0), red.Style.Layers[0].Ink);
                Assert.Equal(2f, red.Style.HaloWidth);
                Assert.NotEqual(plain, red.Rasterize());
            }
            options.Changes.Clear();
            options.Changes.Add(new Change("style.no_such_field", "1"));
            Assert.Contains("no_such_field", Assert.Throws<InvalidArgumentException>(
                () => Picture.Create(PictureSource.FromPoints(points, normals), options)).Message);
            options.Changes.Clear();
            options.Preset = Preset.Etching;
            options.StyleName = "contour-and-stipple"; // StyleName overrides Preset
            using (Picture named = Picture.Draw(PictureSource.FromPoints(points, normals), options))
            {
                Assert.Equal(plain, named.Rasterize());
            }
            options = Small();
            options.Style = picture.Style;
            using (Picture same = Picture.Draw(PictureSource.FromPoints(points, normals), options))
            {
                Assert.Equal(plain, same.Rasterize());
            }
        }

        [Fact]
        public void ToneFunctionsAndPaintAreApplied()
        {
            PictureOptions options = Small(Preset.Stipple);
            options.Style = Style.Preset(Preset.Stipple);
            options.Style.Tone = Tone.Callback;
            options.Style.ToneFunction = (positions, directions, tau) =>
            {
                for (int i = 0; i < tau.Length; ++i)
                {
                    tau[i] = positions[3 * i] > 0 ? 1 : 0; // light on the right side of the model
                }
            };
            PictureSource source = PictureSource.FromPoints(points, normals);
            using (Picture half = Picture.Draw(source, options))
            using (var renderer = new Renderer())
            {
                PicturePart part = half.Parts[0];
                byte[] expected = half.Rasterize();
                Style style = half.Style;
                Assert.Same(options.Style.ToneFunction, style.ToneFunction);
                var item = new Item(part.PointSet, style) { LineSet = part.LineSet, Sides = part.Sides };
                Assert.Equal(expected, Shapes.Draw(renderer, item, half.Camera));
                var own = new InvalidOperationException("my own");
                options.Style.ToneFunction = (positions, directions, tau) => { throw own; };
                using (Picture bad = Picture.Create(source, options))
                {
                    Assert.Same(own, Assert.Throws<CallbackException>(() => bad.Draw()).InnerException);
                }
            }
            options.Style = null;
            byte[] plain = Draw(source, options);
            options.Dabs.Add(new Dab { Position = (0, 0, 1), Normal = (0, 0, 1), Radius = 1, Value = 0 });
            using (Picture painted = Picture.Draw(source, options))
            using (var renderer = new Renderer())
            {
                byte[] expected = painted.Rasterize();
                Assert.True(Dark(expected) > Dark(plain));
                Style style = painted.Style.Clone();
                PicturePart part = painted.Parts[0];
                var item = new Item(part.PointSet, style) { LineSet = part.LineSet, Sides = part.Sides };
                Assert.Equal(expected, Shapes.Draw(renderer, item, painted.Camera));
                PictureOptions other = Small(Preset.Stipple);
                other.Style = style;
                Assert.Contains("paint.tone", Assert.Throws<InvalidArgumentException>(
                    () => Picture.Create(source, other)).Message);
            }
            options.Dabs[0].Map = DabMap.Density;
            using (Picture painted = Picture.Create(source, options))
            using (PointSet again = painted.Parts[0].Model.Generate(painted.Marks))
            {
                Assert.Equal(painted.Parts[0].PointSet.Layers[0].Positions(), again.Layers[0].Positions());
            }
        }

        [Fact]
        public void ARestyledPictureHasTheSameSurfaces()
        {
            Picture first = Picture.Create(PictureSource.FromPoints(points, normals), Small());
            PictureOptions options = Small(Preset.Silhouette);
            options.Azimuth = 70;
            Picture second = first.Restyle(options);
            Picture third = second.Restyle(Small());
            first.Dispose(); // the objects that it made stay valid
            using (third)
            {
                using (second)
                {
                    Assert.Equal(Preset.Silhouette, second.Info.Preset);
                    Assert.False(second.Stages.Any(one => one.Stage == Stage.Fit));
                    Assert.Equal(Draw(PictureSource.FromPoints(points, normals), options), second.Rasterize());
                }
                Assert.Equal(0, third.Stages.Count(one => one.Stage == Stage.Marks)); // the marks of the first picture are used
                Assert.Equal(picture.Rasterize(), third.Rasterize());
            }
            Assert.Throws<ObjectDisposedException>(() => first.Restyle());
        }

        [Fact]
        public void CamerasLookFromAllSides()
        {
            Camera camera = picture.Camera;
            Assert.Equal(camera.View, picture.Orbit(0).View);
            Assert.Equal(camera.View, picture.Look(30, 20).View);
            Assert.Equal(camera.View, picture.Look().View);
            Assert.Equal(picture.Look(azimuth: 75).View, picture.Look(75, 20).View);
            double[] front = picture.Look((0, 0, -1)).View;
            Assert.Equal(new double[] { 1, 0, 0, 0, 1, 0, 0, 0, 1 },
                new[] { front[0], front[1], front[2], front[4], front[5], front[6], front[8], front[9], front[10] });
            Camera turned = picture.Orbit(180);
            using (Drawing drawing = picture.Draw(turned))
            {
                Assert.Same(turned, drawing.Camera);
                Assert.Equal(drawing.Rasterize(), picture.Rasterize(drawing));
                Assert.NotEqual(picture.Rasterize(), picture.Rasterize(drawing));
            }
            Assert.Throws<InvalidArgumentException>(() => picture.Orbit(double.NaN));
            Assert.Throws<InvalidArgumentException>(() => picture.Look((0, double.PositiveInfinity, 0)));
            PictureOptions options = Small();
            options.Camera = turned;
            options.Width = options.Height = 0;
            using (Picture own = Picture.Create(PictureSource.FromPoints(points, normals), options))
            {
                Assert.Equal(turned.View, own.Camera.View);
                Assert.Equal(turned.Projection, own.Camera.Projection);
            }
            options.Camera = null;
            options.Eye = (0, 0, 5);
            options.Target = (0.1, 0, 0);
            options.Fov = 40;
            using (Picture eye = Picture.Create(PictureSource.FromPoints(points, normals), options))
            {
                Assert.Equal(-5, eye.Camera.View[14], 0.01);
            }
        }

        [Fact]
        public void BadArgumentsAreNamed()
        {
            Named("height", options => options.Height = 0);
            Named("dabs[0].radius", options => options.Dabs.Add(new Dab { Radius = -1 }));
            Assert.Throws<ArgumentNullException>(() => Picture.Create((PictureSource)null));
            Assert.Throws<ArgumentNullException>(() => Picture.Create((IReadOnlyList<PictureSource>)null));
            Assert.Throws<InvalidArgumentException>(() => Picture.Create(new PictureSource[0]));
            Assert.Throws<InvalidArgumentException>(() => Picture.Create(PictureSource.FromPoints(new double[0])));
            Assert.Throws<InvalidArgumentException>(() => Picture.Create(PictureSource.FromPoints(new double[7])));
            Assert.Throws<ArgumentNullException>(() => PictureSource.FromModel(null));
            Assert.Throws<ArgumentNullException>(() => PictureSource.FromPointSet(null));
            Assert.Throws<ArgumentNullException>(() => new Change(null, "1"));
            Assert.Throws<ArgumentNullException>(() => new PictureOptions().Set("style.ink", null));
            Assert.Throws<InvalidArgumentException>(() => picture.Rasterize(new byte[8], Width, Height));
            Assert.Throws<ArgumentNullException>(() => picture.Rasterize((byte[])null, 1, 1));
            Model gone = Csg.Sphere(1);
            gone.Dispose();
            Assert.Throws<ObjectDisposedException>(() => Picture.Create(gone));
            Picture disposed = Picture.Create(PictureSource.FromPoints(points, normals), Small());
            disposed.Dispose();
            disposed.Dispose();
            Assert.Throws<ObjectDisposedException>(() => disposed.Info);
            Assert.Throws<ObjectDisposedException>(() => disposed.Draw());
            Assert.Throws<ObjectDisposedException>(() => disposed.Parts);
        }

        [Fact]
        public void CallsCanBeCancelled()
        {
            PictureSource source = PictureSource.FromPoints(points, normals);
            using (var cancelled = new CancellationTokenSource())
            {
                cancelled.Cancel();
                CancellationToken token = cancelled.Token;
                Cancelled(() => Picture.Draw(source, cancellationToken: token));
                Cancelled(() => Picture.Create(source, cancellationToken: token));
                Cancelled(() => picture.Draw(cancellationToken: token));
                Cancelled(() => picture.Restyle(cancellationToken: token));
                Cancelled(() => picture.Write(new MemoryStream(), cancellationToken: token));
                Cancelled(() => picture.WriteViews(new MemoryStream(), cancellationToken: token));
            }
            foreach (Stage stage in new[] { Stage.Fit, Stage.Marks, Stage.Lines, Stage.Frame })
            {
                using (var later = new CancellationTokenSource())
                {
                    PictureOptions options = Small();
                    var happened = new List<PictureEvent>();
                    options.OnEvent = one =>
                    {
                        happened.Add(one);
                        if (one.Stage == stage)
                        {
                            later.Cancel();
                        }
                    };
                    CancelledException thrown = Assert.Throws<CancelledException>(
                        () => Picture.Draw(source, options, null, null, later.Token));
                    Assert.Equal(later.Token, thrown.CancellationToken);
                    Assert.Equal(stage, happened.Last().Stage);
                }
            }
            byte[] expected = picture.Rasterize();
            picture.Draw().Dispose(); // the picture still works
            Assert.Equal(expected, picture.Rasterize());
        }

        [Fact]
        public void ExceptionsInCallbacksAreTheInnerException()
        {
            var own = new InvalidOperationException("my own");
            PictureSource source = PictureSource.FromPoints(points, normals);
            PictureOptions options = Small();
            int called = 0;
            options.OnEvent = one =>
            {
                ++called;
                throw own;
            };
            CallbackException thrown = Assert.Throws<CallbackException>(() => Picture.Create(source, options));
            Assert.Same(own, thrown.InnerException);
            Assert.Contains("event", thrown.Message);
            Assert.Equal(1, called);
            Assert.Same(own, Assert.Throws<CallbackException>(() => Picture.Draw(
                source, Small(), null, new Reports(at => { throw own; }))).InnerException);
            ImplicitFunction failing = (at, value, gradient, hessian) => { throw own; };
            using (Model model = Model.FromFunction(failing, (-1, -1, -1), (1, 1, 1)))
            {
                Assert.Same(own, Assert.Throws<CallbackException>(() => Picture.Create(model)).InnerException);
            }
            Picture other = null;
            bool throws = false;
            options.OnEvent = one =>
            {
                if (other == null)
                {
                    return;
                }
                Assert.True(other.Info.Marks > 0); // a callback may read the picture
                if (throws)
                {
                    other.Draw();
                }
            };
            using (other = Picture.Create(source, options))
            {
                byte[] expected = other.Rasterize();
                throws = true;
                Assert.IsType<InvalidOperationException>(
                    Assert.Throws<CallbackException>(() => other.Draw()).InnerException);
                throws = false;
                Assert.Equal(expected, other.Rasterize());
            }
        }

        [Fact]
        public void SettingsDrawTheSamePicture()
        {
            PictureOptions options = Small(Preset.Stipple);
            options.Azimuth = 50;
            options.Set("style.ink", "#204060");
            var stream = new MemoryStream();
            using (Picture made = Picture.Draw(PictureSource.FromPoints(points, normals), options))
            {
                byte[] expected = made.Rasterize();
                made.SaveSettings(stream);
                stream.Position = 0;
                PictureOptions again;
                using (Settings settings = Settings.Load(stream))
                {
                    again = new PictureOptions { Settings = settings };
                    Assert.Equal(expected, Draw(PictureSource.FromPoints(points, normals), again));
                    again.Preset = Preset.Silhouette; // options override settings
                    using (Picture other = Picture.Create(PictureSource.FromPoints(points, normals), again))
                    {
                        Assert.Equal(Preset.Silhouette, other.Info.Preset);
                        Assert.Equal(made.Camera.View, other.Camera.View);
                    }
                }
                Assert.Throws<ObjectDisposedException>(
                    () => Picture.Create(PictureSource.FromPoints(points, normals), again));
                string path = Path.GetTempFileName();
                try
                {
                    made.SaveSettings(path);
                    Assert.Equal(stream.ToArray(), File.ReadAllBytes(path));
                    Settings.Load(path).Dispose();
                }
                finally
                {
                    File.Delete(path);
                }
                Assert.IsType<NotSupportedException>(Assert.Throws<StreamException>(
                    () => made.SaveSettings(new PictureOutputTest.Full())).InnerException);
            }
            var wrong = new MemoryStream(Encoding.UTF8.GetBytes("{\"hrbfnpr-settings\": 1, \"stile\": {}}"));
            Assert.Contains("stile", Assert.Throws<InvalidArgumentException>(() => Settings.Load(wrong)).Message);
            Assert.Throws<ArgumentNullException>(() => Settings.Load((Stream)null));
        }

        [Fact]
        public void APictureOutlivesItsSources()
        {
            var context = new Context(new ContextOptions { ThreadCount = 2, Log = (level, message) => { } });
            var others = new Context(new ContextOptions
            {
                ThreadCount = 2,
                RunTasks = (task, count) =>
                {
                    for (long i = 0; i < count; ++i)
                    {
                        task(i);
                    }
                },
            });
            ImplicitFunction ball = (at, value, gradient, hessian) =>
            {
                for (int i = 0; i < value.Length; ++i)
                {
                    value[i] = Shapes.Length(at, i) - 1;
                }
            };
            Model model = Model.FromFunction(ball, (-1, -1, -1), (1, 1, 1), null, others);
            Picture drawn = Picture.Create(model, Small(Preset.Silhouette), context);
            PicturePart part = drawn.Parts[0];
            model.Dispose();
            others.Dispose();
            context.Dispose();
            Collect();
            Assert.InRange(Dark(drawn.Rasterize()), 50, 2000);
            using (Picture other = drawn.Restyle(Small(Preset.Stipple)))
            {
                drawn.Dispose();
                Collect();
                Assert.True(Dark(other.Rasterize()) > 50);
            }
            Assert.Equal(0.0, part.Model.Evaluate(new double[] { 0, 1, 0 }).Value[0], 1e-12);
            Assert.True(part.LineSet.Info.Triangles > 0);
        }

        private static void Collect()
        {
            for (int i = 0; i < 4; ++i)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
        }

        private static void Cancelled(Action call)
        {
            Assert.Equal(Status.Cancelled, Assert.Throws<CancelledException>(call).Status);
        }

        private static PictureOptions Small(Preset preset = Preset.ContourAndStipple)
        {
            return new PictureOptions { Preset = preset, Width = Width, Height = Height };
        }

        private static byte[] Draw(PictureSource source, PictureOptions options = null)
        {
            using (Picture drawn = Picture.Draw(source, options ?? Small()))
            {
                return drawn.Rasterize();
            }
        }

        /// <summary>The number of pixels that are darker than the paper.</summary>
        private static int Dark(byte[] rgba)
        {
            int dark = 0;
            for (int i = 0; i < rgba.Length; i += 4)
            {
                dark += rgba[i] < 200 ? 1 : 0;
            }
            return dark;
        }

        private void Named(string name, Action<PictureOptions> change)
        {
            PictureOptions options = Small();
            change(options);
            InvalidArgumentException wrong = Assert.Throws<InvalidArgumentException>(
                () => Picture.Create(PictureSource.FromPoints(points, normals), options));
            Assert.Contains(name, wrong.Message);
        }
    }
}
