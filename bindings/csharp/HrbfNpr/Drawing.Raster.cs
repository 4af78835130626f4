// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    public sealed unsafe partial class Drawing
    {
        /// <summary>Draws an image of the size of the camera's viewport.</summary>
        /// <param name="format">The format of the pixels.  Formats of floats are returned as bytes, too.</param>
        /// <returns>The pixels of an image of <see cref="Width"/> x <see cref="Height"/>, packed.</returns>
        public byte[] Rasterize(PixelFormat format = PixelFormat.Rgba8)
        {
            var pixels = new byte[(long)PixelBytes(format) * Width * Height];
            Rasterize(pixels, Width, Height, format);
            return pixels;
        }

        /// <summary>
        /// Draws into an image.  It fills the viewport, clipped to the image, with paper and ink, and leaves other
        /// pixels as they are.
        /// </summary>
        /// <param name="pixels">The image.</param>
        /// <param name="width">The width in pixels; 1 to 32768.</param>
        /// <param name="height">The height in pixels; 1 to 32768.</param>
        /// <param name="format">The format of the pixels.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <exception cref="InvalidArgumentException">The array is too short, or an option is out of its
        /// range.</exception>
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

        /// <summary>Draws into an image of floats, like the other <c>Rasterize</c>.</summary>
        /// <param name="pixels">The image, with 4 numbers for each pixel.</param>
        /// <param name="width">The width in pixels; 1 to 32768.</param>
        /// <param name="height">The height in pixels; 1 to 32768.</param>
        /// <param name="format">The format of the pixels: Rgba32f or Rgba32fPremultiplied.</param>
        /// <param name="options">The options; null = all defaults.</param>
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
        /// <summary>Draws into a span, like the other <c>Rasterize</c>.</summary>
        /// <param name="pixels">The image.</param>
        /// <param name="width">The width in pixels; 1 to 32768.</param>
        /// <param name="height">The height in pixels; 1 to 32768.</param>
        /// <param name="format">The format of the pixels.</param>
        /// <param name="options">The options; null = all defaults.</param>
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

        /// <summary>Draws into a span of floats, like the other <c>Rasterize</c>.</summary>
        /// <param name="pixels">The image, with 4 numbers for each pixel.</param>
        /// <param name="width">The width in pixels; 1 to 32768.</param>
        /// <param name="height">The height in pixels; 1 to 32768.</param>
        /// <param name="format">The format of the pixels: Rgba32f or Rgba32fPremultiplied.</param>
        /// <param name="options">The options; null = all defaults.</param>
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

        /// <summary>
        /// Draws into native memory, such as that of a texture or a NativeArray, like the other <c>Rasterize</c>.
        /// </summary>
        /// <param name="pixels">The address of the top-left pixel, for either sign of the row stride.</param>
        /// <param name="width">The width in pixels; 1 to 32768.</param>
        /// <param name="height">The height in pixels; 1 to 32768.</param>
        /// <param name="format">The format of the pixels.</param>
        /// <param name="options">The options; null = all defaults.</param>
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

        /// <summary>The offset of the top-left pixel in an image of <paramref name="length"/> bytes.</summary>
        internal static long Start(long length, int width, int height, PixelFormat format, RasterOptions options)
        {
            int pixel = PixelBytes(format);
            long stride = options == null || options.RowStride == 0 ? (long)pixel * width : options.RowStride;
            if (width > 0 && height > 0 && width <= 32768 && height <= 32768)
            {
                // The number of bytes from the first byte of the image in memory to its last one.
                bool tooLong = Math.Abs(stride / 16) > int.MaxValue;
                if (tooLong || Math.Abs(stride) * (height - 1) + (long)pixel * width > length)
                {
                    throw new InvalidArgumentException(
                        "pixels has " + length + " bytes, too few for " + width + " x " + height + " pixels");
                }
                return stride < 0 ? -stride * (height - 1) : 0;
            }
            return 0; // the library refuses sizes out of range before it writes
        }
    }
}
