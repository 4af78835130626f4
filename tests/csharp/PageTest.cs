// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Text;
using System.Threading;
using Xunit;

namespace HrbfNpr.Tests
{
    public class PageTest : IDisposable
    {
        private const double Pixel = 25.4 / 96;
        private readonly Drawing drawing;

        public PageTest()
        {
            using (Model model = Shapes.FitSphere())
            using (PointSet marks = Shapes.Stipple(model, 2000))
            using (LineSet lines = model.LineSet())
            using (var renderer = new Renderer())
            {
                Style style = Style.Preset(Preset.ContourAndStipple);
                drawing = renderer.Draw(new Item(marks, style) { LineSet = lines }, Shapes.Look(marks, 64));
            }
        }

        public void Dispose()
        {
            drawing.Dispose();
        }

        [Fact]
        public void ADrawingSavesItsGroups()
        {
            var stream = new MemoryStream();
            PageInfo info = drawing.Save(stream);
            string svg = Encoding.UTF8.GetString(stream.ToArray());
            Assert.Contains("inkscape:label=\"stipples\"", svg);
            Assert.Contains("inkscape:label=\"contour\"", svg);
            Assert.True(svg.TrimEnd().EndsWith("</svg>", StringComparison.Ordinal));
            Assert.Equal(stream.Length, info.Bytes);
            Assert.Equal(2L, info.Groups);
            Assert.Equal(drawing.Info.Dots, info.Dots);
            Assert.True(info.Paths > 0 && info.Segments >= info.Paths);
            Assert.Equal(64 * Pixel, info.Width, 9);
            Assert.Equal(0.0, info.Drawn);
        }

        [Fact]
        public void PensAndAnnotationsAreWritten()
        {
            var options = new PageOptions
            {
                Width = 100,
                Height = 80,
                Title = "a ball & its title",
                Pens = { new Pen("cont*") { Width = 0.7, Ink = Color.Parse("#ff0000"), LineType = LineType.Dashed } },
                Annotations =
                {
                    new Annotation(new double[] { 5, 70, 60, 70 }) { Group = "axis", Ink = Color.Parse("#0000ff") },
                    new Annotation(new float[] { 5, 78 }, "Größe <1>") { Group = "labels", Width = 3 },
                },
            };
            long dashed = drawing.Save(new MemoryStream(), options).Paths;
            string svg = Text(options);
            Assert.Contains("a ball &amp; its title", svg);
            Assert.Contains("#ff0000", svg);
            Assert.Contains("inkscape:label=\"axis\"", svg);
            Assert.Contains("#0000ff", svg);
            Assert.Contains("inkscape:label=\"labels\"", svg);
            Assert.Contains("Größe &lt;1&gt;", svg);
            options.Pens[0].LineType = LineType.Continuous;
            Assert.True(dashed > drawing.Save(new MemoryStream(), options).Paths); // each dash is a path
            Assert.True(Text(new PageOptions()).IndexOf("#ff0000", StringComparison.Ordinal) < 0);
        }

        [Fact]
        public void APageHoldsAnyNumberOfDrawings()
        {
            var stream = new MemoryStream();
            PageInfo info = Page.Write(stream, new[]
            {
                new PageItem(drawing) { Name = "left" },
                new PageItem(drawing) { Name = "right", X = 30, Y = 2, Scale = 0.5 },
            });
            string svg = Encoding.UTF8.GetString(stream.ToArray());
            Assert.Contains("\"left\"", svg);
            Assert.Contains("\"right\"", svg);
            Assert.Equal(30 + 32.0, info.Width, 9);
            Assert.Equal(2 + 32.0, info.Height, 9);
            Assert.Equal(2 * drawing.Info.Dots, info.Dots);
            var note = new PageOptions { Width = 10, Height = 10, Annotations = { new Annotation(new[] { 1.0, 5 }, "x") } };
            Assert.Equal(0L, Page.Write(new MemoryStream(), new PageItem[0], note).Dots);
        }

        [Fact]
        public void FlagsArePassedOn()
        {
            using (Model model = Shapes.FitSphere())
            using (PointSet marks = Shapes.Stipple(model, 500))
            using (var renderer = new Renderer())
            {
                Style style = Style.Preset(Preset.Stipple);
                style.Visibility = Visibility.Published;
                using (Drawing discs = renderer.Draw(new Item(marks, style), Shapes.Look(marks, 64)))
                {
                    discs.Save(new MemoryStream());
                    Assert.Throws<InvalidArgumentException>(
                        () => discs.Save(new MemoryStream(), new PageOptions { InPlotOrder = true }));
                }
            }
            long bare = drawing.Save(new MemoryStream(), new PageOptions { WithPaper = false }).Bytes;
            Assert.True(bare < drawing.Save(new MemoryStream()).Bytes);
        }

        [Fact]
        public void BadArgumentsAreNamed()
        {
            Named("tolerance", new PageOptions { Tolerance = 0 });
            Named("group", new PageOptions { Annotations = { new Annotation(new double[4]) { Group = "" } } });
            Assert.Throws<ArgumentNullException>(() => new PageItem(null));
            Assert.Throws<ArgumentNullException>(() => drawing.Save(null));
            Assert.Throws<ArgumentNullException>(() => Page.Write(new MemoryStream(), null));
            Assert.Throws<ArgumentNullException>(() => Page.Write(new MemoryStream(), new PageItem[] { null }));
            Assert.Throws<InvalidArgumentException>(() => Page.Write(new MemoryStream(), new PageItem[0]));
            Drawing gone = drawing;
            gone.Dispose();
            Assert.Throws<ObjectDisposedException>(() => gone.Save(new MemoryStream()));
        }

        private string Text(PageOptions options)
        {
            var stream = new MemoryStream();
            drawing.Save(stream, options);
            return Encoding.UTF8.GetString(stream.ToArray());
        }

        private void Named(string name, PageOptions options)
        {
            InvalidArgumentException wrong =
                Assert.Throws<InvalidArgumentException>(() => drawing.Save(new MemoryStream(), options));
            Assert.Contains(name, wrong.Message);
        }
    }
}
