// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace HrbfNpr.Tests
{
    public class FieldTest : IDisposable
    {
        private readonly Model model = Shapes.FitSphere();
        private readonly PointSet marks;

        public FieldTest()
        {
            marks = Shapes.Stipple(model, 2000);
        }

        public void Dispose()
        {
            marks.Dispose();
            model.Dispose();
        }

        private static Dictionary<string, Field> Named(string name, Field field)
        {
            return new Dictionary<string, Field> { { name, field } };
        }

        [Fact]
        public void ValuesOfTheNearestPlaceReachTheMarks()
        {
            var points = new double[] { 0, 0, 0, 4, 0, 0, 0, 4, 0 };
            var values = new double[] { 10, 50, 10 };
            using (Field field = Field.FromPoints(points, values, new[] { 0, 1, 2 }, range: (10.0, 50.0)))
            {
                Assert.Equal(FieldKind.Scalar, field.Kind);
                double[] got = field.Evaluate(new double[] { 1, 1, 5, -3, 0, 0 }, default(ArrayView), out double[] weights);
                Assert.Equal(0.25, got[0], 12);
                Assert.Equal(0, got[1], 12);
                Assert.Equal(new double[] { 1, 1 }, weights);
            }
            using (Field near = Field.FromPoints(points, new byte[] { 255, 0, 51, 0, 0, 0, 0, 0, 0 }, kind: FieldKind.Colour, reach: 1.2))
            using (PointSet coloured = marks.WithFields(Named("rgb", near)))
            {
                Assert.Equal(0, marks.Info.FieldCount);
                Assert.Equal(FieldKind.Colour, coloured.Fields["rgb"]);
                float[] colours = coloured.Layers[0].FieldValues("rgb");
                Assert.Equal(3 * coloured.Count, colours.Length);
                Assert.Equal(0.2f, colours.Where((value, i) => i % 3 == 2).Max(), 6);
                Assert.Throws<InvalidArgumentException>(() => coloured.Layers[0].FieldValues("heat"));
                using (PointSet loaded = PointSet.Load(coloured.ToBytes()))
                {
                    Assert.Equal(colours, loaded.Layers[0].FieldValues("rgb"));
                    Assert.Equal(coloured.Layers[0].FieldWeights("rgb"), loaded.Layers[0].FieldWeights("rgb"));
                }
                using (PointSet without = coloured.WithFields(Named("rgb", null)))
                {
                    Assert.Empty(without.Fields);
                }
            }
        }

        [Fact]
        public void FunctionsAreCalledAsLongAsTheFieldLives()
        {
            Field field = Field.FromFunction((positions, normals, values, weights) =>
            {
                for (int i = 0; i < values.Length; ++i)
                {
                    values[i] = positions[3 * i] + normals[3 * i + 1];
                    weights[i] = 0.5;
                }
            });
            GC.Collect();
            GC.WaitForPendingFinalizers();
            var move = new double[] { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1 };
            using (PointSet moved = marks.WithFields(Named("sum", field), move))
            {
                field.Dispose();
                float[] values = moved.Layers[0].FieldValues("sum");
                float[] positions = moved.Layers[0].Positions();
                for (int i = 0; i < values.Length; ++i)
                {
                    Assert.InRange(values[i] - positions[3 * i] - positions[3 * i + 1], 9.9, 10.1);
                }
                Assert.All(moved.Layers[0].FieldWeights("sum"), weight => Assert.Equal(0.5f, weight));
            }
            using (Field wrong = Field.FromFunction((positions, normals, values, weights) => throw new FormatException("no")))
            {
                var thrown = Assert.Throws<CallbackException>(() => marks.WithFields(Named("wrong", wrong)));
                Assert.IsType<FormatException>(thrown.InnerException);
                var layer = Layer.Stipples(100);
                layer.Density = Density.Field;
                layer.DensityField = wrong;
                var options = new GenerateOptions { Layers = { layer } };
                Assert.IsType<FormatException>(Assert.Throws<CallbackException>(() => model.Generate(options)).InnerException);
            }
            Assert.Throws<ObjectDisposedException>(() => marks.WithFields(Named("sum", field)));
        }

        [Fact]
        public void DabsAndImagesPaint()
        {
            var dab = new Dab { Position = (0, 0, 1), Normal = (0, 0, 1), Radius = 0.5, Value = 0.75, Strength = 0.5 };
            using (Field dabs = Field.FromDabs(new[] { dab }))
            {
                double[] got = dabs.Evaluate(
                    new double[] { 0, 0, 1, 0, 0, 2 }, new double[] { 0, 0, 1, 0, 0, 1 }, out double[] weights);
                Assert.Equal(new[] { 0.75, 0 }, got);
                Assert.Equal(new[] { 0.5, 0 }, weights);
            }
            Camera camera = Camera.FitBounds((-1.5, -1.5, -1.5), (1.5, 1.5, 1.5), (0, 0, -1), (0, 1, 0), 100, 100);
            byte[] green = Enumerable.Repeat(new byte[] { 0, 255, 0, 255 }, 6).SelectMany(pixel => pixel).ToArray();
            using (Field image = Field.FromImage(green, 3, 2, camera))
            using (PointSet painted = marks.WithFields(Named("photo", image)))
            {
                float[] values = painted.Layers[0].FieldValues("photo");
                float[] weights = painted.Layers[0].FieldWeights("photo");
                float[] positions = painted.Layers[0].Positions();
                for (int i = 0; i < weights.Length; ++i)
                {
                    if (Math.Abs(positions[3 * i + 2]) > 0.4)
                    {
                        Assert.Equal(positions[3 * i + 2] > 0 ? 1f : 0f, weights[i], 5);
                        Assert.Equal(weights[i], values[3 * i + 1], 5);
                    }
                }
            }
            Assert.Throws<InvalidArgumentException>(() => Field.FromImage(new byte[20], 3, 2, camera));
        }

        [Fact]
        public void LayersFollowFields()
        {
            using (Field half = Field.FromFunction((positions, normals, values, weights) =>
            {
                for (int i = 0; i < values.Length; ++i)
                {
                    values[i] = positions[3 * i] < 0 ? 0 : 1;
                }
            }))
            using (Field upward = Field.FromPoints(new double[3], new double[] { 0, 0, 1 }, kind: FieldKind.Direction))
            {
                var stipples = Layer.Stipples(1000);
                stipples.Density = Density.Field;
                stipples.DensityField = half;
                var hatch = Layer.Hatch(budget: 1000);
                hatch.DirectionField = upward;
                using (PointSet made = model.Generate(new GenerateOptions { Layers = { stipples, hatch } }))
                {
                    float[] positions = made.Layers[0].Positions();
                    Assert.All(Enumerable.Range(0, positions.Length / 3), i => Assert.True(positions[3 * i] > -1e-4));
                    float[] along = made.Layers[1].ToArray<float>(MarkAttribute.Direction);
                    float[] at = made.Layers[1].Positions();
                    Assert.All(
                        Enumerable.Range(0, at.Length / 3).Where(i => Math.Abs(at[3 * i + 2]) < 0.5),
                        i => Assert.True(Math.Abs(along[3 * i + 2]) > 0.8));
                }
                hatch.DirectionField = half;
                Assert.Throws<InvalidArgumentException>(
                    () => model.Generate(new GenerateOptions { Layers = { hatch } }));
            }
        }

        [Fact]
        public void StylesNameFields()
        {
            var style = new Style { Palette = { Color.Parse("#ff0000"), new Color(0, 0, 1) } };
            style.Layers.Add(new LayerStyle
            {
                DensityField = "a",
                ToneField = "b",
                WidthField = "c",
                InkField = "d",
                MaskField = "e",
                ToneFieldRule = FieldRule.Scale,
                PaletteRule = PaletteRule.Mixed,
            });
            Style copy = style.Clone();
            style.Layers[0].ToneField = null;
            style.Palette.Clear();
            LayerStyle layer = copy.Layers[0];
            Assert.Equal("abcde", layer.DensityField + layer.ToneField + layer.WidthField + layer.InkField + layer.MaskField);
            Assert.Equal(FieldRule.Scale, layer.ToneFieldRule);
            Assert.Equal(PaletteRule.Mixed, layer.PaletteRule);
            Assert.Equal(new Color(0, 0, 1), copy.Palette[1]);
            Assert.Null(new LayerStyle().InkField);
        }
    }
}
