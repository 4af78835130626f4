// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Xunit;

namespace HrbfNpr.Tests
{
    public unsafe class LineSetTest : IDisposable
    {
        private readonly Model model = Shapes.FitSphere();
        private readonly LineSet lines;
        private readonly PointSet marks;
        private readonly Camera camera;
        private readonly Renderer renderer = new Renderer();
        private readonly Style silhouette = Style.Preset(Preset.Silhouette);

        public LineSetTest()
        {
            lines = model.LineSet();
            marks = Shapes.Stipple(model, 500);
            camera = Camera.FitBounds((-1.5, -1.5, -1.5), (1.5, 1.5, 1.5), (0, 0, -1), (0, 1, 0), 96, 96);
        }

        public void Dispose()
        {
            renderer.Dispose();
            marks.Dispose();
            lines.Dispose();
            model.Dispose();
        }

        [Fact]
        public void ALineSetReportsItsProperties()
        {
            LineSetInfo info = lines.Info;
            Assert.True(info.Triangles > 100 && info.CellSize > 0 && info.Seconds > 0 && info.Bytes > 0);
            Assert.Equal(0L, info.Turned + info.MissedSeeds + info.Lines + info.Borders + info.Creases);
            using (LineSet coarse = model.LineSet(new LineSetOptions { CellSize = 2 * info.CellSize }))
            using (LineSet seeded = model.LineSet(new LineSetOptions { SeedPoints = new float[] { 0, 0, 1.01f } }))
            {
                Assert.Equal(2 * info.CellSize, coarse.Info.CellSize, 1e-12);
                Assert.InRange(coarse.Info.Triangles, 1L, info.Triangles / 2);
                Assert.True(seeded.Info.Triangles > 100);
                Assert.Equal(0L, seeded.Info.MissedSeeds);
            }
        }

        [Fact]
        public void AModelCanBeTrimmed()
        {
            Assert.False(model.TrimInfo.IsTrimmed);
            using (Model closed = model.Trim())
            {
                Assert.False(closed.TrimInfo.IsTrimmed);
                Assert.True(closed.TrimInfo.Samples > 0 && closed.TrimInfo.Spacing > 0);
            }
            var cap = new double[] { 0, 0, 1, 0.3, 0, 0.95, -0.3, 0, 0.95, 0, 0.3, 0.95, 0, -0.3, 0.95 };
            using (Model open = model.Trim(new TrimOptions { Points = cap, Normals = cap }))
            using (LineSet some = open.LineSet())
            {
                TrimInfo info = open.TrimInfo;
                Assert.True(info.IsTrimmed && info.Farthest > 1);
                Assert.Equal(5L, info.Samples);
                Assert.Equal(1L, info.Parts);
                Assert.Equal(0L, info.PartsToEnd);
                Assert.InRange(info.Share, 0.5, 0.99);
                Assert.Equal(1L, some.Info.Borders);
                using (Model loaded = Model.Load(open.ToBytes()))
                {
                    Assert.Equal(info.Share, loaded.TrimInfo.Share);
                }
            }
            Assert.Throws<InvalidArgumentException>(() => model.Trim(new TrimOptions { Limit = 0 }));
        }

        [Fact]
        public void ContoursAreASeparateLayerOfStrokes()
        {
            using (Drawing drawing = renderer.Draw(With(silhouette), camera))
            {
                DrawingInfo info = drawing.Info;
                Assert.True(info.LineCurves > 0 && info.NanosecondsLines > 0);
                Assert.Equal(0L, info.LineCusps + info.LineCrossings + info.LineBroken);
                Assert.Equal(0L, info.LineSettled + info.LineContradictions + info.Dots);
                DrawingLayerInfo layer = OfLines(drawing);
                Assert.Equal(-1L, layer.Layer);
                Assert.Equal(0L, layer.Item);
                Assert.Equal((LineKind?)LineKind.Contour, layer.LineKind);
                Assert.Equal(LayerKind.Any, layer.Kind);
                Assert.Equal(Shape.Strokes, layer.Shape);
                Assert.Equal(MarkClass.Silhouette, layer.MarkClass);
                Assert.Equal(string.Empty, layer.Name);
                Assert.True(layer.Strokes > 0);
                Assert.Equal(info.Strokes, layer.Strokes);
                Assert.True(drawing.Rasterize(PixelFormat.Coverage8).Count(value => value > 100) > 50);
            }
            using (Drawing drawing = renderer.Draw(new Item(marks, silhouette), camera))
            {
                Assert.Equal(0L, drawing.Info.LineCurves);
                Assert.True(drawing.Layers.All(layer => layer.Layer >= 0 && layer.LineKind == null));
            }
        }

        [Fact]
        public void SectionsAndOwnLinesAreFoundOnce()
        {
            float[] path = { 0, 0, 1, 0.2f, 0, 1, 0.4f, 0, 0.95f, 0, 0.5f, 0.85f, 0.1f, 0.5f, 0.85f };
            var options = new LineSetOptions
            {
                Lines =
                {
                    LineOptions.Section((0, 0, 2), -0.5, 0, 0.5),
                    LineOptions.Own(path, new uint[] { 0, 3, 5 }, "crease"),
                },
            };
            using (LineSet found = model.LineSet(options))
            {
                Assert.Equal(5L, found.Info.Lines);
                var style = new Style { Lines = { new LineStyle(LineKind.Section), new LineStyle(LineKind.Own) } };
                style.Lines[1].Name = "crease";
                style.Lines[1].Width = 4;
                style.Lines[1].Ink = new Color(0, 0, 1);
                style.Layers.Add(new LayerStyle { Shown = false });
                var item = new Item(marks, style) { LineSet = found };
                using (Drawing drawing = renderer.Draw(item, camera))
                {
                    DrawingLayerInfo own = drawing.Layers.Single(layer => layer.LineKind == LineKind.Own);
                    Assert.Equal(2L, own.Strokes);
                    Assert.Equal(new Color(0, 0, 1), own.Ink);
                    Assert.True(drawing.Layers.Single(layer => layer.LineKind == LineKind.Section).Strokes >= 1);
                }
                style.Lines[1].Name = "seam";
                using (Drawing drawing = renderer.Draw(item, camera))
                {
                    Assert.Equal(0L, drawing.Layers.Where(layer => layer.LineKind == LineKind.Own).Sum(layer => layer.Strokes));
                }
            }
        }

        [Fact]
        public void SomeLinesNeedCurvatures()
        {
            var style = new Style { LightSpace = LightSpace.Camera, Light = (0, 0, 1) };
            style.Lines.Add(new LineStyle(LineKind.SuggestiveContour));
            style.Lines.Add(new LineStyle(LineKind.ApparentRidge) { Lower = 1, Upper = 2 });
            style.Lines.Add(new LineStyle(LineKind.Isophote) { Levels = new[] { 0.5, 0.8 } });
            Assert.Contains("WITH_CURVATURE", Refused(With(style)));
            using (LineSet measured = model.LineSet(new LineSetOptions { WithCurvature = true }))
            using (Drawing drawing = renderer.Draw(new Item(marks, style) { LineSet = measured }, camera))
            {
                Assert.True(measured.Info.Bytes > lines.Info.Bytes);
                Assert.True(drawing.Layers.Single(layer => layer.LineKind == LineKind.Isophote).Strokes >= 2);
            }
        }

        [Fact]
        public void DefaultsMatchTheLibrary()
        {
            var style = new LineStyle();
            Assert.Equal(0, new Style().Lines.Count);
            style.Levels = new[] { 0.5 };
            style.Clone().Levels[0] = 0.7;
            Assert.Equal(0.5, style.Levels[0], 0);

            hrbfnpr_line_desc library, ours;
            Errors.Check(NativeMethods.hrbfnpr_line_desc_init(&library, (uint)sizeof(hrbfnpr_line_desc)));
            using (var pins = new Pins())
            {
                new LineOptions().Write(&ours, pins);
            }
            for (int i = 0; i < sizeof(hrbfnpr_line_desc); ++i)
            {
                Assert.Equal(((byte*)&library)[i], ((byte*)&ours)[i]);
            }
            hrbfnpr_line_set_desc wanted, made;
            Errors.Check(NativeMethods.hrbfnpr_line_set_desc_init(&wanted, (uint)sizeof(hrbfnpr_line_set_desc)));
            using (var pins = new Pins())
            using (var held = new HeldHandles())
            {
                new LineSetOptions().Write(&made, pins, held);
            }
            Assert.True(made.flags == wanted.flags && made.cell_size == wanted.cell_size && made.line_count == 0);
        }

        [Fact]
        public void MessagesNameTheArgument()
        {
            Assert.Contains("lines[1].kind", Refused(new LineOptions(), new LineOptions(LineKind.Contour)));
            Assert.Contains("lines[0].kind", Refused(new LineOptions((LineKind)99)));
            Assert.Contains("lines[0].name", Refused(new LineOptions { Name = new string('x', 64) }));
            Assert.Contains("line_first", Refused(LineOptions.Own(new double[6], new uint[] { 0, 3 })));
            Assert.Contains("Positions", Refused(LineOptions.Own(new double[7], new uint[] { 0, 2 })));
            Assert.Throws<ArgumentNullException>(() => model.LineSet(new LineSetOptions { Lines = { null } }));

            Assert.Contains("lines[0].kind", Refused(Drawn(line => line.Kind = (LineKind)99)));
            Assert.Contains("levels[1]", Refused(Drawn(line =>
            {
                line.Kind = LineKind.Isophote;
                line.Levels = new[] { 0.0, 2.0 };
            })));
            silhouette.Lines[0] = null;
            Assert.Throws<ArgumentNullException>(() => renderer.Draw(With(silhouette), camera));
        }

        [Fact]
        public void ObjectsMayBeDisposedInAnyOrder()
        {
            var context = new Context();
            Model ball = Shapes.FitSphere(context);
            LineSet kept = ball.LineSet(null, context);
            PointSet dots = Shapes.Stipple(ball, 100, context);
            var its = new Renderer(context);
            context.Dispose();
            ball.Dispose();
            Drawing drawing = its.Draw(new Item(dots, silhouette) { LineSet = kept }, camera);
            kept.Dispose();
            kept.Dispose();
            dots.Dispose();
            its.Dispose();
            Assert.True(OfLines(drawing).Strokes > 0);
            Assert.True(Ink(drawing) > 0);
            drawing.Dispose();
            Assert.Throws<ObjectDisposedException>(() => kept.Info);
            Assert.Throws<ObjectDisposedException>(() => ball.LineSet());
            Assert.Throws<ObjectDisposedException>(
                () => renderer.Draw(new Item(marks, silhouette) { LineSet = kept }, camera));
        }

        private static DrawingLayerInfo OfLines(Drawing drawing)
        {
            return drawing.Layers.Single(layer => layer.Layer == -1 && layer.LineKind == LineKind.Contour);
        }

        private static long Ink(Drawing drawing)
        {
            return drawing.Rasterize(PixelFormat.Coverage8).Sum(value => (long)value);
        }

        private Item With(Style style, double right = 0, double away = 0)
        {
            double[] shift = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, right, 0, away, 1 };
            return new Item(marks, style) { LineSet = lines, Transform = shift };
        }

        private Item Drawn(Action<LineStyle> change)
        {
            Style style = Style.Preset(Preset.Silhouette);
            change(style.Lines[0]);
            return With(style);
        }

        private string Refused(Item item)
        {
            return Assert.Throws<InvalidArgumentException>(() => renderer.Draw(item, camera)).Message;
        }

        private string Refused(params LineOptions[] wanted)
        {
            var options = new LineSetOptions();
            foreach (LineOptions line in wanted)
            {
                options.Lines.Add(line);
            }
            return Assert.Throws<InvalidArgumentException>(() => model.LineSet(options)).Message;
        }
    }
}
