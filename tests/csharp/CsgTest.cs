// SPDX-License-Identifier: MIT
using System;
using Xunit;

namespace HrbfNpr.Tests
{
    public class CsgTest
    {
        private static readonly double[] Points = MakePoints();

        private static double[] MakePoints()
        {
            var points = new double[300];
            for (int i = 0; i < points.Length; ++i)
            {
                points[i] = 1.2 * Math.Sin(1.7 * i);
            }
            return points;
        }

        private static double Ball(int i, double x, double radius)
        {
            double a = Points[3 * i] - x, b = Points[3 * i + 1], c = Points[3 * i + 2];
            return Math.Sqrt(a * a + b * b + c * c) - radius;
        }

        private static void Check(Model model, Func<int, double> expected)
        {
            using (model)
            {
                double[] value = model.Evaluate(Points).Value;
                for (int i = 0; i < value.Length; ++i)
                {
                    Assert.Equal(expected(i), value[i], 1e-13);
                }
            }
        }

        [Fact]
        public void OperatorsAreMinimaAndMaxima()
        {
            using (Model a = Csg.Sphere(0.8))
            using (Model b = Csg.Sphere(0.6, (0.5, 0, 0)))
            {
                Check(a | b, i => Math.Min(Ball(i, 0, 0.8), Ball(i, 0.5, 0.6)));
                Check(a & b, i => Math.Max(Ball(i, 0, 0.8), Ball(i, 0.5, 0.6)));
                Check(a - b, i => Math.Max(Ball(i, 0, 0.8), -Ball(i, 0.5, 0.6)));
                Check(~a, i => -Ball(i, 0, 0.8));
                Check(a.Offset(0.1), i => Ball(i, 0, 0.9));
                Check(a.Shell(0.1), i => Math.Max(Ball(i, 0, 0.8), -Ball(i, 0, 0.7)));
                Check(a.Translated((0.5, 0, 0)), i => Ball(i, 0.5, 0.8));
                Check(a.Blend(b, 0.5), i =>
                {
                    double x = Ball(i, 0, 0.8), y = Ball(i, 0.5, 0.6);
                    return Math.Min(x, y) - 0.5 / 6 * Math.Pow(Math.Max(0, 1 - Math.Abs(x - y) / 0.5), 3);
                });
                Check(a.BlendDifference(b, 0.5), i =>
                {
                    double x = -Ball(i, 0, 0.8), y = Ball(i, 0.5, 0.6);
                    return -(Math.Min(x, y) - 0.5 / 6 * Math.Pow(Math.Max(0, 1 - Math.Abs(x - y) / 0.5), 3));
                });
                Check(a.BlendIntersection(b, 0, 0), i => Math.Max(Ball(i, 0, 0.8), Ball(i, 0.5, 0.6)));
            }
        }

        [Fact]
        public void PrimitivesHaveTheGivenPlaceAndSize()
        {
            Check(Csg.Box((1, 2, 3), (0.1, 0, 0)), i => Math.Max(
                Math.Max(Math.Abs(Points[3 * i] - 0.1) - 0.5, Math.Abs(Points[3 * i + 1]) - 1),
                Math.Abs(Points[3 * i + 2]) - 1.5));
            Check(Csg.Cylinder(0.4, 1, axis: new Vector3d(-3, 0, 0)), i => Math.Max(
                Math.Sqrt(Points[3 * i + 1] * Points[3 * i + 1] + Points[3 * i + 2] * Points[3 * i + 2]) - 0.4,
                Math.Abs(Points[3 * i]) - 0.5));
            Check(Csg.HalfSpace((0, 0, 0.2), (0, 0, -2)), i => 0.2 - Points[3 * i + 2]);
            using (Model torus = Csg.Torus(0.6, 0.2, axis: new Vector3d(0, 1, 0)))
            using (Model cone = Csg.Cone(0.5, 0, 2, axis: new Vector3d(0.6, 0, -0.8)))
            {
                Assert.Equal(0.0, torus.Evaluate(new double[] { 0.4, 0, 0 }).Value[0], 1e-13);
                Assert.Equal(0.0, cone.Evaluate(new double[] { 0.6, 0, -0.8 }).Value[0], 1e-13);
                Assert.True(cone.Evaluate(new double[] { 0.5, 0, -0.7 }).Value[0] < 0);
            }
        }

        [Fact]
        public void SolidsKeepTheirOperandsAlive()
        {
            Model both;
            using (Model fitted = Shapes.FitSphere())
            using (Model cut = Csg.HalfSpace((0, 0, 0), (0, 0, 1)))
            {
                both = fitted - cut;
            }
            using (both)
            {
                Assert.Equal(Kernel.Csg, both.Info.Kernel);
                CsgInfo info = both.CsgInfo;
                Assert.Equal(3L, info.Nodes);
                Assert.Equal(2L, info.Depth);
                Assert.Equal(1L, info.Models);
                Assert.Equal(8L, info.Sheets);
                Assert.Equal(0.0, info.Lipschitz);
                Assert.True(both.Evaluate(new double[] { 0, 0, 0.5 }).Value[0] < 0);
                Assert.True(both.Evaluate(new double[] { 0, 0, -0.5 }).Value[0] > 0);
            }
        }

        [Fact]
        public void InvalidOperandsAreRefused()
        {
            using (Model a = Csg.Sphere(1))
            using (Model far = Csg.Sphere(1, (5, 0, 0)))
            using (Model half = Csg.HalfSpace((0, 0, 0), (1, 2, 3)))
            {
                Assert.Throws<InvalidArgumentException>(() => a & far);
                Assert.Throws<InvalidArgumentException>(() => a | half);
                Assert.Throws<InvalidArgumentException>(() => a.Blend(far, -1));
                Assert.Throws<ArgumentNullException>(() => a.Union(null, far));
                Assert.Throws<InvalidArgumentException>(() => a.Transformed(new double[3]));
                Assert.Throws<InvalidArgumentException>(() => Csg.Sphere(0));
                Assert.Throws<InvalidArgumentException>(() => Csg.Cylinder(1, 1, (0, 0, 0), (0, 0, 0)));
            }
        }
    }
}
