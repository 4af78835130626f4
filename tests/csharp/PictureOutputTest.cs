// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Linq;
using System.Text;
using Xunit;

namespace HrbfNpr.Tests
{
    /// <summary>Pictures as vector files, on paper, with a scale bar, and as sheets of views.</summary>
    public class PictureOutputTest : IDisposable
    {
        private readonly Picture picture;

        public PictureOutputTest()
        {
            Shapes.Cube(out double[] vertices, out int[] triangles);
            var options = new PictureOptions { Preset = Preset.Silhouette, Width = 120, Height = 90 };
            picture = Picture.Create(PictureSource.FromMesh(vertices, triangles), options);
        }

        public void Dispose()
        {
            picture.Dispose();
        }

        [Fact]
        public void PicturesAreWrittenInEveryVectorFormat()
        {
            var stream = new MemoryStream();
            PageInfo info = picture.WriteSvg(stream);
            string svg = Encoding.UTF8.GetString(stream.ToArray());
            Assert.Contains("<svg", svg);
            Assert.Contains("inkscape:label=\"contour\"", svg);
            Assert.Equal(stream.Length, info.Bytes);
            Assert.Equal(120 * PageItem.Pixel, info.Width, 9);
            Assert.Equal(90 * PageItem.Pixel, info.Height, 9);
            Assert.Equal(svg, Text(picture, null));
            Assert.Equal(svg, Text(picture, new PicturePageOptions()));
            var pdf = new MemoryStream();
            picture.WritePdf(pdf);
            Assert.Equal("%PDF-1.5", Encoding.ASCII.GetString(pdf.ToArray(), 0, 8));
            var plotted = new PicturePageOptions { Page = { Format = PageFormat.Hpgl, Title = "a cube" } };
            Assert.Contains("PU", Text(picture, plotted));
            plotted.Page.Format = PageFormat.Svg;
            Assert.Contains("a cube", Text(picture, plotted));
            string path = Path.GetTempFileName();
            try
            {
                picture.WriteSvg(path);
                Assert.Equal(svg, File.ReadAllText(path));
                picture.WritePdf(path);
                Assert.Equal(pdf.ToArray(), File.ReadAllBytes(path));
            }
            finally
            {
                File.Delete(path);
            }
        }

        [Fact]
        public void PaperAndAvailablePensAreUsed()
        {
            var options = new PicturePageOptions { Paper = "a5", PenWidths = new[] { 0.25, 0.5 } };
            PageInfo info = picture.Write(new MemoryStream(), options);
            Assert.Equal(210.0, info.Width, 1e-9); // landscape
            Assert.Equal(148.0, info.Height, 1e-9);
            Assert.Contains("pen", picture.Notes.Single(one => one.Code == NoteCode.Pens).Text);
            options.Page.Format = PageFormat.Gcode;
            options.Page.InPlotOrder = true;
            picture.Write(new MemoryStream(), options);
            Note plotted = picture.Notes.Single(one => one.Code == NoteCode.Plotted);
            Assert.True(plotted.Figures[0] > 0.1 && plotted.Figures[2] > 1);
            Wrong("paper", new PicturePageOptions { Paper = "a99" });
            Wrong("paper_margin", new PicturePageOptions { PaperMargin = double.NaN });
            Wrong("tolerance", new PicturePageOptions { Page = { Tolerance = 0 } });
        }

        [Fact]
        public void AnotherDrawingOfThePictureIsWritten()
        {
            using (Drawing other = picture.Draw(picture.Look(80, 40)))
            {
                var stream = new MemoryStream();
                var reports = new Reports();
                picture.Write(stream, null, other, reports);
                Assert.Equal(1.0, reports.Seen.Last());
                Assert.NotEqual(Text(picture, null), Encoding.UTF8.GetString(stream.ToArray()));
                byte[] expected = picture.Rasterize(other);
                var pixels = new byte[120 * 90 * 4];
                picture.Rasterize(pixels, 120, 90, drawing: other);
                Assert.Equal(expected, pixels);
                Assert.NotEqual(expected, picture.Rasterize());
            }
        }

        [Fact]
        public void AScaleBarStandsBelowTheDrawing()
        {
            Assert.Equal((120, 90), picture.PlateSize());
            var options = new PictureOptions
            {
                Preset = Preset.Silhouette, Width = 120, Height = 90, Fov = 0, ScaleBar = "cm", Profile = Profile.Yes,
            };
            using (Picture plate = picture.Restyle(options))
            {
                (int width, int height) = plate.PlateSize();
                Assert.True(width > 120 && height > 90);
                byte[] rgba = plate.Rasterize();
                Assert.Equal(4 * width * height, rgba.Length);
                Assert.Equal(width * height, plate.Rasterize(PixelFormat.Coverage8).Length);
                var larger = new byte[4 * (width + 1) * (height + 1)];
                plate.Rasterize(larger, width + 1, height + 1);
                Assert.Equal(rgba.Take(4 * width).ToArray(), larger.Take(4 * width).ToArray());
                Assert.Equal(0, larger.Skip(4 * width).Take(4).Sum(value => value)); // left unchanged
                Assert.Contains("cm", Text(plate, null));
                Assert.Throws<InvalidArgumentException>(() => plate.Rasterize(new byte[4 * 120 * 90], 120, 90));
            }
        }

        [Fact]
        public unsafe void ImagesAreWrittenToNativeMemory()
        {
            byte[] expected = picture.Rasterize();
            int row = 120 * 4;
            var upsideDown = new byte[expected.Length];
            fixed (byte* first = upsideDown)
            {
                picture.Rasterize((IntPtr)(first + 89 * row), 120, 90, rowStride: -row);
            }
            for (int y = 0; y < 90; ++y)
            {
                Assert.Equal(expected.Skip(y * row).Take(row).ToArray(),
                    upsideDown.Skip((89 - y) * row).Take(row).ToArray());
            }
        }

        [Fact]
        public void ASheetOfViewsIsWritten()
        {
            var stream = new MemoryStream();
            ViewsInfo info = picture.WriteViews(stream, new ViewsOptions
            {
                Views = "front,top",
                Sections = "z",
                Scale = "50:1",
                Title = "A cube",
                CentreLines = true,
                Labels = true,
            });
            string svg = Encoding.UTF8.GetString(stream.ToArray());
            Assert.Equal(3L, info.Views);
            Assert.Equal(stream.Length, info.Bytes);
            Assert.Equal("50:1", info.ScaleText);
            Assert.Equal(50.0, info.Scale);
            Assert.Equal(1.0, info.UnitMm);
            Assert.True(info.Paper.StartsWith("a", StringComparison.Ordinal) && info.Width > info.Height);
            Assert.Contains("outlines front", svg);
            Assert.Contains("hatching A-A", svg);
            Assert.Contains("A cube", svg);
            Assert.True(picture.Stages.Any(one => one.Stage == Stage.Views));
            var pdf = new ViewsOptions { UnitIsMetre = true, Page = new PageOptions { Format = PageFormat.Pdf } };
            stream = new MemoryStream();
            Assert.Equal(1000.0, picture.WriteViews(stream, pdf).UnitMm);
            Assert.Equal("%PDF", Encoding.ASCII.GetString(stream.ToArray(), 0, 4));
            Assert.True(picture.Notes.Any(one => one.Code == NoteCode.UnitIsMetre));
            InvalidArgumentException wrong = Assert.Throws<InvalidArgumentException>(
                () => picture.WriteViews(new MemoryStream(), new ViewsOptions { Views = "front,inside" }));
            Assert.Contains("inside", wrong.Message);
            Assert.Throws<InvalidArgumentException>(
                () => picture.WriteViews(new MemoryStream(), new ViewsOptions { Sections = "z:9" }));
            Assert.IsType<NotSupportedException>(
                Assert.Throws<StreamException>(() => picture.WriteViews(new Full())).InnerException);
        }

        [Fact]
        public void StreamErrorsAreReported()
        {
            StreamException failed = Assert.Throws<StreamException>(() => picture.WriteSvg(new Full()));
            Assert.IsType<NotSupportedException>(failed.InnerException);
            Assert.Throws<ArgumentNullException>(() => picture.WriteSvg((Stream)null));
            Assert.Throws<ArgumentNullException>(() => picture.WriteViews(null));
            Assert.Throws<ArgumentNullException>(() => picture.SaveSettings((Stream)null));
        }

        internal static string Text(Picture picture, PicturePageOptions options)
        {
            var stream = new MemoryStream();
            picture.Write(stream, options);
            return Encoding.UTF8.GetString(stream.ToArray());
        }

        private void Wrong(string name, PicturePageOptions options)
        {
            Assert.Contains(name, Assert.Throws<InvalidArgumentException>(
                () => picture.Write(new MemoryStream(), options)).Message);
        }

        internal sealed class Full : MemoryStream
        {
            public override void Write(byte[] buffer, int offset, int count)
            {
                throw new NotSupportedException();
            }
        }
    }
}
