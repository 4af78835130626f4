// SPDX-License-Identifier: MIT
using System;
using System.Linq;
using System.Runtime.InteropServices;
using Xunit;

namespace HrbfNpr.Tests
{
    public class ModelTest
    {
        private static readonly double[] Points = Shapes.Sphere(60);

        [Fact]
        public void TheLibraryHasTheVersionThatTheAssemblyNeeds()
        {
            Assert.Equal((int)NativeMethods.AbiVersion, Library.AbiVersion);
            string[] parts = Library.Version.Split('.');
            Assert.Equal(
                Library.VersionNumber, int.Parse(parts[0]) * 10000 + int.Parse(parts[1]) * 100 + int.Parse(parts[2]));
            Assert.Contains("\"version\"", Library.BuildInfo);
            Assert.True(Library.BuildInfo.EndsWith("}"));
        }

        [Fact]
        public void AFitInterpolatesItsSamples()
        {
            using (Model model = Model.Fit((ArrayView)Points, (ArrayView)Points))
            {
                Evaluation at = model.Evaluate(Points, true, true);
                Assert.Equal(60, at.Value.Length);
                Assert.Equal(360, at.Hessian.Length);
                for (int i = 0; i < 60; ++i)
                {
                    Assert.Equal(0, at.Value[i], 1e-8);
                    Assert.Equal(Points[3 * i], at.Gradient[3 * i], 1e-6);
                }
                ModelInfo info = model.Info;
                Assert.Equal(60L, info.Samples);
                Assert.Equal(60L, info.Centres);
                Assert.Equal(Kernel.Triharmonic, info.Kernel);
                Assert.NotEqual(Solver.Auto, info.Solver);
                Assert.InRange(info.BoundsMax.Z, 0.9, 1.0);
                Assert.True(info.Bytes > 0 && info.SecondsTotal > 0 && info.PeakBytes > 0);
            }
        }

        [Fact]
        public void DepthImagesAreSmoothed()
        {
            var seen = new double[3 * 32 * 24];
            for (int i = 0; i < 32 * 24; ++i)
            {
                double z = i == 101 ? 0 : 2 + 0.01 * Math.Sin(3 * i);
                seen[3 * i] = (i % 32 - 16) * z / 40;
                seen[3 * i + 1] = (i / 32 - 12) * z / 40;
                seen[3 * i + 2] = z;
            }
            double[] moved = DepthImage.Smooth(
                seen, 32, 24, out double[] normals, out DepthImageInfo info, new DepthImageOptions { Noise = 0.002 });
            Assert.Equal(32L * 24 - 1, info.Seen);
            Assert.Equal(40.0, info.FocalLength, 1e-9);
            Assert.True(double.IsNaN(moved[3 * 101 + 2]) && normals[3 * 101 + 2] == 0);
            Assert.True(Math.Abs(moved[3 * 400 + 2] - 2) < 0.003 && normals[3 * 400 + 2] < -0.99);
            double[] kept = DepthImage.Smooth(
                seen, 32, 24, out normals, out info, new DepthImageOptions { KeepPoints = true, Smoothing = 2 });
            Assert.Equal(seen[3 * 400 + 2], kept[3 * 400 + 2]);
            Assert.Throws<InvalidArgumentException>(
                () => DepthImage.Smooth(seen, 24, 32, out double[] none, out DepthImageInfo nothing));
        }

        [Fact]
        public void NormalsAreFoundAndTurned()
        {
            double[] inward = Points.Select(x => -x).ToArray();
            double[] found = Orientation.Find(Points, default(ArrayView), out OrientationInfo info);
            double[] turned = Orientation.Find(Points, inward, out OrientationInfo repair);
            Assert.Equal(Normals.None, info.Found);
            Assert.Equal(60L, info.Made);
            Assert.True(info.Closed && info.Confidence > 0.9);
            Assert.Equal(Normals.Inward, repair.Found);
            Assert.Equal(60L, repair.Turned);
            Assert.Equal(Points, turned);
            for (int i = 0; i < 180; ++i)
            {
                Assert.Equal(Points[i], found[i], 0.1);
            }
            using (Model model = Model.Fit(Points, default(ArrayView), new FitOptions { NormalMode = Normals.None }))
            {
                Assert.Equal(Normals.None, model.Info.NormalsFound);
                Assert.True(model.Info.NormalsConfidence > 0.9);
            }
            using (Model model = Model.Fit((ArrayView)Points, (ArrayView)inward))
            {
                Assert.True(model.Info.NormalsInward);
            }
            Assert.Throws<InvalidArgumentException>(
                () => Orientation.Find(new double[9], default(ArrayView), out OrientationInfo none));
        }

        [Fact]
        public void FloatsStructsAndNativeMemoryGiveTheSameBits()
        {
            float[] floats = Shapes.ToFloats(Points);
            var structs = new Vector3f[60];
            for (int i = 0; i < 60; ++i)
            {
                structs[i] = new Vector3f { X = floats[3 * i], Y = floats[3 * i + 1], Z = floats[3 * i + 2] };
            }
            ArrayView view = ArrayView.Of(structs, ScalarType.Float32, 3);
            IntPtr memory = Marshal.AllocHGlobal(floats.Length * 4);
            try
            {
                Marshal.Copy(floats, 0, memory, floats.Length);
                ArrayView native = ArrayView.At(memory, 60, ScalarType.Float32, 3);
                double[] expected = ValueAtOrigin(floats, floats);
                Assert.Equal(expected, ValueAtOrigin(view, view));
                Assert.Equal(expected, ValueAtOrigin(native, native));
            }
            finally
            {
                Marshal.FreeHGlobal(memory);
            }
        }

        [Fact]
        public void ResultsAreWrittenToTheCallersMemory()
        {
            using (Model model = Shapes.FitSphere())
            {
                double[] expected = model.Evaluate(Points).Value;
                var value = new double[60];
                var gradient = new float[180];
                model.EvaluateInto(Points, value, gradient);
                Assert.Equal(expected, value);
                Assert.NotEqual(0f, gradient[0]);
                var structs = new Vector3f[60];
                model.EvaluateInto(Points, default(ArrayView), ArrayView.Of(structs, ScalarType.Float32, 3));
                Assert.Equal(gradient[177], structs[59].X);
                Assert.Equal(0f, structs[59].Unused);
                InvalidArgumentException wrong =
                    Assert.Throws<InvalidArgumentException>(() => model.EvaluateInto(Points, new double[59]));
                Assert.Contains("value", wrong.Message);
            }
        }

        [Fact]
        public void EveryOptionOfAFitReachesTheLibrary()
        {
            var options = new FitOptions
            {
                Kernel = Kernel.WendlandC2,
                KernelRadius = 1.5,
                PolynomialDegree = 0,
                Regularization = 0.01,
                Solver = Solver.Direct,
                MaximumCentres = 20,
            };
            using (Model model = Model.Fit((ArrayView)Points, (ArrayView)Points, options))
            {
                ModelInfo info = model.Info;
                Assert.Equal(Kernel.WendlandC2, info.Kernel);
                Assert.Equal(1.5, info.KernelRadius, 1e-12);
                Assert.Equal(0, info.PolynomialDegree);
                Assert.Equal(0.01, info.Regularization, 1e-12);
                Assert.Equal(Solver.Direct, info.Solver);
                Assert.Equal(SolverReason.Requested, info.SolverReason);
                Assert.InRange(info.Centres, 1L, 20L);
            }
            Refused(new FitOptions { PolynomialDegree = 7 }, "polynomial_degree");
            Refused(new FitOptions { FlippedNormals = (Repair)77 }, "flipped_normals");
        }

        [Fact]
        public void PointsAreProjected()
        {
            using (Model model = Model.Fit((ArrayView)Points, (ArrayView)Points))
            {
                double[] far = Array.ConvertAll(Points, number => 1.2 * number);
                Projection projection = model.Project(far);
                Assert.Equal(60L, projection.Converged);
                Assert.True(projection.Status.All(status => status == ProjectionStatus.Converged));
                Assert.Equal(1, Shapes.Length(projection.Position, 7), 0.01);
                Assert.Equal(1, Shapes.Length(projection.Normal, 7), 1e-12);
                model.ProjectInto(far, far); // in place
                Assert.Equal(projection.Position, far);
                Projection hasty = model.Project(Array.ConvertAll(Points, number => 1.2 * number),
                    new ProjectOptions { EvaluationLimit = 1, Tolerance = 1e-15 });
                Assert.True(hasty.Converged < 60);
                Assert.True(hasty.Status.Contains(ProjectionStatus.NotConverged));
            }
        }

        [Fact]
        public void ASphereIsCurvedEverywhere()
        {
            double[] points = Shapes.Sphere(200);
            using (Model model = Model.Fit((ArrayView)points, (ArrayView)points))
            {
                Curvature curvature = model.Curvature(Points);
                for (int i = 0; i < 60; ++i)
                {
                    Assert.Equal(-1, curvature.K1[i], 0.1);
                    Assert.Equal(-1, curvature.K2[i], 0.1);
                    Assert.Equal(1, Shapes.Length(curvature.D1, i), 1e-9);
                }
                Assert.Equal(180, curvature.D2.Length);
                Assert.Equal(60, curvature.Confidence.Length);
            }
        }

        [Fact]
        public void RaysMeetASphereTwice()
        {
            using (Model model = Model.FromFunction(Ball, (-1, -1, -1), (1, 1, 1)))
            {
                double[] origins = { 0, 0, 3, 5, 0, 3 }, directions = { 0, 0, -1, 0, 0, -1 };
                RayHits hits = model.CastRays(origins, directions, new CastOptions { MaximumHits = 3 });
                Assert.Equal(new uint[] { 2, 0 }, hits.Hits);
                Assert.Equal(1L, hits.HitRays);
                Assert.Equal(2, hits.T[0], 1e-8);
                Assert.Equal(4, hits.T[1], 1e-8);
                Assert.True(double.IsPositiveInfinity(hits.T[2]) && double.IsPositiveInfinity(hits.T[3]));
                Assert.Equal(1, hits.Position[2], 1e-8);
                Assert.Equal(-1, hits.Normal[5], 1e-6);
                Assert.Equal(1, (int)hits.Entering[0]);
                Assert.Equal(0, (int)hits.Entering[1]);
                Assert.Equal(new[] { RayStatus.Hit, RayStatus.Miss }, hits.Status);
                using (LineSet lines = model.LineSet())
                {
                    var byMesh = new CastOptions { MaximumHits = 3, LineSet = lines };
                    Assert.Equal(2, model.CastRays(origins, directions, byMesh).T[0], 1e-8);
                    byMesh.Refine = false;
                    RayHits onMesh = model.CastRays(origins, directions, byMesh);
                    Assert.Equal(2, onMesh.T[0], 0.01);
                    Assert.Equal(new uint[] { 2, 0 }, onMesh.Hits);
                }
                Assert.Equal(new[] { true, false }, model.Contains(new[] { 0, 0, 0.9, 0, 0, 1.1 }));
                Assert.InRange(model.Lipschitz(), 1.0, 3.0);
                Assert.Throws<InvalidArgumentException>(
                    () => model.CastRays(origins, directions, new CastOptions { MaximumHits = 0 }));
                Assert.Throws<InvalidArgumentException>(() => model.CastRays(origins, new double[] { 0, 0, 1 }));
            }
        }

        [Fact]
        public void AModelCanBeAFunction()
        {
            int calls = 0;
            ImplicitFunction function = (points, value, gradient, hessian) =>
            {
                ++calls;
                Ball(points, value, null, null);
                Assert.Null(hessian);
                for (int i = 0; gradient != null && i < value.Length; ++i)
                {
                    double length = Shapes.Length(points, i);
                    for (int k = 0; k < 3; ++k)
                    {
                        gradient[3 * i + k] = points[3 * i + k] / length;
                    }
                }
            };
            var options = new FunctionOptions { HasGradient = true };
            using (Model model = Model.FromFunction(function, (-1, -1, -1), (1, 1, 1), options))
            {
                Evaluation at = model.Evaluate(new double[] { 0, 3, 0 }, true, true);
                Assert.Equal(2, at.Value[0], 1e-12);
                Assert.Equal(1, at.Gradient[1], 1e-12);
                Assert.Equal(1.0 / 3, at.Hessian[0], 1e-3);
                Assert.True(calls > 0);
                Assert.Equal(Kernel.Custom, model.Info.Kernel);
                Assert.Equal(0L, model.View(ModelAttribute.Position).Count);
            }
        }

        [Fact]
        public void ViewsOutliveTheirModel()
        {
            NativeView view;
            using (Model model = Shapes.FitSphere())
            {
                view = model.View(ModelAttribute.Position);
            }
            Assert.Equal(6L, view.Count);
            Assert.Equal(3, view.Components);
            Assert.Equal(ScalarType.Float64, view.Scalar);
            double[] centres = view.ToArray<double>();
            Assert.Equal(18, centres.Length);
            Assert.Equal(6, centres.Count(number => Math.Abs(number) == 1));
            Assert.Throws<InvalidCastException>(() => view.ToArray<float>());
            view.Dispose();
            Assert.Throws<ObjectDisposedException>(() => view.Data);
            Assert.Throws<ObjectDisposedException>(() => view.ToArray<double>());
        }

        private static void Ball(double[] points, double[] value, double[] gradient, double[] hessian)
        {
            for (int i = 0; i < value.Length; ++i)
            {
                value[i] = Shapes.Length(points, i) - 1;
            }
        }

        private static double[] ValueAtOrigin(ArrayView points, ArrayView normals)
        {
            using (Model model = Model.Fit(points, normals))
            {
                return model.Evaluate(new[] { 0.1, 0.2, 0.3 }).Value;
            }
        }

        private static void Refused(FitOptions options, string field)
        {
            InvalidArgumentException wrong = Assert.Throws<InvalidArgumentException>(
                () => Model.Fit((ArrayView)Points, (ArrayView)Points, options));
            Assert.Contains(field, wrong.Message);
        }
    }
}
