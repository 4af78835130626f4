// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
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
                Assert.Equal(marks.Count, info.Marks);
                Assert.Equal(1L, info.Layers);
                MarkLayer layer = Assert.Single(marks.Layers);
                Assert.Same(layer, marks["stipples"]);
                Assert.Throws<KeyNotFoundException>(() => marks["hatch"]);
                Assert.Equal(LayerKind.Stipples, layer.Kind);
                Assert.Equal(marks.Count, layer.Count);
                Assert.Equal(0L, layer.Strokes);
                Assert.True(marks.SeedPlacement.Attempted >= marks.SeedPlacement.Placed);
                float[] positions = layer.Positions();
                Assert.Equal(3 * marks.Count, (long)positions.Length);
                double[] absolute = new double[positions.Length];
                for (int i = 0; i < positions.Length; i += 3)
                {
                    absolute[i] = positions[i] + info.Origin.X;
                    absolute[i + 1] = positions[i + 1] + info.Origin.Y;
                    absolute[i + 2] = positions[i + 2] + info.Origin.Z;
                }
                Assert.True(model.Evaluate(absolute).Value.All(value => Math.Abs(value) < 1e-5));
                float[] ranks = layer.ToArray<float>(MarkAttribute.Rank);
                Assert.True(ranks.All(rank => rank >= 0 && rank < 1));
                using (NativeView levels = layer.View(MarkAttribute.Level))
                {
                    Assert.Equal(marks.Count, (long)levels.ToArray<byte>().Length);
                }
                using (NativeView none = layer.View(MarkAttribute.StrokeFirst))
                {
                    Assert.Equal(0L, none.Count);
                    Assert.Equal(0, none.ToArray<uint>().Length);
                }
            }
        }

        [Fact]
        public void EveryOptionReachesTheLibrary()
        {
            using (Model model = Shapes.FitSphere())
            {
                var published = new GenerateOptions
                {
                    Distribution = Distribution.Published,
                    SeedSource = SeedSource.Box,
                    BoxResolution = 4,
                    InitialStep = 0.2,
                    Layers = { new Layer { Levels = 2, WithCurvature = true } },
                };
                using (PointSet marks = model.Generate(published))
                {
                    Assert.Equal(Distribution.Published, marks.Info.Distribution);
                    Assert.Equal(SeedSource.Box, marks.Info.SeedSource);
                    MarkLayer layer = marks.Layers[0];
                    Assert.Equal(2, layer.Info.Levels);
                    Assert.Equal(0.2, layer.Info.Step, 1e-12);
                    PlacementInfo level = layer.Placement(1);
                    long dropped = level.DroppedNotConverged + level.DroppedStrayed + level.DroppedDegenerate
                        + level.DroppedBudget;
                    Assert.Equal(level.Attempted, level.Placed + dropped);
                    Assert.True(level.Attempted > 0);
                    Assert.Throws<InvalidArgumentException>(() => layer.Placement(3));
                    Assert.Equal(3 * marks.Count, (long)layer.ToArray<float>(MarkAttribute.Curvature).Length);
                }
                Layer lines = Layer.Hatch(0.3), combing = Layer.Hatch(0.3, name: "comb \u00e9");
                combing.Guide = HatchGuide.Combing;
                var strokes = new GenerateOptions { Layers = { lines, combing }, ToneRanges = ToneRanges.InTurn };
                using (PointSet marks = model.Generate(strokes))
                {
                    Assert.Equal(2, marks.Layers.Count);
                    Assert.Equal("hatch", marks.Layers[0].Name);
                    MarkLayer layer = marks["comb \u00e9"];
                    Assert.Equal(LayerKind.Hatch, layer.Kind);
                    Assert.Equal(0.3, layer.Info.Step, 1e-9);
                    Assert.True(layer.Strokes > 0);
                    uint[] first = layer.ToArray<uint>(MarkAttribute.StrokeFirst);
                    Assert.Equal(layer.Strokes + 1, (long)first.Length);
                    Assert.Equal(layer.Count, (long)first[first.Length - 1]);
                    using (NativeView places = layer.View(MarkAttribute.Stroke))
                    {
                        Assert.Equal(2, places.Components);
                        Assert.Equal(2 * places.Count, (long)places.ToArray<uint>().Length);
                    }
                }
                var seeded = Shapes.Stipples(50);
                seeded.SeedSource = SeedSource.Points;
                seeded.SeedPoints = Shapes.ToFloats(Shapes.Sphere(20));
                using (PointSet marks = model.Generate(seeded))
                {
                    Assert.Equal(SeedSource.Points, marks.Info.SeedSource);
                }
                Layer dark = Layer.Stipples(50);
                dark.ToneBegin = 0.5f;
                dark.ToneEnd = 1f;
                using (PointSet marks = model.Generate(new GenerateOptions { Layers = { dark, Layer.Stipples(30) } }))
                {
                    Assert.True(marks.Layers[0].ToArray<float>(MarkAttribute.Rank).All(rank => rank <= 0.5f));
                    Assert.True(marks.Layers[1].ToArray<float>(MarkAttribute.Rank).Any(rank => rank > 0.5f));
                }
                var shared = new GenerateOptions { Layers = { Layer.Stipples(), Layer.Hatch() }, SharedBudget = 400 };
                using (PointSet marks = model.Generate(shared))
                {
                    Assert.InRange(marks.Count, 200, 410);
                }
                Refused(model, new GenerateOptions { BoxResolution = -1 }, "box_resolution");
                Refused(model, new GenerateOptions { Layers = { new Layer { Name = string.Empty } } }, "name");
                Assert.Throws<ArgumentNullException>(() => model.Generate(new GenerateOptions { Layers = { null } }));
            }
        }

        [Fact]
        public void HatchingFollowsADirectionFunction()
        {
            using (Model model = Shapes.FitSphere())
            {
                Layer rings = Layer.Hatch(budget: 1500);
                rings.DirectionFunction = (positions, normals, directions) =>
                {
                    for (int i = 0; i < directions.Length; i += 3)
                    {
                        directions[i] = -positions[i + 1];
                        directions[i + 1] = positions[i];
                    }
                };
                using (PointSet marks = model.Generate(new GenerateOptions { Layers = { rings } }))
                {
                    MarkLayer layer = marks["hatch"];
                    Assert.True(layer.Strokes > 5);
                    float[] directions = layer.ToArray<float>(MarkAttribute.Direction);
                    float[] positions = layer.Positions();
                    int level = 0, along = 0;
                    for (int i = 0; i < layer.Count; ++i)
                    {
                        if (Math.Abs(positions[3 * i + 2]) < 0.7)
                        {
                            ++along;
                            level += Math.Abs(directions[3 * i + 2]) < 0.2 ? 1 : 0;
                        }
                    }
                    Assert.True(along > 50 && level > 0.9 * along, level + " of " + along);
                }
            }
        }

        [Fact]
        public void MarksFollowADensityFunction()
        {
            using (Model model = Shapes.FitSphere())
            {
                Layer upper = Layer.Stipples(300);
                upper.Density = Density.Callback;
                upper.DensityFunction = (positions, normals, density) =>
                {
                    for (int i = 0; i < density.Length; ++i)
                    {
                        density[i] = positions[3 * i + 2] > 0 ? 1 : 0;
                    }
                };
                using (PointSet marks = model.Generate(new GenerateOptions { Layers = { upper } }))
                {
                    Assert.True(marks.Count > 100);
                    Assert.InRange(marks.Info.BoundsMin.Z, -1e-3, 0.2);
                }
            }
        }

        [Fact]
        public void MarksAreMadeFromArrays()
        {
            double[] points = Shapes.Sphere(30);
            var own = new OwnLayer(points, Shapes.ToFloats(points))
            {
                Level = Enumerable.Repeat((byte)3, 30).ToArray(),
                Rank = Enumerable.Repeat(0.25, 30).ToArray(),
                StrokeFirst = new uint[] { 0, 10, 30 },
                StrokeDirection = new byte[] { 0, 1 },
                Width = Enumerable.Repeat(0.5f, 30).ToArray(),
                Name = "seam",
            };
            using (PointSet marks = PointSet.Create(own))
            {
                Assert.Equal(30L, marks.Count);
                MarkLayer layer = marks["seam"];
                Assert.Equal(LayerKind.Own, layer.Kind);
                Assert.Equal(2L, layer.Strokes);
                Assert.True(layer.ToArray<float>(MarkAttribute.Rank).All(rank => rank == 0.25f));
                Assert.True(layer.ToArray<float>(MarkAttribute.Width).All(width => width == 0.5f));
                Assert.True(layer.ToArray<byte>(MarkAttribute.Level).All(level => level == 3));
                uint[] stroke = layer.ToArray<uint>(MarkAttribute.Stroke);
                Assert.Equal(3u, stroke[58]); // 2 * stroke + direction
                Assert.Equal(19u, stroke[59]);
                Assert.Equal(new uint[] { 0, 10, 30 }, layer.ToArray<uint>(MarkAttribute.StrokeFirst));
            }
            own.Rank = new double[] { 1, 2 };
            Assert.Contains("rank", Assert.Throws<InvalidArgumentException>(() => PointSet.Create(own)).Message);
            own.Rank = new float[30];
            own.StrokeFirst = new uint[] { 0, 31 };
            Assert.Contains("stroke_first",
                Assert.Throws<InvalidArgumentException>(() => PointSet.Create(own)).Message);
            own.StrokeFirst = default(ArrayView);
            own.StrokeDirection = default(ArrayView);
            points[4] = double.NaN;
            Assert.Contains("position", Assert.Throws<InvalidArgumentException>(() => PointSet.Create(own)).Message);
        }

        [Fact]
        public void OwnLayersFollowThoseOfAnotherSet()
        {
            double[] points = Shapes.Sphere(30);
            var own = new OwnLayer(points, points);
            using (Model model = Shapes.FitSphere())
            using (PointSet stipples = Shapes.Stipple(model, 300))
            using (PointSet both = PointSet.Create(stipples, own))
            using (PointSet again = PointSet.Create(new[] { own }, stipples, 7))
            {
                Assert.Equal(new[] { "stipples", "own" }, both.Layers.Select(layer => layer.Name).ToArray());
                Assert.Equal(stipples.Count + 30, both.Count);
                Assert.Equal(stipples.Info.Origin, both.Info.Origin);
                Assert.Equal(stipples.Layers[0].Positions(), both.Layers[0].Positions());
                Assert.NotEqual(
                    both.Layers[1].ToArray<float>(MarkAttribute.Rank), again.Layers[1].ToArray<float>(MarkAttribute.Rank));
            }
        }

        [Fact]
        public void StepPatchesHaveTheStepsSize()
        {
            using (Model model = Shapes.FitSphere())
            {
                StepPatches patches = model.StepPatches(4, new GenerateOptions { InitialStep = 0.1 });
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
                using (Model again = Model.Load(file)) // both from one stream
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
                    Assert.Equal(marks.Layers[0].Positions(), marksAgain.Layers[0].Positions());
                }
            }
        }

        private static void Refused(Model model, GenerateOptions options, string field)
        {
            Assert.Contains(field,
                Assert.Throws<InvalidArgumentException>(() => model.Generate(options)).Message);
        }
    }
}
