#if NET7_0_OR_GREATER
using System;
using System.Linq;
using Xunit;

namespace HrbfNpr.Tests
{
    /// <summary>What only newer .NET has.</summary>
    public class SpanTest
    {
        [Fact]
        public void SpansInAndOut()
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
        public void DrawingIntoSpans()
        {
            using Model model = Shapes.FitSphere();
            using PointSet marks = Shapes.Stipple(model, 500);
            using var renderer = new Renderer();
            Camera camera = Shapes.Look(marks, 32);
            byte[] expected = renderer.Draw(camera, marks);
            var memory = new byte[expected.Length + 100];
            renderer.Draw(memory.AsSpan(50, expected.Length), 32, 32);
            Assert.Equal(expected, memory.Skip(50).Take(expected.Length).ToArray());
            Assert.True(memory.Take(50).All(value => value == 0));
            Assert.Throws<InvalidArgumentException>(() => renderer.Draw(memory.AsSpan(0, 100), 32, 32));
            var layout = new VertexLayout().Add(VertexAttribute.Window);
            byte[] vertices = renderer.Vertices(layout);
            var same = new byte[vertices.Length];
            Assert.Equal(vertices.Length / 12, renderer.WriteVertices(layout, same.AsSpan()));
            Assert.Equal(vertices, same);
            Assert.Throws<BufferTooSmallException>(() => renderer.WriteVertices(layout, same.AsSpan(0, 12)));
        }

        [Fact]
        public void ViewsAsSpans()
        {
            using Model model = Shapes.FitSphere();
            using PointSet marks = Shapes.Stipple(model, 100);
            using NativeView view = marks.View(Group.Stipple, MarkAttribute.Normal);
            Assert.Equal(view.ToArray<float>(), view.AsSpan<float>().ToArray());
            Assert.Throws<InvalidCastException>(() => view.AsSpan<double>().Length);
            Assert.Equal(marks.Count, PointSet.Load(marks.ToBytes().AsSpan()).Count);
        }

        [Fact]
        public void AFunctionInPlace()
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
