using System;
using System.IO;
using System.Linq;
using Xunit;

namespace HrbfNpr.Tests
{
    public class PointSetTest
    {
        [Fact]
        public void MarksLieOnTheSurface()
        {
            using (Model model = Shapes.FitSphere())
            using (PointSet marks = Shapes.Stipple(model, 500))
            {
                Assert.InRange(marks.Count, 490, 510);
                PointSetInfo info = marks.Info;
                Assert.Equal(Distribution.BlueNoise, info.Distribution);
                Assert.Equal(marks.Count, info[Group.Stipple].Count);
                Assert.Equal(0L, info[Group.Combing].Count);
                float[] positions = marks.Positions(Group.Stipple);
                Assert.Equal(3 * marks.Count, (long)positions.Length);
                double[] absolute = new double[positions.Length];
                for (int i = 0; i < positions.Length; i += 3)
                {
                    absolute[i] = positions[i] + info.Origin.X;
                    absolute[i + 1] = positions[i + 1] + info.Origin.Y;
                    absolute[i + 2] = positions[i + 2] + info.Origin.Z;
                }
                Assert.True(model.Evaluate(absolute).Value.All(value => Math.Abs(value) < 1e-5));
                float[] ranks = marks.Floats(Group.Stipple, MarkAttribute.Rank);
                Assert.True(ranks.All(rank => rank >= 0 && rank < 1));
                using (NativeView levels = marks.View(Group.Stipple, MarkAttribute.Level))
                {
                    Assert.Equal(marks.Count, (long)levels.ToArray<byte>().Length);
                }
                using (NativeView none = marks.View(Group.Curvature, MarkAttribute.Position))
                {
                    Assert.Equal(0L, none.Count);
                    Assert.Equal(0, none.ToArray<float>().Length);
                }
            }
        }

        [Fact]
        public void EveryOptionReachesTheLibrary()
        {
            using (Model model = Shapes.FitSphere())
            {
                var paper = new GenerateOptions { Distribution = Distribution.Paper, SeedSource = SeedSource.Box };
                paper.BoxResolution = 4;
                paper.Stipple.Levels = 2;
                paper.CurvatureOfStipples = true;
                paper.InitialStep = 0.2;
                using (PointSet marks = PointSet.Generate(model, paper))
                {
                    PointSetInfo info = marks.Info;
                    Assert.Equal(SeedSource.Box, info.SeedSource);
                    Assert.Equal(2, info[Group.Stipple].Levels);
                    Assert.Equal(0.2, info[Group.Stipple].Step, 1e-12);
                    LevelInfo level = info[Group.Stipple].Level(1);
                    long dropped = level.DroppedNotConverged + level.DroppedStrayed + level.DroppedDegenerate
                        + level.DroppedBudget;
                    Assert.Equal(level.Attempted, level.Placed + dropped);
                    Assert.True(level.Attempted > 0);
                    Assert.Equal(3 * marks.Count, (long)marks.Floats(Group.Stipple, MarkAttribute.Curvature).Length);
                }
                var strokes = new GenerateOptions { Groups = Groups.Curvature | Groups.Combing, StrokeSeparation = 0.3 };
                strokes.StrokeField = StrokeField.Line;
                strokes.Order = LayerOrder.Layered;
                using (PointSet marks = PointSet.Generate(model, strokes))
                {
                    Assert.Equal(0L, marks.Info[Group.Stipple].Count);
                    Assert.True(marks.Info[Group.Combing].Strokes > 0);
                    using (NativeView places = marks.View(Group.Combing, MarkAttribute.Stroke))
                    {
                        Assert.Equal(2, places.Components);
                        Assert.Equal(2 * places.Count, (long)places.ToArray<uint>().Length);
                    }
                }
                var seeded = new GenerateOptions { SeedSource = SeedSource.Points, Budget = 50 };
                seeded.SeedPoints = Shapes.ToFloats(Shapes.Sphere(20));
                using (PointSet marks = PointSet.Generate(model, seeded))
                {
                    Assert.Equal(SeedSource.Points, marks.Info.SeedSource);
                }
                var layers = new GenerateOptions { Budget = 50 };
                layers.SetLayer(Layer.Stipple, 0.5f, 1f);
                using (PointSet marks = PointSet.Generate(model, layers))
                {
                    Assert.True(marks.Floats(Group.Stipple, MarkAttribute.Rank).All(rank => rank <= 0.5f));
                }
                Refused(model, new GenerateOptions { BoxResolution = -1 }, "box_resolution");
                Refused(model, new GenerateOptions { BoxJitter = 2 }, "box_jitter");
                Refused(model, new GenerateOptions { Groups = (Groups)64 }, "groups");
                Refused(model, new GenerateOptions { Density = (Density)9 }, "density");
            }
        }

        [Fact]
        public void ADensityOfOnesOwn()
        {
            using (Model model = Shapes.FitSphere())
            {
                var options = new GenerateOptions { Budget = 300, Density = Density.Callback };
                options.DensityFunction = (positions, normals, density) =>
                {
                    for (int i = 0; i < density.Length; ++i)
                    {
                        density[i] = positions[3 * i + 2] > 0 ? 1 : 0;
                    }
                };
                using (PointSet marks = PointSet.Generate(model, options))
                {
                    Assert.True(marks.Count > 100);
                    Assert.InRange(marks.Info.BoundsMin.Z, -1e-3, 0.2);
                }
            }
        }

        [Fact]
        public void MarksFromArrays()
        {
            double[] points = Shapes.Sphere(30);
            var arrays = new GroupArrays { Position = points, Normal = Shapes.ToFloats(points) };
            arrays.Level = Enumerable.Repeat((byte)3, 30).ToArray();
            arrays.Stroke = Enumerable.Range(0, 60).Select(number => (uint)number).ToArray();
            arrays.Rank = Enumerable.Repeat(0.25, 30).ToArray();
            using (PointSet marks = PointSet.FromArrays(arrays))
            {
                Assert.Equal(30L, marks.Count);
                Assert.True(marks.Floats(Group.Stipple, MarkAttribute.Rank).All(rank => rank == 0.25f));
                Assert.True(marks.View(Group.Stipple, MarkAttribute.Level).ToArray<byte>().All(level => level == 3));
                Assert.Equal(59u, marks.View(Group.Stipple, MarkAttribute.Stroke).ToArray<uint>()[59]);
            }
            arrays.Rank = new double[] { 1, 2 };
            Assert.Contains("rank",
                Assert.Throws<InvalidArgumentException>(() => PointSet.FromArrays(arrays)).Message);
            arrays.Rank = new float[30];
            points[4] = double.NaN;
            Assert.Contains("position",
                Assert.Throws<InvalidArgumentException>(() => PointSet.FromArrays(arrays)).Message);
        }

        [Fact]
        public void StepPatches()
        {
            using (Model model = Shapes.FitSphere())
            {
                StepPatches patches = PointSet.StepPatches(model, 4, new GenerateOptions { InitialStep = 0.1 });
                Assert.Equal(0.1, patches.Step, 1e-12);
                Assert.Equal(48, patches.Corners.Length);
                double dx = patches.Corners[0] - patches.Corners[3], dy = patches.Corners[1] - patches.Corners[4];
                double dz = patches.Corners[2] - patches.Corners[5];
                Assert.Equal(0.2, Math.Sqrt(dx * dx + dy * dy + dz * dz), 1e-9);
            }
        }

        [Fact]
        public void ModelsAndMarksAreSavedAndLoaded()
        {
            using (Model model = Shapes.FitSphere())
            using (PointSet marks = Shapes.Stipple(model, 200))
            using (var file = new MemoryStream())
            {
                model.Save(file);
                marks.Save(file);
                byte[] first = model.ToBytes(), second = marks.ToBytes();
                Assert.Equal(first.Concat(second).ToArray(), file.ToArray());
                file.Position = 0;
                using (Model again = Model.Load(file)) // one after the other from one stream
                using (PointSet marksAgain = PointSet.Load(file))
                {
                    Assert.Equal(first, again.ToBytes());
                    Assert.Equal(second, marksAgain.ToBytes());
                    double[] at = { 0.3, 0.2, 0.9 };
                    Assert.Equal(model.Evaluate(at).Value, again.Evaluate(at).Value);
                }
                using (Model again = Model.Load(first))
                using (PointSet marksAgain = PointSet.Load(second))
                {
                    Assert.Equal(first, again.ToBytes());
                    Assert.Equal(marks.Positions(Group.Stipple), marksAgain.Positions(Group.Stipple));
                }
            }
        }

        private static void Refused(Model model, GenerateOptions options, string field)
        {
            Assert.Contains(field,
                Assert.Throws<InvalidArgumentException>(() => PointSet.Generate(model, options)).Message);
        }
    }
}
