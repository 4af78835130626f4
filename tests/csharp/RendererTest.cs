using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using Xunit;

namespace HrbfNpr.Tests
{
    public class RendererTest : IDisposable
    {
        private readonly Model model;
        private readonly PointSet marks;
        private readonly Camera camera;
        private readonly Renderer renderer = new Renderer();
        private readonly Style style = new Style(StylePreset.ContourAndStipple);

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
            byte[] pixels = renderer.Draw(camera, new Item(marks, style));
            Assert.Equal(64 * 64 * 4, pixels.Length);
            Assert.Equal(255, (int)pixels[0]);
            Assert.True(pixels.Where((value, index) => index % 4 == 0).Count(value => value < 128) > 50);
            FrameInfo info = renderer.Info;
            Assert.Equal(marks.Count, info.Marks);
            Assert.Equal(info.Marks, info.Outside + info.Front + info.Back + info.Silhouette + info.Culled);
            Assert.True(info.Shown > 0 && info.NanosecondsDraw > 0 && info.ScratchBytes > 0);
        }

        [Fact]
        public void ArraysNativeMemoryAndRowsFromTheBottom()
        {
            byte[] expected = renderer.Draw(camera, new Item(marks, style));
            IntPtr memory = Marshal.AllocHGlobal(expected.Length);
            try
            {
                renderer.Draw(memory, 64, 64);
                var copy = new byte[expected.Length];
                Marshal.Copy(memory, copy, 0, copy.Length);
                Assert.Equal(expected, copy);
            }
            finally
            {
                Marshal.FreeHGlobal(memory);
            }
            var upsideDown = new byte[expected.Length];
            renderer.Draw(upsideDown, 64, 64, new DrawOptions { RowStride = -256 });
            for (int row = 0; row < 64; ++row)
            {
                Assert.Equal(
                    expected.Skip(256 * row).Take(256).ToArray(), upsideDown.Skip(256 * (63 - row)).Take(256).ToArray());
            }
            var wide = new byte[64 * 300];
            renderer.Draw(wide, 64, 64, new DrawOptions { RowStride = 300 });
            Assert.Equal(expected.Skip(256).Take(256).ToArray(), wide.Skip(300).Take(256).ToArray());
            Assert.Throws<InvalidArgumentException>(() => renderer.Draw(new byte[10], 64, 64));
            Assert.Throws<InvalidArgumentException>(() => renderer.Draw(upsideDown, 0, 64));
            Assert.Throws<InvalidArgumentException>(
                () => renderer.Draw(expected, 64, 64, new DrawOptions { RowStride = 257 }));
        }

        [Fact]
        public void FormatsAndOutputs()
        {
            style.Ink = Color.Parse("#ff0000");
            byte[] rgba = renderer.Draw(camera, new Item(marks, style));
            var bgra = new byte[rgba.Length];
            var depth = new float[4096];
            var id = new uint[4096];
            var kind = new byte[4096];
            var options = new DrawOptions { Format = PixelFormat.Bgra8, Depth = depth, Id = id, Class = kind };
            renderer.Draw(bgra, 64, 64, options);
            for (int i = 0; i < rgba.Length; i += 4)
            {
                Assert.True(rgba[i] == bgra[i + 2] && rgba[i + 1] == bgra[i + 1] && rgba[i + 2] == bgra[i]);
            }
            Assert.Equal(1f, depth[0]);
            Assert.InRange(depth[32 * 64 + 32], 0f, 0.9999f);
            Assert.Equal(0u, id[0]);
            Assert.True(id.All(number => number <= marks.Count) && id.Any(number => number > 0));
            Assert.True(kind.Contains((byte)MarkClass.Front) && kind.Contains((byte)MarkClass.Silhouette));
            var wall = new float[4096]; // nearer than everything
            var hidden = new byte[rgba.Length];
            renderer.Draw(hidden, 64, 64, new DrawOptions { HostDepth = wall });
            Assert.True(hidden.All(value => value == 255));
            Assert.Throws<InvalidArgumentException>(
                () => renderer.Draw(hidden, 64, 64, new DrawOptions { Depth = new float[7] }));
        }

        [Fact]
        public void OverAPictureOnTransparentPaper()
        {
            style.Paper = new Color(1, 1, 1, 0);
            renderer.Prepare(camera, new Item(marks, style));
            byte[] pixels = Enumerable.Repeat((byte)200, 64 * 64 * 4).ToArray();
            renderer.Draw(pixels, 64, 64, new DrawOptions { Over = true, LinearLight = true });
            Assert.Equal(200, (int)pixels[0]);
            Assert.True(pixels.Any(value => value < 50));
        }

        [Fact]
        public void Vertices()
        {
            var layout = new VertexLayout().Add(VertexAttribute.Position).Add(VertexAttribute.Radius)
                .Add(VertexAttribute.Color).Add(VertexAttribute.IsPaper).Add(VertexAttribute.Id);
            Assert.Equal(12 + 4 + 4 + 4 + 4, layout.Stride);
            renderer.Prepare(camera, new Item(marks, style));
            byte[] vertices = renderer.Vertices(layout);
            long count = vertices.Length / layout.Stride;
            Assert.InRange(count, 1, renderer.VertexBound);
            float x = BitConverter.ToSingle(vertices, 0), y = BitConverter.ToSingle(vertices, 4);
            float z = BitConverter.ToSingle(vertices, 8);
            Assert.Equal(1, Math.Sqrt(x * x + y * y + z * z), 0.05);
            Assert.True(BitConverter.ToUInt32(vertices, 24) > 0);
            BufferTooSmallException small = Assert.Throws<BufferTooSmallException>(
                () => renderer.WriteVertices(layout, IntPtr.Zero, 0));
            Assert.Equal(Status.BufferTooSmall, small.Status);
            var placed = new VertexLayout().Add(VertexAttribute.Window, ScalarType.Float32, 4);
            placed.Stride = 32;
            byte[] windows = renderer.Vertices(placed);
            Assert.Equal(32 * count, (long)windows.Length);
            Assert.InRange(BitConverter.ToSingle(windows, 4), 0f, 64f);
            Assert.Throws<InvalidArgumentException>(() => renderer.Vertices(new VertexLayout()));
            Assert.Throws<InvalidArgumentException>(
                () => renderer.Vertices(new VertexLayout().Add(VertexAttribute.Position, ScalarType.Uint8, 0)));
        }

        [Fact]
        public void ItemsTransformsAndModels()
        {
            double[] shift = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 100, 0, 0, 1 };
            FrameInfo info = renderer.Prepare(camera, new Item(marks, style), new Item(marks, style) { Transform = shift });
            Assert.Equal(2 * marks.Count, info.Marks);
            Assert.Equal(marks.Count, info.Outside);
            renderer.Prepare(camera, marks); // in the default style
            renderer.Prepare(camera, new Item(marks, style) { Model = model });
            renderer.Prepare(camera);
            Assert.Equal(0L, renderer.Info.Marks);
            Assert.Contains("transform", Assert.Throws<InvalidArgumentException>(
                () => renderer.Prepare(camera, new Item(marks, style) { Transform = new double[16] })).Message);
            Assert.Throws<InvalidArgumentException>(() => new Item(marks) { Transform = new double[3] });
            Assert.Throws<ArgumentNullException>(() => renderer.Prepare(camera, new Item[] { null }));
            Assert.Throws<InvalidArgumentException>(() => renderer.Prepare(new Camera(), marks));
            using (var fresh = new Renderer())
            {
                Assert.Throws<InvalidArgumentException>(() => fresh.Draw(new byte[4], 1, 1));
            }
        }

        [Fact]
        public void ToneOfOnesOwn()
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
            style.SilhouetteGroups = Groups.None;
            FrameInfo light = renderer.Prepare(camera, new Item(marks, style));
            Assert.True(seen > 0);
            Assert.Equal(0L, light.Shown);
            style.Tone = Tone.None;
            Assert.True(renderer.Prepare(camera, new Item(marks, style)).Shown > 100);
        }

        [Fact]
        public void StylesArePlainData()
        {
            var names = new List<string>();
            foreach (StylePreset preset in Enum.GetValues(typeof(StylePreset)))
            {
                Style made = new Style(preset);
                names.Add(Style.PresetName(preset));
                Assert.True(made.Groups != Groups.None);
                renderer.Prepare(camera, new Item(marks, made));
            }
            Assert.Equal(8, names.Distinct().Count());
            Assert.True(names.Contains("cross-hatch"));
            Assert.Null(Style.PresetName((StylePreset)99));
            Assert.Throws<InvalidArgumentException>(() => new Style((StylePreset)99));

            var defaults = new Style();
            Assert.Equal(1, defaults.ToneExponent, 0);
            Assert.Equal(new Vector3d(-0.4, 0.6, 0.7), defaults.Light);
            Assert.Equal(new Color(1, 1, 1), defaults.Paper);
            Assert.Equal(Groups.All, defaults.SilhouetteGroups);
            defaults.HaloWidth = 7;
            defaults.Stipple.Radius = 3;
            Style copy = defaults.Clone();
            copy.Stipple.Radius = 4;
            Assert.Equal(7f, copy.HaloWidth);
            Assert.Equal(3f, defaults.Stipple.Radius);
            defaults.SilhouetteThreshold = -1;
            Assert.Contains("silhouette_threshold", Assert.Throws<InvalidArgumentException>(
                () => renderer.Prepare(camera, new Item(marks, defaults))).Message);
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
            Assert.Equal(renderer.Draw(lens, marks), renderer.Draw(same, marks));
            float[] positions = marks.Positions(Group.Stipple);
            Camera tight = Camera.FitPoints(positions, marks.Info.Origin, (0, 0, -1), (0, 1, 0), 64, 64);
            Assert.Equal(0L, renderer.Prepare(tight, marks).Outside);
            Assert.Throws<InvalidArgumentException>(() => Camera.LookAt((0, 0, 0), (0, 0, 0), (0, 1, 0)));
            Assert.Throws<InvalidArgumentException>(() => look.Perspective(9, 80, 60, 1, 10));
            Assert.Throws<InvalidArgumentException>(() => look.Orthographic(3, 80, 60, 10, 1));
            Assert.Throws<InvalidArgumentException>(() => new Camera(new double[3], new double[16], 0, 0, 1, 1));
        }

        [Fact]
        public void TheSamePictureAsFromC()
        {
            // tests/scenes/draw_scene sphere-stipple
            using (PointSet scene = PointSet.Generate(
                model, new GenerateOptions { Groups = new Style(StylePreset.Stipple).Groups, Budget = 6000 }))
            {
                Camera view = Shapes.Look(scene, 160);
                byte[] pixels = renderer.Draw(view, new Item(scene, new Style(StylePreset.Stipple)));
                byte[] file = File.ReadAllBytes(Environment.GetEnvironmentVariable("HRBFNPR_SCENE"));
                Assert.Equal(file.Skip(file.Length - pixels.Length).ToArray(), pixels);
            }
        }

        [Fact]
        public void TheQuickStartDrawsThePictureOfTheOneInC()
        {
            string expected = Environment.GetEnvironmentVariable("HRBFNPR_QUICKSTART");
            if (string.IsNullOrEmpty(expected))
            {
                return; // a build without examples
            }
            File.Delete("torus.ppm");
            Quickstart.Main();
            byte[] drawn = File.ReadAllBytes("torus.ppm");
            byte[] wanted = File.ReadAllBytes(expected);
            Assert.Equal(wanted.Length, drawn.Length);
            int different = drawn.Where((value, index) => value != wanted[index]).Count();
            // The sines of the samples may differ in their last bit from those of C's library.
            Assert.InRange(different, 0, drawn.Length / 100);
        }
    }
}
