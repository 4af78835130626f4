// SPDX-License-Identifier: MIT
#if NET7_0_OR_GREATER
using System;
using System.Linq;
using Xunit;

namespace HrbfNpr.Tests
{
    /// <summary>Overloads that only newer .NET has.</summary>
    public class SpanTest
    {
        [Fact]
        public void SpansAreReadAndWritten()
        {
            double[] points = Shapes.Sphere(60);
            using Model model = Model.Fit(points.AsSpan(), points.AsSpan());
            using Model arrays = Model.Fit(points, points);
            float[] floats = Shapes.ToFloats(points);
            using Model single = Model.Fit((ReadOnlySpan<float>)floats, floats);
            using Model singleArrays = Model.Fit(floats, floats);
            Span<double> value = stackalloc double[2], gradient = stackalloc double[6];
            ReadOnlySpan<double> at = stackalloc double[] { 0, 0, 0, 2, 0, 0 };
            model.Evaluate(at, value, gradient);
            Assert.Equal(arrays.Evaluate(at.ToArray()).Value, value.ToArray());
            Assert.True(value[0] < 0 && value[1] > 0 && gradient[3] > 0.5);
            Assert.Equal(single.Evaluate(points).Value, singleArrays.Evaluate(points).Value);
            Assert.Throws<InvalidArgumentException>(
                () => model.Evaluate(new double[4], Span<double>.Empty, Span<double>.Empty));
            Assert.Equal(model.ToBytes(), Model.Load(model.ToBytes().AsSpan()).ToBytes());
        }

        [Fact]
        public void DrawingsAreWrittenToSpans()
        {
            using Model model = Shapes.FitSphere();
            using PointSet marks = Shapes.Stipple(model, 500);
            using var renderer = new Renderer();
            Camera camera = Shapes.Look(marks, 32);
            using Drawing drawing = renderer.Draw(marks, camera);
            byte[] expected = drawing.Rasterize();
            var memory = new byte[expected.Length + 100];
            drawing.Rasterize(memory.AsSpan(50, expected.Length), 32, 32);
            Assert.Equal(expected, memory.Skip(50).Take(expected.Length).ToArray());
            Assert.True(memory.Take(50).All(value => value == 0));
            Assert.Throws<InvalidArgumentException>(() => drawing.Rasterize(memory.AsSpan(0, 100), 32, 32));
            var layout = new VertexLayout().Add(VertexAttribute.Window);
            Vertices vertices = drawing.Vertices(layout);
            var same = new byte[vertices.Data.Length];
            Assert.Equal(vertices.Count, drawing.WriteVertices(layout, same.AsSpan()).Vertices);
            Assert.Equal(vertices.Data, same);
            var structs = new Point[vertices.Count];
            var indices = new uint[vertices.Count];
            Assert.Equal(vertices.Count, drawing.WriteVertices(layout, structs.AsSpan(), indices).Indices);
            Assert.Equal(BitConverter.ToSingle(same, 4), structs[0].Y);
            Assert.Equal(vertices.Indices, indices);
            Assert.Throws<BufferTooSmallException>(() => drawing.WriteVertices(layout, same.AsSpan(0, 12)));
            var floats = new float[32 * 32 * 4];
            drawing.Rasterize(floats, 32, 32);
            var inside = new float[floats.Length + 8];
            drawing.Rasterize(inside.AsSpan(4, floats.Length), 32, 32);
            Assert.Equal(floats, inside.Skip(4).Take(floats.Length).ToArray());
            var shown = new MarkClass[marks.Count];
            drawing.MarkResults(0, 0, shown);
            Assert.Equal(drawing.MarkResults(0, marks.Layers[0]).Shown, shown);
            var drawn = new uint[marks.Count];
            long count = drawing.WriteMarkIndices(0, 0, MarkClass.Front, Primitive.Points, drawn.AsSpan());
            Assert.Equal(shown.Count(one => one == MarkClass.Front), count);
            Assert.Equal(drawing.MarkIndices(0, 0), drawn.Take((int)count).ToArray());
            Assert.Throws<BufferTooSmallException>(
                () => drawing.WriteMarkIndices(0, 0, MarkClass.Front, Primitive.Points, drawn.AsSpan(0, 1)));
        }

        [Fact]
        public void ADrawingLoopHardlyAllocates()
        {
            using Model model = Shapes.FitSphere();
            using PointSet marks = Shapes.Stipple(model, 500);
            using var context = new Context(new ContextOptions { ThreadCount = 1 });
            using var renderer = new Renderer(context);
            Style style = Style.Preset(Preset.ContourAndStipple);
            style.Layers[0].Name = "stipples";
            style.Layers.Add(new LayerStyle());
            var item = new Item(marks, style);
            Camera camera = Shapes.Look(marks, 32);
            var pixels = new byte[32 * 32 * 4];
            void Draw(int times)
            {
                for (int i = 0; i < times; ++i)
                {
                    using Drawing drawing = renderer.Draw(item, camera);
                    drawing.Rasterize(pixels, 32, 32);
                }
            }
            Draw(50);
            long managed = GC.GetAllocatedBytesForCurrentThread(), native = context.Info.BytesPeak;
            long now = context.Info.BytesNow;
            Draw(200);
            managed = GC.GetAllocatedBytesForCurrentThread() - managed;
            // A drawing and its handle are allocated each time.
            Assert.True(managed / 200 <= 160, $"{managed / 200} bytes each time");
            Assert.Equal(native, context.Info.BytesPeak);
            Assert.Equal(now, context.Info.BytesNow);
        }

        private struct Point
        {
            internal float X;
            internal float Y;
            internal float Depth;
        }

        [Fact]
        public void ViewsCanBeReadAsSpans()
        {
            using Model model = Shapes.FitSphere();
            using PointSet marks = Shapes.Stipple(model, 100);
            MarkLayer layer = marks.Layers[0];
            using NativeView view = layer.View(MarkAttribute.Normal);
            Assert.Equal(view.ToArray<float>(), view.AsSpan<float>().ToArray());
            Assert.Equal(view.ToArray<float>(), layer.AsSpan<float>(MarkAttribute.Normal).ToArray());
            Assert.Equal(0, layer.AsSpan<uint>(MarkAttribute.StrokeFirst).Length);
            Assert.Throws<InvalidCastException>(() => layer.AsSpan<uint>(MarkAttribute.Normal).Length);
            Assert.Throws<InvalidCastException>(() => view.AsSpan<double>().Length);
            Assert.Equal(marks.Count, PointSet.Load(marks.ToBytes().AsSpan()).Count);
        }

        [Fact]
        public void PicturesTakeSpans()
        {
            double[] points = Shapes.Sphere(60), padded = points.Concat(new double[3]).ToArray();
            var options = new PictureOptions { Preset = Preset.ContourAndStipple, Width = 64, Height = 48 };
            ReadOnlySpan<double> span = padded.AsSpan(0, points.Length);
            using Picture expected = Picture.Draw(PictureSource.FromPoints((ArrayView)points, points), options);
            using Picture picture = Picture.Draw(PictureSource.FromPoints(span, span), options);
            byte[] pixels = picture.Rasterize();
            Assert.Equal(expected.Rasterize(), pixels);
            var memory = new byte[pixels.Length + 20];
            picture.Rasterize(memory.AsSpan(10, pixels.Length), 64, 48);
            Assert.Equal(pixels, memory.Skip(10).Take(pixels.Length).ToArray());
            Assert.True(memory.Take(10).Concat(memory.Skip(10 + pixels.Length)).All(value => value == 0));
            Assert.Throws<InvalidArgumentException>(() => picture.Rasterize(memory.AsSpan(0, 100), 64, 48));
            PictureSource odd = PictureSource.FromPoints(new double[4].AsSpan());
            Assert.Throws<InvalidArgumentException>(() => Picture.Create(odd));
            float[] single = Shapes.ToFloats(points);
            Assert.Equal(60, PictureSource.FromPoints(single.AsSpan(), single).Inspect().Points);
            Assert.False(PictureSource.FromPoints(span).Inspect().HasNormals);
            Shapes.Cube(out double[] vertices, out int[] triangles);
            Assert.Equal(1.0, PictureSource.FromMesh(vertices.AsSpan(), triangles).Inspect().Volume, 12);
            Assert.Equal(1.0, PictureSource.FromMesh(Shapes.ToFloats(vertices), triangles).Inspect().Volume, 6);
        }

        [Fact]
        public void ASpanFunctionIsEvaluatedInPlace()
        {
            ImplicitSpanFunction ball = (points, value, gradient, hessian) =>
            {
                Assert.Equal(3 * value.Length, points.Length);
                Assert.True(hessian.IsEmpty);
                for (int i = 0; i < value.Length; ++i)
                {
                    double x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
                    double r = Math.Sqrt(x * x + y * y + z * z);
                    value[i] = r - 1;
                    if (!gradient.IsEmpty)
                    {
                        gradient[3 * i] = x / r;
                        gradient[3 * i + 1] = y / r;
                        gradient[3 * i + 2] = z / r;
                    }
                }
            };
            var options = new FunctionOptions { HasGradient = true, ThreadSafe = true };
            using Model model = Model.FromSpanFunction(ball, (-1, -1, -1), (1, 1, 1), options);
            Evaluation at = model.Evaluate(new double[] { 0, 3, 0 }, gradient: true);
            Assert.Equal(2, at.Value[0], 1e-12);
            Assert.Equal(1, at.Gradient[1], 1e-12);
            using PointSet marks = Shapes.Stipple(model, 200);
            Assert.InRange(marks.Count, 150, 250);
        }
    }
}
#endif
