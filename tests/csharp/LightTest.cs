// SPDX-License-Identifier: MIT
using System;
using System.Linq;
using Xunit;

namespace HrbfNpr.Tests
{
    public unsafe class LightTest : IDisposable
    {
        private readonly Model model = Shapes.FitSphere();
        private readonly LineSet lines;
        private readonly PointSet marks;
        private readonly Camera camera;
        private readonly Renderer renderer = new Renderer();
        private readonly Style style = new Style { FillLight = 0, ToneFade = 0 };

        public LightTest()
        {
            lines = model.LineSet();
            marks = Shapes.Stipple(model, 4000);
            camera = Camera.FitBounds((-1.5, -3.5, -1.5), (1.5, 1.5, 1.5), (0, -0.3, -1), (0, 1, 0), 200, 200);
        }

        public void Dispose()
        {
            renderer.Dispose();
            marks.Dispose();
            lines.Dispose();
            model.Dispose();
        }

        [Fact]
        public void LightsReplaceTheLight()
        {
            long alone = Shown();
            Assert.True(alone > 100);
            style.LightIntensity = 2;
            Assert.True(Shown() < alone);
            style.Lights.Add(new Light()); // which replaces the brighter one
            Assert.Equal(alone, Shown());
            style.Lights.Add(new Light { Place = (1, -1, 0.5), Intensity = 0.5f });
            Assert.True(Shown() < alone);
            style.Lights.RemoveAt(1);
            style.Lights[0].Kind = LightKind.Place;
            style.Lights[0].Place = (-400, 600, 700);
            Assert.InRange(Shown(), alone - 5, alone + 5);
            style.Lights[0] = new Light { Space = LightSpace.Item, Place = (0, 0, -1) }; // the light is behind the item
            Assert.True(Shown() > alone);
        }

        [Fact]
        public void AmbientLightAndTheToneLawAreApplied()
        {
            long alone = Shown();
            style.AmbientSky = 0.3f;
            long sky = Shown();
            Assert.True(sky < alone);
            style.AmbientUp = (0, -1, 0);
            Assert.NotEqual(sky, Shown());
            style.AmbientGround = 0.5f;
            Assert.True(Shown() < sky);
            style.AmbientSky = style.AmbientGround = 0;
            style.RimLight = 1;
            Assert.True(Shown() < alone);
            style.RimLight = 0;
            style.ToneGamma = 2;
            Assert.True(Shown() > alone);
            style.ToneGamma = 1;
            style.ToneWhite = 0.5f;
            Assert.True(Shown() < alone);
            style.ToneWhite = 1;
            style.ToneBlack = 0.4f;
            Assert.True(Shown() > alone);
            style.ToneBlack = 0;
            style.ToneSteps = 2;
            Assert.NotEqual(alone, Shown());
        }

        [Fact]
        public void LightsAreCopiedAndReadBack()
        {
            style.Lights.Add(new Light(LightKind.Place)
            {
                Space = LightSpace.Item, Intensity = 2, Shadow = 0.5f, Softness = 0.1f, Place = (1, 2, 3),
            });
            style.Lights.Add(new Light { Intensity = 0.25f });
            style.LightShadow = 0.75f;
            style.LightSoftness = 0.25f;
            style.AmbientUp = (0, 0, 1);
            style.AmbientSky = 0.125f;
            style.ToneSteps = 3;
            Style copy = style.Clone();
            copy.Lights[0].Intensity = 1;
            Assert.Equal(2f, style.Lights[0].Intensity);
            Assert.Equal(3u, copy.ToneSteps);

            var options = new PictureOptions { Width = 64, Height = 64, Style = style };
            using (Picture picture = Picture.Draw(model, options))
            {
                Style read = picture.Style;
                Assert.Equal(2, read.Lights.Count);
                Assert.Equal(LightKind.Place, read.Lights[0].Kind);
                Assert.Equal(LightSpace.Item, read.Lights[0].Space);
                Assert.Equal(2f, read.Lights[0].Intensity);
                Assert.Equal(0.5f, read.Lights[0].Shadow);
                Assert.Equal(0.1f, read.Lights[0].Softness);
                Assert.Equal(new Vector3d(1, 2, 3), read.Lights[0].Place);
                Assert.Equal(0.25f, read.Lights[1].Intensity);
                Assert.Equal(0.75f, read.LightShadow);
                Assert.Equal(0.25f, read.LightSoftness);
                Assert.Equal(new Vector3d(0, 0, 1), read.AmbientUp);
                Assert.Equal(0.125f, read.AmbientSky);
                Assert.Equal(3u, read.ToneSteps);
            }
        }

        [Fact]
        public void OcclusionDarkensWhereTheSkyIsHidden()
        {
            style.Lights.Add(new Light { Intensity = 0 });
            style.AmbientSky = style.AmbientGround = 0.9f;
            Item above = At(0), below = At(-2);
            long open = Shown(below);
            using (var occluders = new Occluders(new[] { above, below }))
            using (below.Shading = new Shading(occluders, below))
            {
                long closed = Shown(below);
                Assert.True(closed > open);
                style.OcclusionExponent = 4;
                Assert.True(Shown(below) > closed);
                style.Occlusion = 0;
                Assert.Equal(open, Shown(below));
                style.Occlusion = 1;
                style.OcclusionExponent = 1.5f;
                var near = new ShadingOptions { OcclusionReach = 0.05, SkyRays = 16 };
                using (below.Shading = new Shading(occluders, below, null, near))
                {
                    long some = Shown(below);
                    Assert.InRange(some, open + 1, (open + closed) / 2);
                    using (below.Shading = new Shading(
                        occluders, below, null, new ShadingOptions { Previous = below.Shading }))
                    {
                        Assert.Equal(some, Shown(below)); // not the occlusion of the default reach
                    }
                }
            }
        }

        [Fact]
        public void ShadowsFallOnOtherItems()
        {
            style.Lights.Add(new Light { Place = (0, 1, 0), Space = LightSpace.World, Shadow = 1 });
            Item above = At(0), below = At(-2.2);
            long lit = Shown(below);
            var reports = new Reports();
            using (var occluders = new Occluders(new[] { above, below }, progress: reports))
            {
                Assert.Equal(1.0, reports.Seen.Last());
                reports.Seen.Clear();
                using (below.Shading = new Shading(occluders, below, progress: reports))
                {
                    Assert.Equal(reports.Seen.OrderBy(at => at).ToArray(), reports.Seen.ToArray());
                    Assert.Equal(1.0, reports.Seen.Last());
                    Assert.True(Shown(below) > lit + 100);
                    Assert.Equal(new[] { 0f, 1f }, below.Shading.Visible().Distinct().OrderBy(share => share).ToArray());
                    Assert.InRange(below.Shading.Openness().Min(), 0f, 0.95f);
                    Assert.Throws<ArgumentOutOfRangeException>(() => below.Shading.Visible(-1));
                    Assert.Contains("casts no shadow", Refused(() => below.Shading.Visible(1)));
                    style.Lights[0].Shadow = 0;
                    Assert.Equal(lit, Shown(below));
                    style.Lights[0].Shadow = 1;
                }
                style.Lights[0].Space = LightSpace.Camera;
                style.Lights[0].Softness = 0.2f;
                using (below.Shading = new Shading(occluders, below, camera, new ShadingOptions { ShadowRays = 8 }))
                {
                    Assert.True(Shown(below) > lit);
                }
            }
        }

        [Fact]
        public void MessagesNameTheArgument()
        {
            Item item = At(0);
            Assert.Contains("line_set", Refused(() => new Occluders(new Item(marks))));
            Assert.Throws<ArgumentNullException>(() => new Occluders((Item)null));
            Assert.Throws<ArgumentNullException>(() => new Shading(null, item));
            using (var occluders = new Occluders(item))
            using (PointSet others = Shapes.Stipple(model, 100))
            {
                Assert.Contains("sky_rays", Refused(() => new Shading(
                    occluders, item, null, new ShadingOptions { SkyRays = 0 })));
                Assert.Contains("occlusion_reach", Refused(() => new Shading(
                    occluders, item, null, new ShadingOptions { OcclusionReach = -1 })));
                style.Lights.Add(new Light { Shadow = 1 }); // in the space of the camera
                Assert.Contains("camera", Refused(() => new Shading(occluders, item)));
                using (var shading = new Shading(occluders, item, camera))
                {
                    Assert.Contains("another point set", Refused(() => renderer.Draw(
                        new Item(others, style) { Shading = shading }, camera)));
                }
            }
            style.Lights[0].Intensity = -1;
            Assert.Contains("lights[0].intensity", Refused(() => renderer.Draw(item, camera)));
            style.Lights[0] = null;
            Assert.Throws<ArgumentNullException>(() => renderer.Draw(item, camera));
            style.Lights.Clear();
            for (int i = 0; i < 9; ++i)
            {
                style.Lights.Add(new Light());
            }
            Assert.Contains("light_count is 9", Refused(() => renderer.Draw(item, camera)));
        }

        [Fact]
        public void ObjectsMayBeDisposedInAnyOrder()
        {
            var context = new Context();
            Model ball = Shapes.FitSphere(context);
            LineSet its = ball.LineSet(null, context);
            PointSet dots = Shapes.Stipple(ball, 100, context);
            var item = new Item(dots, style) { LineSet = its };
            var occluders = new Occluders(item, context);
            context.Dispose();
            ball.Dispose();
            its.Dispose();
            item.LineSet = null;
            Context alive = new Context();
            var shading = new Shading(occluders, item, null, null, alive);
            alive.Dispose();
            occluders.Dispose();
            occluders.Dispose();
            Assert.Throws<ObjectDisposedException>(() => new Shading(occluders, item));
            item.Shading = shading;
            Drawing drawing = renderer.Draw(item, camera);
            shading.Dispose();
            dots.Dispose();
            Assert.True(drawing.Info.Shown > 0);
            drawing.Dispose();
            Assert.Throws<ObjectDisposedException>(() => renderer.Draw(new Item(marks) { Shading = shading }, camera));
        }

        [Fact]
        public void DefaultsMatchTheLibrary()
        {
            hrbfnpr_shading_desc desc, wanted;
            Errors.Check(NativeMethods.hrbfnpr_shading_desc_init(&wanted, (uint)sizeof(hrbfnpr_shading_desc)));
            using (var held = new HeldHandles())
            {
                new ShadingOptions().Write(&desc, held);
            }
            Assert.True(desc.sky_rays == wanted.sky_rays && desc.shadow_rays == wanted.shadow_rays);
            Assert.True(desc.previous == wanted.previous);
            Assert.Equal(wanted.occlusion_reach, desc.occlusion_reach);
            Assert.Equal(0, new Style().Lights.Count);
        }

        private static string Refused(Func<object> call)
        {
            return Assert.Throws<InvalidArgumentException>(call).Message;
        }

        private Item At(double height)
        {
            double[] shift = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, height, 0, 1 };
            return new Item(marks, style) { LineSet = lines, Transform = shift };
        }

        private long Shown(Item item = null)
        {
            return Shapes.Count(renderer, camera, item ?? new Item(marks, style)).Shown;
        }
    }
}
