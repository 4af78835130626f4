// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    public sealed unsafe partial class Drawing
    {
        /// <summary>As an image of the camera's size.</summary>
        /// <param name="format">Of the pixels; floats are given as their bytes.</param>
        /// <returns>Width * Height pixels.</returns>
        public byte[] Rasterize(PixelFormat format = PixelFormat.Rgba8)
        {
            var pixels = new byte[(long)PixelBytes(format) * Width * Height];
            Rasterize(pixels, Width, Height, format);
            return pixels;
        }

        /// <summary>Draws into an image: the viewport is filled, pixels outside it are not touched.</summary>
        /// <param name="pixels">The image.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="format">Of the pixels.</param>
        /// <param name="options">All defaults if null.</param>
        /// <exception cref="InvalidArgumentException">The array is too short, or an option does not fit.</exception>
        public void Rasterize(
            byte[] pixels, int width, int height, PixelFormat format = PixelFormat.Rgba8, RasterOptions options = null)
        {
            if (pixels == null)
            {
                throw new ArgumentNullException(nameof(pixels));
            }
            long start = Start(pixels.LongLength, width, height, format, options);
            fixed (byte* data = pixels)
            {
                Rasterize((IntPtr)(data + start), width, height, format, options);
            }
        }

        /// <summary>As the other <c>Rasterize</c>, into an image of floats.</summary>
        /// <param name="pixels">The image, 4 numbers a pixel.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="format">Rgba32f or Rgba32fPremultiplied.</param>
        /// <param name="options">All defaults if null.</param>
        public void Rasterize(
            float[] pixels, int width, int height, PixelFormat format = PixelFormat.Rgba32f,
            RasterOptions options = null)
        {
            if (pixels == null)
            {
                throw new ArgumentNullException(nameof(pixels));
            }
            long start = Start(4 * pixels.LongLength, width, height, format, options);
            fixed (float* data = pixels)
            {
                Rasterize((IntPtr)((byte*)data + start), width, height, format, options);
            }
        }

#if NET7_0_OR_GREATER
        /// <summary>As the other <c>Rasterize</c>, into a span.</summary>
        /// <param name="pixels">The image.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="format">Of the pixels.</param>
        /// <param name="options">All defaults if null.</param>
        public void Rasterize(
            Span<byte> pixels, int width, int height, PixelFormat format = PixelFormat.Rgba8,
            RasterOptions options = null)
        {
            long start = Start(pixels.Length, width, height, format, options);
            fixed (byte* data = pixels)
            {
                Rasterize((IntPtr)(data + start), width, height, format, options);
            }
        }

        /// <summary>As the other <c>Rasterize</c>, into a span of floats.</summary>
        /// <param name="pixels">The image, 4 numbers a pixel.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="format">Rgba32f or Rgba32fPremultiplied.</param>
        /// <param name="options">All defaults if null.</param>
        public void Rasterize(
            Span<float> pixels, int width, int height, PixelFormat format = PixelFormat.Rgba32f,
            RasterOptions options = null)
        {
            long start = Start(4L * pixels.Length, width, height, format, options);
            fixed (float* data = pixels)
            {
                Rasterize((IntPtr)((byte*)data + start), width, height, format, options);
            }
        }
#endif

        /// <summary>As the other <c>Rasterize</c>, into native memory, such as a texture's or a NativeArray's.</summary>
        /// <param name="pixels">The top-left pixel, whatever the sign of the row stride.</param>
        /// <param name="width">Pixels, 1 to 32768.</param>
        /// <param name="height">Pixels, 1 to 32768.</param>
        /// <param name="format">Of the pixels.</param>
        /// <param name="options">All defaults if null.</param>
        public void Rasterize(
            IntPtr pixels, int width, int height, PixelFormat format = PixelFormat.Rgba8, RasterOptions options = null)
        {
            hrbfnpr_image image;
            Errors.Check(NativeMethods.hrbfnpr_image_init(&image, (uint)sizeof(hrbfnpr_image)));
            image.format = (uint)format;
            image.width = width;
            image.height = height;
            image.pixels = pixels;
            hrbfnpr_error error = Errors.New();
            if (options == null)
            {
                Errors.Check(NativeMethods.hrbfnpr_drawing_rasterize(handle, &image, null, &error), &error);
                return;
            }
            image.row_stride = options.RowStride;
            hrbfnpr_raster_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_raster_desc_init(&desc, (uint)sizeof(hrbfnpr_raster_desc)));
            using (var pins = new Pins())
            {
                options.Write(ref desc, pins);
                Errors.Check(NativeMethods.hrbfnpr_drawing_rasterize(handle, &image, &desc, &error), &error);
            }
        }

        internal static int PixelBytes(PixelFormat format)
        {
            switch (format)
            {
                case PixelFormat.Rgba32f:
                case PixelFormat.Rgba32fPremultiplied:
                    return 16;
                case PixelFormat.Coverage8:
                    return 1;
                default:
                    return 4;
            }
        }

        /// <summary>Where the top-left pixel lies among so many bytes.</summary>
        internal static long Start(long length, int width, int height, PixelFormat format, RasterOptions options)
        {
            int pixel = PixelBytes(format);
            long stride = options == null || options.RowStride == 0 ? (long)pixel * width : options.RowStride;
            if (width > 0 && height > 0 && width <= 32768 && height <= 32768)
            {
                // The bytes from the first one in memory to the last one.
                bool tooLong = Math.Abs(stride / 16) > int.MaxValue;
                if (tooLong || Math.Abs(stride) * (height - 1) + (long)pixel * width > length)
                {
                    throw new InvalidArgumentException(
                        "pixels has " + length + " bytes, too few for " + width + " x " + height + " pixels");
                }
                return stride < 0 ? -stride * (height - 1) : 0;
            }
            return 0; // sizes out of range are refused by the library before it writes
        }
    }
}
