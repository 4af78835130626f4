// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Text;
using Xunit;

namespace HrbfNpr.Tests
{
    /// <summary>Compares structs and constants with the facts that tests/abi/snapshot.py measures.</summary>
    public unsafe class LayoutTest
    {
        private const BindingFlags Fields = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;
        private readonly Dictionary<string, long> facts = new Dictionary<string, long>();

        public LayoutTest()
        {
            foreach (string line in File.ReadAllLines(Environment.GetEnvironmentVariable("HRBFNPR_FACTS")))
            {
                int equal = line.IndexOf(" = ", StringComparison.Ordinal);
                if (equal > 0)
                {
                    facts.Add(line.Substring(0, equal), long.Parse(line.Substring(equal + 3)));
                }
            }
        }

        [Fact]
        public void EveryStructHasItsSizeAndOffsets()
        {
            var faults = new List<string>();
            var seen = new HashSet<string>();
            foreach (Type type in typeof(Model).Assembly.GetTypes())
            {
                object[] names = type.GetCustomAttributes(typeof(NativeStructAttribute), false);
                if (names.Length == 1)
                {
                    string name = ((NativeStructAttribute)names[0]).Name;
                    seen.Add(name);
                    faults.AddRange(Compare(type, name));
                }
            }
            IEnumerable<string> wanted = facts.Keys.Where(key => key.StartsWith("sizeof ")).Select(key => key.Substring(7));
            faults.AddRange(wanted.Where(name => !seen.Contains(name)).Select(name => name + " is missing"));
            Assert.Empty(faults);
            Assert.True(seen.Count >= 25);
        }

        [Fact]
        public void EveryConstantHasItsValue()
        {
            var faults = new List<string>();
            var seen = new HashSet<string>();
            foreach (Type type in typeof(Model).Assembly.GetTypes().Where(type => type.IsEnum))
            {
                object[] prefixes = type.GetCustomAttributes(typeof(NativeConstantsAttribute), false);
                foreach (object prefix in prefixes)
                {
                    foreach (object value in Enum.GetValues(type))
                    {
                        string name = ((NativeConstantsAttribute)prefix).Prefix + UpperSnake(value.ToString());
                        seen.Add(name);
                        bool known = facts.TryGetValue("constant " + name, out long number);
                        if (!known || number != Convert.ToInt64(value))
                        {
                            faults.Add(type.Name + "." + value + " is not " + name);
                        }
                    }
                }
            }
            Assert.Equal(facts["constant HRBFNPR_ABI_VERSION"], (long)NativeMethods.AbiVersion);
            foreach (string key in facts.Keys.Where(key => key.StartsWith("constant ")))
            {
                string name = key.Substring(9);
                // Flags are properties in C#. They are checked below.
                bool elsewhere = name.Contains("VERSION_") || name.EndsWith("ABI_VERSION")
                    || name.StartsWith("HRBFNPR_CUSTOM_") || name.StartsWith("HRBFNPR_LAYER_WITH_")
                    || name.StartsWith("HRBFNPR_LINE_SET_WITH_")
                    || name.StartsWith("HRBFNPR_SHADING_WITH_") || name.StartsWith("HRBFNPR_RASTER_")
                    || name == "HRBFNPR_PAGE_IN_PLOT_ORDER" || name == "HRBFNPR_PAGE_WITHOUT_PAPER"
                    || name == "HRBFNPR_PAGE_SINGLE_PASS"
                    || name == "HRBFNPR_INDEX_RESTART" || FlagsOfPictures.Any(flag => name == flag.Item1);
                if (!elsewhere && !seen.Contains(name))
                {
                    faults.Add(name + " is missing");
                }
            }
            Assert.Empty(faults);
            Assert.Equal(1L, facts["constant HRBFNPR_CUSTOM_HAS_GRADIENT"]);
            Assert.Equal(2L, facts["constant HRBFNPR_CUSTOM_HAS_HESSIAN"]);
            Assert.Equal(4L, facts["constant HRBFNPR_CUSTOM_THREAD_SAFE"]);
            Assert.Equal(1L, facts["constant HRBFNPR_LAYER_WITH_CURVATURE"]);
            Assert.Equal(1L, facts["constant HRBFNPR_LINE_SET_WITH_CURVATURE"]);
            Assert.Equal(1L, facts["constant HRBFNPR_SHADING_WITH_LINES"]);
            Assert.Equal(1L, facts["constant HRBFNPR_RASTER_OVER"]);
            Assert.Equal(2L, facts["constant HRBFNPR_RASTER_LINEAR_LIGHT"]);
            Assert.Equal(unchecked((int)Vertices.Restart), (int)facts["constant HRBFNPR_INDEX_RESTART"]);
        }

        [Fact]
        public void EveryFlagOfAPictureIsAProperty()
        {
            foreach (Tuple<string, uint> flag in FlagsOfPictures)
            {
                Assert.Equal(facts["constant " + flag.Item1], (long)flag.Item2);
            }
        }

        [Fact]
        public void NewOptionsHoldTheDefaultsOfTheLibrary()
        {
            using (var pins = new Pins())
            {
                hrbfnpr_picture_desc picture, wantedPicture;
                NativeMethods.hrbfnpr_picture_desc_init(&wantedPicture, (uint)sizeof(hrbfnpr_picture_desc));
                NativeMethods.hrbfnpr_picture_desc_init(&picture, (uint)sizeof(hrbfnpr_picture_desc));
                new PictureOptions().Write(ref picture, pins);
                Same(&wantedPicture, &picture, sizeof(hrbfnpr_picture_desc));
                hrbfnpr_views_desc views, wantedViews;
                NativeMethods.hrbfnpr_views_desc_init(&wantedViews, (uint)sizeof(hrbfnpr_views_desc));
                new ViewsOptions().Write(&views, pins);
                Same(&wantedViews, &views, sizeof(hrbfnpr_views_desc));
                hrbfnpr_picture_page_desc page, wantedPage;
                NativeMethods.hrbfnpr_picture_page_desc_init(&wantedPage, (uint)sizeof(hrbfnpr_picture_page_desc));
                new PicturePageOptions().Write(&page, null, pins);
                page.page = IntPtr.Zero; // the page has its own defaults
                Same(&wantedPage, &page, sizeof(hrbfnpr_picture_page_desc));
                hrbfnpr_dab dab, wantedDab;
                NativeMethods.hrbfnpr_dab_init(&wantedDab, (uint)sizeof(hrbfnpr_dab));
                new Dab().Write(&dab);
                Same(&wantedDab, &dab, sizeof(hrbfnpr_dab));
            }
        }

        [Fact]
        public void EveryFieldHasAProperty()
        {
            var faults = new List<string>();
            faults.AddRange(Unseen(typeof(hrbfnpr_fit_desc), typeof(FitOptions), "points", "normals"));
            faults.AddRange(Unseen(typeof(hrbfnpr_project_desc), typeof(ProjectOptions)));
            faults.AddRange(Unseen(typeof(hrbfnpr_cast_desc), typeof(CastOptions)));
            faults.AddRange(Unseen(typeof(hrbfnpr_custom_desc), typeof(FunctionOptions),
                "flags", "function", "user", "release", "bounds_min", "bounds_max"));
            faults.AddRange(Unseen(typeof(hrbfnpr_layer_desc), typeof(Layer), "flags", "density_user", "direction_user"));
            faults.AddRange(Unseen(typeof(hrbfnpr_generate_desc), typeof(GenerateOptions), "layer_count", "layer_stride"));
            faults.AddRange(Unseen(typeof(hrbfnpr_layer_arrays), typeof(OwnLayer)));
            faults.AddRange(Unseen(typeof(hrbfnpr_layer_style), typeof(LayerStyle)));
            faults.AddRange(Unseen(typeof(hrbfnpr_line_desc), typeof(LineOptions), "position")); // the property is Positions
            faults.AddRange(Unseen(typeof(hrbfnpr_line_set_desc), typeof(LineSetOptions),
                "flags", "line_count", "line_stride"));
            faults.AddRange(Unseen(typeof(hrbfnpr_line_style), typeof(LineStyle)));
            faults.AddRange(Unseen(typeof(hrbfnpr_style), typeof(Style),
                "tone_user", "layer_count", "layer_stride", "line_count", "line_stride", "light_count",
                "light_stride", "palette_count"));
            faults.AddRange(Unseen(typeof(hrbfnpr_light), typeof(Light)));
            faults.AddRange(Unseen(typeof(hrbfnpr_shading_desc), typeof(ShadingOptions), "flags"));
            faults.AddRange(Unseen(typeof(hrbfnpr_layer_pose), typeof(LayerPose)));
            faults.AddRange(Unseen(typeof(hrbfnpr_item), typeof(Item), "pose_count", "pose_stride"));
            faults.AddRange(Unseen(typeof(hrbfnpr_raster_desc), typeof(RasterOptions), "flags"));
            faults.AddRange(Unseen(typeof(hrbfnpr_mark_results), typeof(MarkResults)));
            faults.AddRange(Unseen(typeof(hrbfnpr_vertex_layout), typeof(VertexLayout),
                "attributes", "attribute_count", "attribute_stride"));
            faults.AddRange(Unseen(typeof(hrbfnpr_context_desc), typeof(ContextOptions),
                "abi_version", "flags", "log_user", "run_tasks_user"));
            faults.AddRange(Unseen(typeof(hrbfnpr_picture_source), typeof(PictureSource), "flags", "field_count",
                "field_stride"));
            faults.AddRange(Unseen(typeof(hrbfnpr_source_field), typeof(SourceField)));
            faults.AddRange(Unseen(typeof(hrbfnpr_picture_desc), typeof(PictureOptions),
                "flags", "sources", "source_count", "source_stride", "change_count", "change_stride", "dab_count",
                "dab_stride", "event_user"));
            faults.AddRange(Unseen(typeof(hrbfnpr_change), typeof(Change)));
            faults.AddRange(Unseen(typeof(hrbfnpr_dab), typeof(Dab)));
            faults.AddRange(Unseen(typeof(hrbfnpr_note), typeof(Note), "figure_count"));
            faults.AddRange(Unseen(typeof(hrbfnpr_picture_event), typeof(PictureEvent)));
            faults.AddRange(Unseen(typeof(hrbfnpr_picture_part), typeof(PicturePart)));
            faults.AddRange(Unseen(typeof(hrbfnpr_picture_page_desc), typeof(PicturePageOptions)));
            faults.AddRange(Unseen(typeof(hrbfnpr_views_desc), typeof(ViewsOptions), "flags"));
            Assert.Empty(faults);
        }

        /// <summary>The flags of pictures, and the values that their properties write.</summary>
        private static Tuple<string, uint>[] FlagsOfPictures
        {
            get
            {
                return new[]
                {
                    Flag("PICTURE_ALLOW_BLANK", new PictureOptions { AllowBlank = true }),
                    Flag("PICTURE_FLIP", new PictureOptions { Flip = true }),
                    Flag("PICTURE_CLOSE", new PictureOptions { Close = true }),
                    Flag("PICTURE_TOGETHER", new PictureOptions { Together = true }),
                    Flag("PICTURE_TRANSPARENT", new PictureOptions { Transparent = true }),
                    Flag("PICTURE_KEEP_MARKS", new PictureOptions { KeepMarks = true }),
                    Flag("PICTURE_SURFACE_ONLY", new PictureOptions { SurfaceOnly = true }),
                    Flag("PICTURE_IS_SOLID", new PictureOptions { IsSolid = true }),
                    Flag("PICTURE_VERIFY", new PictureOptions { Verify = true }),
                    Flag("SOURCE_HAS_SHARP_EDGES", source => source.SharpEdges = new int[0]),
                    Flag("SOURCE_HAS_VIEWPOINT", source => source.Viewpoint = (0, 0, 0)),
                    Flag("SOURCE_IS_PHOTO", source => source.IsPhoto = true),
                    Flag("VIEWS_CENTRE_LINES", new ViewsOptions { CentreLines = true }),
                    Flag("VIEWS_LABELS", new ViewsOptions { Labels = true }),
                    Flag("VIEWS_UNIT_IS_METRE", new ViewsOptions { UnitIsMetre = true }),
                    Flag("VIEWS_VERIFY", new ViewsOptions { Verify = true }),
                };
            }
        }

        private static Tuple<string, uint> Flag(string name, PictureOptions options)
        {
            using (var pins = new Pins())
            {
                var desc = default(hrbfnpr_picture_desc);
                options.Write(ref desc, pins);
                return Tuple.Create("HRBFNPR_" + name, desc.flags);
            }
        }

        private static Tuple<string, uint> Flag(string name, ViewsOptions options)
        {
            using (var pins = new Pins())
            {
                hrbfnpr_views_desc desc;
                options.Write(&desc, pins);
                return Tuple.Create("HRBFNPR_" + name, desc.flags);
            }
        }

        private static Tuple<string, uint> Flag(string name, Action<PictureSource> set)
        {
            using (var pins = new Pins())
            {
                PictureSource source = PictureSource.FromPoints(Shapes.Sphere6);
                set(source);
                hrbfnpr_picture_source native;
                source.Write(&native, pins, new HeldHandles());
                return Tuple.Create("HRBFNPR_" + name, native.flags);
            }
        }

        /// <summary>Compares all bits. NaNs may differ in their sign.</summary>
        private static void Same(void* expected, void* actual, int size)
        {
            Assert.Equal(0, size % 8);
            for (int i = 0; i < size / 8; ++i)
            {
                double wanted = ((double*)expected)[i], written = ((double*)actual)[i];
                bool same = ((long*)expected)[i] == ((long*)actual)[i]
                    || (double.IsNaN(wanted) && double.IsNaN(written));
                Assert.True(same, "bytes " + 8 * i + " to " + (8 * i + 7) + " are not the default");
            }
        }

        /// <summary>The fields of a descriptor that its class has no property for.</summary>
        private static IEnumerable<string> Unseen(Type native, Type shown, params string[] otherwise)
        {
            var properties = new HashSet<string>(shown.GetProperties().Select(property => Plain(property.Name)));
            foreach (FieldInfo field in native.GetFields(Fields))
            {
                bool array = char.IsDigit(field.Name[field.Name.Length - 1]); // its elements have separate names in C#
                bool plain = field.Name == "struct_size" || field.Name.StartsWith("reserved");
                if (!array && !plain && !otherwise.Contains(field.Name) && !properties.Contains(Plain(field.Name)))
                {
                    yield return native.Name + "." + field.Name + " cannot be set through " + shown.Name;
                }
            }
        }

        private static string UpperSnake(string name)
        {
            var result = new StringBuilder();
            foreach (char letter in name)
            {
                if (char.IsUpper(letter) && result.Length > 0)
                {
                    result.Append('_');
                }
                result.Append(char.ToUpperInvariant(letter));
            }
            return result.ToString();
        }

        private static string Plain(string name)
        {
            return name.Replace("_", string.Empty).ToLowerInvariant();
        }

        private IEnumerable<string> Compare(Type type, string name)
        {
            if (!facts.ContainsKey("sizeof " + name))
            {
                yield return name + " is not in the header";
                yield break;
            }
            int size = Marshal.SizeOf(type);
            if (size != facts["sizeof " + name])
            {
                yield return name + " has " + size + " bytes, not " + facts["sizeof " + name];
            }
            string prefix = "offsetof " + name + ".";
            string[] wanted = facts.Keys.Where(key => key.StartsWith(prefix)).ToArray();
            var offsets = new Dictionary<string, long>();
            foreach (FieldInfo field in type.GetFields(Fields))
            {
                offsets[Plain(field.Name)] = Marshal.OffsetOf(type, field.Name).ToInt64();
            }
            foreach (string key in wanted)
            {
                string field = Plain(key.Substring(prefix.Length));
                bool known = offsets.TryGetValue(field, out long offset) || offsets.TryGetValue(field + "0", out offset);
                if (!known || offset != facts[key])
                {
                    yield return key + " is " + facts[key] + ", not " + (known ? offset.ToString() : "known here");
                }
            }
        }
    }
}
