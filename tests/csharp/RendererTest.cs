// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Text.RegularExpressions;
using Xunit;

namespace HrbfNpr.Tests
{
    public class RendererTest : IDisposable
    {
        private readonly Model model;
        private readonly PointSet marks;
        private readonly Camera camera;
        private readonly Renderer renderer = new Renderer();
        private readonly Style style = Style.Preset(Preset.ContourAndStipple);

        public RendererTest()
        {
            model = Shapes.FitSphere();
            marks = Shapes.Stipple(model, 2000);
            camera = Shapes.Look(marks, 64);
        }

        public void Dispose()
        {
            renderer.Dispose();
            marks.Dispose();
            model.Dispose();
        }

        [Fact]
        public void APictureHasInkAndPaper()
        {
            byte[] pixels = Shapes.Draw(renderer, new Item(marks, style), camera);
            Assert.Equal(64 * 64 * 4, pixels.Length);
            Assert.Equal(255, (int)pixels[0]);
            Assert.True(pixels.Where((value, index) => index % 4 == 0).Count(value => value < 128) > 50);
            DrawingInfo info = Shapes.Count(renderer, camera, new Item(marks, style));
            Assert.Equal(marks.Count, info.Marks);
            Assert.Equal(info.Marks, info.Outside + info.Front + info.Back + info.Silhouette + info.Culled);
            Assert.True(info.Shown > 0 && info.Bytes > 0 && info.ScratchBytes > 0 && info.NanosecondsClassify > 0);
        }

        [Fact]
        public void ImagesGoToArraysNativeMemoryAndBottomUpRows()
        {
            using (Drawing drawing = renderer.Draw(new Item(marks, style), camera))
            {
                byte[] expected = drawing.Rasterize();
                IntPtr memory = Marshal.AllocHGlobal(expected.Length);
                try
                {
                    drawing.Rasterize(memory, 64, 64);
                    var copy = new byte[expected.Length];
                    Marshal.Copy(memory, copy, 0, copy.Length);
                    Assert.Equal(expected, copy);
                }
                finally
                {
                    Marshal.FreeHGlobal(memory);
                }
                var upsideDown = new byte[expected.Length];
                drawing.Rasterize(upsideDown, 64, 64, options: new RasterOptions { RowStride = -256 });
                for (int row = 0; row < 64; ++row)
                {
                    Assert.Equal(
                        expected.Skip(256 * row).Take(256).ToArray(),
                        upsideDown.Skip(256 * (63 - row)).Take(256).ToArray());
                }
                var wide = new byte[64 * 300];
                drawing.Rasterize(wide, 64, 64, options: new RasterOptions { RowStride = 300 });
                Assert.Equal(expected.Skip(256).Take(256).ToArray(), wide.Skip(300).Take(256).ToArray());
                Assert.Throws<InvalidArgumentException>(() => drawing.Rasterize(new byte[10], 64, 64));
                Assert.Throws<InvalidArgumentException>(() => drawing.Rasterize(upsideDown, 0, 64));
                Assert.Throws<InvalidArgumentException>(() => drawing.Rasterize(
                    expected, 64, 64, PixelFormat.Rgba8, new RasterOptions { RowStride = 257 }));
            }
        }

        [Fact]
        public void FormatsAndOutputsAreWritten()
        {
            style.Ink = Color.Parse("#ff0000");
            using (Drawing drawing = renderer.Draw(new Item(marks, style), camera))
            {
                byte[] rgba = drawing.Rasterize();
                var bgra = new byte[rgba.Length];
                var depth = new float[4096];
                var id = new uint[4096];
                var kind = new byte[4096];
                var options = new RasterOptions { Depth = depth, Id = id, MarkClass = kind };
                drawing.Rasterize(bgra, 64, 64, PixelFormat.Bgra8, options);
                for (int i = 0; i < rgba.Length; i += 4)
                {
                    Assert.True(rgba[i] == bgra[i + 2] && rgba[i + 1] == bgra[i + 1] && rgba[i + 2] == bgra[i]);
                }
                Assert.Equal(1f, depth[0]);
                Assert.InRange(depth[32 * 64 + 32], 0f, 0.9999f);
                Assert.Equal(0u, id[0]);
                Assert.True(id.All(number => number <= marks.Count) && id.Any(number => number > 0));
                Assert.True(kind.Contains((byte)MarkClass.Front) && !kind.Contains((byte)MarkClass.Silhouette));
                var wall = new float[4096]; // in front of everything
                var hidden = new byte[rgba.Length];
                drawing.Rasterize(hidden, 64, 64, options: new RasterOptions { HostDepth = wall });
                Assert.True(hidden.All(value => value == 255));
                Assert.Throws<InvalidArgumentException>(() => drawing.Rasterize(
                    hidden, 64, 64, PixelFormat.Rgba8, new RasterOptions { Depth = new float[7] }));
                Assert.Throws<InvalidArgumentException>(() => drawing.Rasterize(hidden, 64, 64, (PixelFormat)88));
            }
            style.Visibility = Visibility.Published;
            using (Drawing drawing = renderer.Draw(new Item(marks, style), camera))
            {
                var kind = new byte[4096];
                drawing.Rasterize(new byte[4 * 4096], 64, 64, PixelFormat.Rgba8, new RasterOptions { MarkClass = kind });
                Assert.True(kind.Contains((byte)MarkClass.Front) && kind.Contains((byte)MarkClass.Silhouette));
            }
        }

        [Fact]
        public void FloatsAndCoverageAreWritten()
        {
            style.Ink = Color.Parse("#ff0000");
            using (Drawing drawing = renderer.Draw(new Item(marks, style), camera))
            {
                byte[] rgba = drawing.Rasterize(), coverage = drawing.Rasterize(PixelFormat.Coverage8);
                Assert.Equal(4096, coverage.Length);
                var floats = new float[4 * 4096];
                drawing.Rasterize(floats, 64, 64);
                for (int i = 0; i < floats.Length; ++i)
                {
                    Assert.Equal(rgba[i], 255 * floats[i], 0.51);
                }
                // On white paper, the coverage of red ink is missing from green.
                for (int i = 0; i < 4096; ++i)
                {
                    Assert.Equal(255 - rgba[4 * i + 1], coverage[i], 1.0);
                }
                Assert.True(coverage.Any(value => value > 200) && coverage[0] == 0);
                byte[] bytes = drawing.Rasterize(PixelFormat.Rgba32fPremultiplied);
                Assert.Equal(floats[4 * 2080], BitConverter.ToSingle(bytes, 16 * 2080));
                Assert.Throws<InvalidArgumentException>(() => drawing.Rasterize(new float[4095 * 4], 64, 64));
                Assert.Throws<InvalidArgumentException>(
                    () => drawing.Rasterize(new byte[4095], 64, 64, PixelFormat.Coverage8));
            }
        }

        [Fact]
        public void APictureIsDrawnOverAnother()
        {
            style.Paper = new Color(1, 1, 1, 0);
            byte[] pixels = Enumerable.Repeat((byte)200, 64 * 64 * 4).ToArray();
            using (Drawing drawing = renderer.Draw(new Item(marks, style), camera))
            {
                var options = new RasterOptions { Over = true, LinearLight = true };
                drawing.Rasterize(pixels, 64, 64, PixelFormat.Rgba8, options);
            }
            Assert.Equal(200, (int)pixels[0]);
            Assert.True(pixels.Any(value => value < 50));
        }

        [Fact]
        public void DotsAreWrittenAsVertices()
        {
            var layout = new VertexLayout().Add(VertexAttribute.Position).Add(VertexAttribute.Radius)
                .Add(VertexAttribute.Color).Add(VertexAttribute.IsPaper).Add(VertexAttribute.Id);
            Assert.Equal(12 + 4 + 4 + 4 + 4, layout.Stride);
            using (Drawing drawing = renderer.Draw(new Item(marks, style), camera))
            {
                Vertices vertices = drawing.Vertices(layout);
                Assert.Equal(vertices.Count * layout.Stride, (long)vertices.Data.Length);
                Assert.InRange(vertices.Count, 1, drawing.VertexBound().Vertices);
                Assert.Equal(drawing.Info.Dots, vertices.Count); // every vertex is a dot of ink
                Assert.Equal((uint)vertices.Count - 1, vertices.Indices[vertices.Count - 1]);
                byte[] data = vertices.Data;
                float x = BitConverter.ToSingle(data, 0), y = BitConverter.ToSingle(data, 4);
                float z = BitConverter.ToSingle(data, 8);
                Assert.Equal(1, Math.Sqrt(x * x + y * y + z * z), 0.05);
                Assert.True(BitConverter.ToUInt32(data, 24) > 0);
                BufferTooSmallException small = Assert.Throws<BufferTooSmallException>(
                    () => drawing.WriteVertices(layout, IntPtr.Zero, 0));
                Assert.Equal(Status.BufferTooSmall, small.Status);
                var placed = new VertexLayout().Add(VertexAttribute.Window, ScalarType.Float32, 4);
                placed.Stride = 32;
                byte[] windows = drawing.Vertices(placed).Data;
                Assert.Equal(32 * vertices.Count, (long)windows.Length);
                Assert.InRange(BitConverter.ToSingle(windows, 4), 0f, 64f);
                Assert.Throws<InvalidArgumentException>(() => drawing.Vertices(new VertexLayout()));
                Assert.Throws<InvalidArgumentException>(() => drawing.Vertices(
                    new VertexLayout().Add(VertexAttribute.Position, ScalarType.Uint8, 0)));
                Assert.Throws<InvalidArgumentException>(
                    () => drawing.Vertices(new VertexLayout((Primitive)9).Add(VertexAttribute.Position)));
            }
        }

        [Fact]
        public void ItemsHaveTransformsAndModels()
        {
            double[] shift = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 100, 0, 0, 1 };
            DrawingInfo info = Shapes.Count(
                renderer, camera, new Item(marks, style), new Item(marks, style) { Transform = shift });
            Assert.Equal(2L, info.Items);
            Assert.Equal(2 * marks.Count, info.Marks);
            Assert.Equal(marks.Count, info.Outside);
            Shapes.Draw(renderer, marks, camera); // in the default style
            Shapes.Count(renderer, camera, new Item(marks, style) { Model = model });
            Assert.Equal(0L, Shapes.Count(renderer, camera).Marks);
            Assert.Contains("transform", Assert.Throws<InvalidArgumentException>(
                () => renderer.Draw(new Item(marks, style) { Transform = new double[16] }, camera)).Message);
            Assert.Throws<InvalidArgumentException>(() => new Item(marks) { Transform = new double[3] });
            Assert.Throws<ArgumentNullException>(() => renderer.Draw(new Item[] { null }, camera));
            Assert.Throws<ArgumentNullException>(() => renderer.Draw((Item)null, camera));
            Assert.Throws<ArgumentNullException>(() => renderer.Draw(marks, null));
            Assert.Throws<InvalidArgumentException>(() => renderer.Draw(marks, new Camera()));
        }

        [Fact]
        public void AToneFunctionIsCalled()
        {
            var seen = 0;
            style.Tone = Tone.Callback;
            style.ToneFunction = (positions, normals, tau) =>
            {
                seen += tau.Length;
                for (int i = 0; i < tau.Length; ++i)
                {
                    tau[i] = 1;
                }
            };
            style.Layers[0].Contours = false;
            DrawingInfo light = Shapes.Count(renderer, camera, new Item(marks, style));
            Assert.True(seen > 0);
            Assert.Equal(0L, light.Shown);
            style.Tone = Tone.None;
            Assert.True(Shapes.Count(renderer, camera, new Item(marks, style)).Shown > 100);
        }

        [Fact]
        public void StylesArePlainData()
        {
            var names = new List<string>();
            foreach (Preset preset in Enum.GetValues(typeof(Preset)))
            {
                Style made = Style.Preset(preset);
                names.Add(Style.PresetName(preset));
                Assert.True(made.Layers.Count > 0 && GenerateOptions.ForPreset(preset).Layers.Count > 0);
                Shapes.Count(renderer, camera, new Item(marks, made));
            }
            Assert.Equal(names.Count, names.Distinct().Count());
            Assert.True(names.Contains("cross-hatch"));
            Assert.Null(Style.PresetName((Preset)names.Count)); // the enumeration has all presets of the library
            Assert.Null(Style.PresetName((Preset)99));
            Assert.Throws<InvalidArgumentException>(() => Style.Preset((Preset)99));

            var defaults = new Style();
            Assert.Equal(0, defaults.Layers.Count);
            defaults.HaloWidth = 7;
            defaults.Layers.Add(new LayerStyle(LayerKind.Stipples) { Radius = 3, Name = "stipples" });
            Style copy = defaults.Clone();
            copy.Layers[0].Radius = 4;
            Assert.Equal(7f, copy.HaloWidth);
            Assert.Equal(3f, defaults.Layers[0].Radius);
            Assert.Equal("stipples", copy.Layers[0].Name);
            defaults.SilhouetteThreshold = -1;
            Assert.Contains("silhouette_threshold", Assert.Throws<InvalidArgumentException>(
                () => renderer.Draw(new Item(marks, defaults), camera)).Message);
            Assert.Equal(new Color(1, 0, 0, 128 / 255f), Color.Parse("#ff000080"));
            Assert.Throws<FormatException>(() => Color.Parse("#ff00"));
            Assert.Throws<FormatException>(() => Color.Parse("red"));
        }

        [Fact]
        public void CamerasArePlainData()
        {
            Camera look = Camera.LookAt((0, 0, 5), (0, 0, 0), (0, 1, 0), DepthConvention.ZeroToOne);
            Assert.Equal(-5, look.View[14], 1e-12);
            Camera lens = look.Perspective(0.5, 80, 60, 1, 10);
            Assert.Equal(80, lens.Width);
            Assert.Equal(60, lens.Height);
            Assert.Equal(0, look.Width);
            Assert.Equal(DepthConvention.ZeroToOne, lens.DepthConvention);
            Assert.Equal(look.View, lens.View);
            Camera flat = look.Orthographic(3, 80, 60, -1, 10);
            Assert.NotEqual(lens.Projection, flat.Projection);
            var same = new Camera(lens.View, lens.Projection, 0, 0, 80, 60, DepthConvention.ZeroToOne);
            Assert.Equal(Shapes.Draw(renderer, marks, lens), Shapes.Draw(renderer, marks, same));
            float[] positions = marks.Layers[0].Positions();
            Camera tight = Camera.FitPoints(positions, marks.Info.Origin, (0, 0, -1), (0, 1, 0), 64, 64);
            Assert.Equal(0L, Shapes.Count(renderer, tight, marks).Outside);
            Assert.Throws<InvalidArgumentException>(() => Camera.LookAt((0, 0, 0), (0, 0, 0), (0, 1, 0)));
            Assert.Throws<InvalidArgumentException>(() => look.Perspective(9, 80, 60, 1, 10));
            Assert.Throws<InvalidArgumentException>(() => look.Orthographic(3, 80, 60, 10, 1));
            Assert.Throws<InvalidArgumentException>(() => new Camera(new double[3], new double[16], 0, 0, 1, 1));
        }

        [Fact]
        public void ThePictureEqualsThatOfTheCProgram()
        {
            // The scene sphere-stipple of tests/scenes/draw_scene.
            using (PointSet scene = model.Generate(GenerateOptions.ForPreset(Preset.Stipple, 6000)))
            {
                Camera view = Shapes.Look(scene, 160);
                byte[] pixels = Shapes.Draw(renderer, new Item(scene, Style.Preset(Preset.Stipple)), view);
                byte[] file = File.ReadAllBytes(Environment.GetEnvironmentVariable("HRBFNPR_SCENE"));
                Assert.Equal(file.Skip(file.Length - pixels.Length).ToArray(), pixels);
            }
        }

        [Fact]
        public void TheQuickStartsInCSharpAndCDrawTheSamePicture()
        {
            string expected = Environment.GetEnvironmentVariable("HRBFNPR_QUICKSTART");
            if (string.IsNullOrEmpty(expected))
            {
                return; // this build has no examples
            }
            File.Delete("torus.ppm");
            File.Delete("torus.svg");
            Quickstart.Main();
            Assert.Equal(800L * 600 * 3 + 15, new FileInfo("torus.ppm").Length);
            // The sines of the samples may differ from those of the C library in their last bit. Then a few ends of
            // lines differ, too.
            double[][] wanted = Begins(File.ReadAllText(expected)), drawn = Begins(File.ReadAllText("torus.svg"));
            int alike = drawn.Count(at => wanted.Any(
                other => Math.Abs(at[0] - other[0]) + Math.Abs(at[1] - other[1]) < 0.05));
            Assert.InRange(drawn.Length, wanted.Length * 0.98, wanted.Length * 1.02);
            Assert.InRange(alike, (int)(0.98 * drawn.Length), drawn.Length);
        }

        /// <summary>The starts of the lines of an SVG, in mm.</summary>
        private static double[][] Begins(string svg)
        {
            return Regex.Matches(svg, @"M(-?[\d.]+) (-?[\d.]+)").Cast<Match>().Select(match => new[]
            {
                double.Parse(match.Groups[1].Value, CultureInfo.InvariantCulture),
                double.Parse(match.Groups[2].Value, CultureInfo.InvariantCulture),
            }).ToArray();
        }
    }
}
