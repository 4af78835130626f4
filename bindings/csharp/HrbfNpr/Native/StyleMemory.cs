// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>Writes styles as structs of the library in native memory, without the tone function.</summary>
    internal static unsafe class StyleMemory
    {
        /// <summary>The largest number of bytes that <see cref="Write(Style, Memory)"/> takes.</summary>
        internal static long Size(Style style)
        {
            IList<LayerStyle> layers = style.Layers;
            long size = sizeof(hrbfnpr_style) + (long)layers.Count * sizeof(hrbfnpr_layer_style) + 16;
            for (int i = 0; i < layers.Count; ++i)
            {
                if (layers[i] == null)
                {
                    throw new ArgumentNullException(nameof(Style.Layers));
                }
                size += layers[i].NameUtf8 == null ? 0 : Memory.Rounded(layers[i].NameUtf8.Length);
                foreach (Utf8Name field in layers[i].Fields)
                {
                    size += field.Utf8 == null ? 0 : Memory.Rounded(field.Utf8.Length);
                }
            }
            size += Memory.Rounded((long)style.Palette.Count * sizeof(Color));
            return size + Size(style.Lines) + Memory.Rounded((long)style.Lights.Count * sizeof(hrbfnpr_light));
        }

        internal static hrbfnpr_style* Write(Style style, Memory memory)
        {
            var native = (hrbfnpr_style*)memory.Take(sizeof(hrbfnpr_style));
            style.Write(native);
            int count = style.Layers.Count;
            if (count > 0)
            {
                var layers = (hrbfnpr_layer_style*)memory.Take((long)count * sizeof(hrbfnpr_layer_style));
                native->layers = (IntPtr)layers;
                native->layer_count = count;
                for (int i = 0; i < count; ++i)
                {
                    LayerStyle layer = style.Layers[i];
                    layer.Write(layers + i);
                    layers[i].name = Copy(layer.NameUtf8, memory);
                    layers[i].density_field = Copy(layer.Fields[0].Utf8, memory);
                    layers[i].tone_field = Copy(layer.Fields[1].Utf8, memory);
                    layers[i].width_field = Copy(layer.Fields[2].Utf8, memory);
                    layers[i].ink_field = Copy(layer.Fields[3].Utf8, memory);
                    layers[i].mask_field = Copy(layer.Fields[4].Utf8, memory);
                }
            }
            Write(style.Lines, native, memory);
            Write(style.Lights, native, memory);
            Write(style.Palette, native, memory);
            return native;
        }

        private static long Size(IList<LineStyle> lines)
        {
            long size = Memory.Rounded((long)lines.Count * sizeof(hrbfnpr_line_style));
            for (int i = 0; i < lines.Count; ++i)
            {
                LineStyle line = lines[i] ?? throw new ArgumentNullException(nameof(Style.Lines));
                size += line.NameUtf8 == null ? 0 : Memory.Rounded(line.NameUtf8.Length);
                size += line.Levels == null ? 0 : line.Levels.LongLength * sizeof(double);
            }
            return size;
        }

        private static void Write(IList<LineStyle> lines, hrbfnpr_style* native, Memory memory)
        {
            int count = lines.Count;
            if (count == 0)
            {
                return;
            }
            var first = (hrbfnpr_line_style*)memory.Take((long)count * sizeof(hrbfnpr_line_style));
            native->lines = (IntPtr)first;
            native->line_count = count;
            for (int i = 0; i < count; ++i)
            {
                LineStyle line = lines[i];
                line.Write(first + i);
                first[i].name = Copy(line.NameUtf8, memory);
                double[] levels = line.Levels;
                if (levels != null)
                {
                    byte* copy = memory.Take(levels.LongLength * sizeof(double));
                    Marshal.Copy(levels, 0, (IntPtr)copy, levels.Length);
                    first[i].levels.data = (IntPtr)copy;
                    first[i].levels.count = levels.Length;
                    first[i].levels.scalar = (uint)ScalarType.Float64;
                    first[i].levels.components = 1;
                }
            }
        }

        private static void Write(IList<Light> lights, hrbfnpr_style* native, Memory memory)
        {
            int count = lights.Count;
            if (count == 0)
            {
                return;
            }
            var first = (hrbfnpr_light*)memory.Take((long)count * sizeof(hrbfnpr_light));
            native->lights = (IntPtr)first;
            native->light_count = count;
            for (int i = 0; i < count; ++i)
            {
                Light light = lights[i] ?? throw new ArgumentNullException(nameof(Style.Lights));
                light.Write(first + i);
            }
        }

        private static void Write(IList<Color> palette, hrbfnpr_style* native, Memory memory)
        {
            int count = palette.Count;
            if (count == 0)
            {
                return;
            }
            var first = (Color*)memory.Take((long)count * sizeof(Color));
            native->palette = (IntPtr)first;
            native->palette_count = count;
            for (int i = 0; i < count; ++i)
            {
                first[i] = palette[i];
            }
        }

        private static IntPtr Copy(byte[] name, Memory memory)
        {
            if (name == null)
            {
                return IntPtr.Zero;
            }
            byte* copy = memory.Take(name.Length);
            Marshal.Copy(name, 0, (IntPtr)copy, name.Length);
            return (IntPtr)copy;
        }
    }
}
