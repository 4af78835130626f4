// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Xunit;

namespace HrbfNpr.Tests
{
    public class DrawingTest : IDisposable
    {
        private readonly Model model = Shapes.FitSphere();
        private readonly PointSet marks;
        private readonly PointSet rings;
        private readonly Camera camera;
        private readonly Renderer renderer = new Renderer();
        private readonly Style style = Style.Preset(Preset.ContourAndStipple);

        public DrawingTest()
        {
            marks = Shapes.Stipple(model, 2000);
            rings = PointSet.Create(marks, Rings());
            camera = Shapes.Look(marks, 64);
        }

        public void Dispose()
        {
            renderer.Dispose();
            rings.Dispose();
            marks.Dispose();
            model.Dispose();
        }

        [Fact]
        public void StrokesAreWrittenAsLineAndTriangleStrips()
        {
            using (Drawing drawing = renderer.Draw(new Item(rings, Lines()), camera))
            {
                VertexLayout layout = new VertexLayout(Primitive.LineStrips).Add(VertexAttribute.Window)
                    .Add(VertexAttribute.Length).Add(VertexAttribute.Layer).Add(VertexAttribute.Id);
                Vertices strips = drawing.Vertices(layout);
                DrawingInfo info = drawing.Info;
                Assert.Equal(info.StrokePoints, strips.Count);
                Assert.Equal(info.StrokePoints + info.Strokes, (long)strips.Indices.Length);
                Assert.Equal(info.Strokes, (long)strips.Indices.Count(index => index == Vertices.Restart));
                Assert.Equal(Vertices.Restart, strips.Indices.Last());
                Assert.True(strips.Indices.All(index => index == Vertices.Restart || index < strips.Count));
                double x = 0, y = 0, along = 0;
                bool begins = true;
                foreach (uint index in strips.Indices)
                {
                    if (index == Vertices.Restart)
                    {
                        begins = true;
                        continue;
                    }
                    int at = (int)index * layout.Stride;
                    double nextX = BitConverter.ToSingle(strips.Data, at), nextY = BitConverter.ToSingle(strips.Data, at + 4);
                    double next = BitConverter.ToSingle(strips.Data, at + 12);
                    double step = Math.Sqrt((nextX - x) * (nextX - x) + (nextY - y) * (nextY - y));
                    Assert.Equal(begins ? 0 : along + step, next, 1e-3);
                    x = nextX;
                    y = nextY;
                    along = next;
                    begins = false;
                    MarkIdentity identity = drawing.Identify(BitConverter.ToUInt32(strips.Data, at + 20));
                    Assert.Equal(1L, identity.Layer);
                    Assert.True(identity.Stroke >= 0);
                }
                layout.Primitive = Primitive.TriangleStrips;
                Vertices triangles = drawing.Vertices(layout);
                Assert.Equal(2 * info.StrokePoints, triangles.Count);
                Assert.Equal(drawing.VertexBound(Primitive.TriangleStrips).Indices, (long)triangles.Indices.Length);
            }
        }

        [Fact]
        public void MarkResultsTellWhichMarksAreShown()
        {
            style.Visibility = Visibility.Published; // published visibility draws contours from marks
            using (Drawing drawing = renderer.Draw(new[] { new Item(marks, style), new Item(rings, style) }, camera))
            {
                MarkLayer layer = rings.Layers[0];
                MarkResults results = drawing.MarkResults(1, layer);
                Assert.Equal(layer.Count, (long)results.Shown.Length);
                for (int i = 0; i < results.Shown.Length; ++i)
                {
                    bool shown = results.Shown[i] != MarkClass.None;
                    Assert.True(shown == results.Radius[i] > 0 && shown == results.Opacity[i] > 0);
                }
                uint[] front = drawing.MarkIndices(1, 0), contour = drawing.MarkIndices(1, 0, MarkClass.Silhouette);
                Assert.Equal(results.Shown.Count(one => one == MarkClass.Front), front.Length);
                Assert.Equal(results.Shown.Count(one => one == MarkClass.Silhouette), contour.Length);
                Assert.True(front.Length > 100 && contour.Length > 10);
                Assert.True(front.All(mark => results.Shown[mark] == MarkClass.Front));
                uint[] strips = drawing.MarkIndices(1, 1, MarkClass.Front, Primitive.LineStrips);
                Assert.True(strips.Length > 0 && strips.Last() == Vertices.Restart);
                var radius = new float[layer.Count];
                drawing.MarkResultsInto(1, 0, default(ArrayView), radius);
                Assert.Equal(results.Radius, radius);
                Assert.Throws<InvalidArgumentException>(() => drawing.MarkResultsInto(1, 0, new byte[3]));
                Assert.Throws<InvalidArgumentException>(() => drawing.MarkResults(2, layer));
                Assert.Throws<InvalidArgumentException>(() => drawing.MarkIndices(0, 1));
                Assert.Throws<InvalidArgumentException>(() => drawing.MarkIndices(0, 0, MarkClass.Back));
            }
        }

        [Fact]
        public void AnIdIdentifiesAMark()
        {
            double[] shift = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 1 };
            var items = new List<Item> { new Item(marks, style), new Item(rings, style) { Transform = shift } };
            using (Drawing drawing = renderer.Draw(items, camera))
            {
                var id = new uint[4096];
                drawing.Rasterize(new byte[4 * 4096], 64, 64, PixelFormat.Rgba8, new RasterOptions { Id = id });
                var seen = new HashSet<long>();
                foreach (uint one in id.Where(one => one > 0).Distinct())
                {
                    MarkIdentity identity = drawing.Identify(one);
                    Assert.Equal(one, identity.Id);
                    long before = identity.Item == 0 ? 0 : marks.Count;
                    before += identity.Layer == 0 ? 0 : marks.Count;
                    Assert.Equal(one, before + identity.Mark + 1);
                    Assert.Equal(identity.Layer == 0, identity.Stroke == -1);
                    seen.Add(identity.Item);
                }
                Assert.Equal(2, seen.Count);
                MarkIdentity last = drawing.Identify((uint)(marks.Count + rings.Count));
                Assert.Equal(5L, last.Stroke);
                Assert.Equal(39L, last.Place);
                Assert.Throws<InvalidArgumentException>(() => drawing.Identify(0));
                Assert.Throws<InvalidArgumentException>(() => drawing.Identify(last.Id + 1));
            }
        }

        [Fact]
        public void PosesMoveMarks()
        {
            MarkLayer layer = marks.Layers[0];
            float[] positions = layer.Positions(), normals = layer.Normals();
            Vector3d origin = marks.Info.Origin;
            var moved = new double[positions.Length];
            for (int i = 0; i < moved.Length; i += 3)
            {
                moved[i] = positions[i] + origin.X;
                moved[i + 1] = positions[i + 1] + origin.Y;
                moved[i + 2] = positions[i + 2] + origin.Z;
            }
            var item = new Item(marks, style);
            byte[] still = Shapes.Draw(renderer, item, camera);
            item.Poses.Add(new LayerPose(0, moved, normals));
            Assert.InRange(Different(still, Shapes.Draw(renderer, item, camera)), 0, still.Length / 50);
            for (int i = 0; i < moved.Length; i += 3)
            {
                moved[i] += 100;
            }
            Assert.Equal(marks.Count, Shapes.Count(renderer, camera, item).Outside);
            item.Poses[0].Position = new double[3];
            Assert.Contains("position", Assert.Throws<InvalidArgumentException>(
                () => renderer.Draw(item, camera)).Message);
            item.Poses[0] = new LayerPose(1, moved, normals);
            Assert.Throws<InvalidArgumentException>(() => renderer.Draw(item, camera));
            item.Poses[0] = null;
            Assert.Throws<ArgumentNullException>(() => renderer.Draw(item, camera));
            item.Poses.Clear();
            Assert.Equal(still, Shapes.Draw(renderer, item, camera));
        }

        private static int Different(byte[] left, byte[] right)
        {
            return left.Where((value, index) => value != right[index]).Count();
        }

        /// <summary>Six circles of latitude of the unit sphere, with forty marks each.</summary>
        private static OwnLayer Rings()
        {
            var points = new double[3 * 240];
            for (int i = 0; i < 240; ++i)
            {
                double angle = 2 * Math.PI * (i % 40) / 39, y = -0.75 + 0.3 * (i / 40), radius = Math.Sqrt(1 - y * y);
                points[3 * i] = radius * Math.Cos(angle);
                points[3 * i + 1] = y;
                points[3 * i + 2] = radius * Math.Sin(angle);
            }
            return new OwnLayer(points, points, new uint[] { 0, 40, 80, 120, 160, 200, 240 }, "rings");
        }

        /// <summary>A style that draws only the rings, as blue lines.</summary>
        private static Style Lines()
        {
            var lines = new Style { Tone = Tone.None };
            lines.Layers.Add(new LayerStyle(LayerKind.Own)
            {
                Name = "rings", Shape = Shape.Strokes, Contours = false, Ink = new Color(0, 0, 1),
            });
            lines.Layers.Add(new LayerStyle { Shown = false, Contours = false });
            return lines;
        }
    }
}
