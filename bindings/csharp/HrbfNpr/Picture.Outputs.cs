// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Threading;

namespace HrbfNpr
{
    public sealed unsafe partial class Picture
    {
        /// <summary>The size of the plate, in pixels.</summary>
        /// <param name="camera">The camera that the drawing was made with; null = <see cref="Camera"/>.</param>
        /// <exception cref="InvalidArgumentException">The picture was made with SurfaceOnly.</exception>
        public (int Width, int Height) PlateSize(Camera camera = null)
        {
            int width, height;
            hrbfnpr_camera view = camera == null ? default(hrbfnpr_camera) : camera.Native;
            hrbfnpr_error error = Errors.New();
            lock (gate)
            {
                Errors.Check(
                    NativeMethods.hrbfnpr_picture_plate_size(
                        handle, camera == null ? null : &view, &width, &height, &error),
                    &error);
            }
            return (width, height);
        }

        /// <summary>Draws the plate of <see cref="Drawing"/> as an image.</summary>
        /// <param name="format">The format of the pixels.  Formats of floats are returned as bytes, too.</param>
        /// <returns>The pixels of an image of the size <see cref="PlateSize"/>, packed.</returns>
        public byte[] Rasterize(PixelFormat format = PixelFormat.Rgba8)
        {
            return Rasterize(Drawing, format);
        }

        /// <summary>Draws the plate of a drawing as an image.</summary>
        /// <param name="drawing">A drawing of this picture.</param>
        /// <param name="format">The format of the pixels.  Formats of floats are returned as bytes, too.</param>
        /// <returns>The pixels of an image of the size <see cref="PlateSize"/>, packed.</returns>
        public byte[] Rasterize(Drawing drawing, PixelFormat format = PixelFormat.Rgba8)
        {
            if (drawing == null)
            {
                throw new ArgumentNullException(nameof(drawing));
            }
            (int width, int height) = PlateSize(drawing.Camera);
            var pixels = new byte[(long)Drawing.PixelBytes(format) * width * height];
            fixed (byte* first = pixels)
            {
                Rasterize((IntPtr)first, width, height, format, 0, drawing);
            }
            return pixels;
        }

        /// <summary>
        /// Draws the plate into an image, from the top-left corner on.  Other pixels stay as they are.
        /// </summary>
        /// <param name="pixels">The image, packed.</param>
        /// <param name="width">The width of the image in pixels, at least the plate's.</param>
        /// <param name="height">The height of the image in pixels, at least the plate's.</param>
        /// <param name="format">The format of the pixels.</param>
        /// <param name="drawing">A drawing of this picture; null = <see cref="Drawing"/>.</param>
        /// <exception cref="InvalidArgumentException">The array or the image is too small.</exception>
        public void Rasterize(
            byte[] pixels, int width, int height, PixelFormat format = PixelFormat.Rgba8, Drawing drawing = null)
        {
            if (pixels == null)
            {
                throw new ArgumentNullException(nameof(pixels));
            }
            Drawing.Start(pixels.LongLength, width, height, format, null);
            fixed (byte* first = pixels)
            {
                Rasterize((IntPtr)first, width, height, format, 0, drawing);
            }
        }

#if NET7_0_OR_GREATER
        /// <summary>Draws the plate into a span, like the other <c>Rasterize</c>.</summary>
        /// <param name="pixels">The image, packed.</param>
        /// <param name="width">The width of the image in pixels, at least the plate's.</param>
        /// <param name="height">The height of the image in pixels, at least the plate's.</param>
        /// <param name="format">The format of the pixels.</param>
        /// <param name="drawing">A drawing of this picture; null = <see cref="Drawing"/>.</param>
        public void Rasterize(
            Span<byte> pixels, int width, int height, PixelFormat format = PixelFormat.Rgba8, Drawing drawing = null)
        {
            Drawing.Start(pixels.Length, width, height, format, null);
            fixed (byte* first = pixels)
            {
                Rasterize((IntPtr)first, width, height, format, 0, drawing);
            }
        }
#endif

        /// <summary>
        /// Draws the plate into native memory, such as that of a texture or a NativeArray, like the other
        /// <c>Rasterize</c>.
        /// </summary>
        /// <param name="pixels">The address of the top-left pixel, for either sign of the row stride.</param>
        /// <param name="width">The width of the image in pixels, at least the plate's.</param>
        /// <param name="height">The height of the image in pixels, at least the plate's.</param>
        /// <param name="format">The format of the pixels.</param>
        /// <param name="rowStride">The bytes from a row to the row below; may be negative; 0 = packed.</param>
        /// <param name="drawing">A drawing of this picture; null = <see cref="Drawing"/>.</param>
        /// <exception cref="InvalidArgumentException">The image is too small.</exception>
        public void Rasterize(
            IntPtr pixels, int width, int height, PixelFormat format = PixelFormat.Rgba8, long rowStride = 0,
            Drawing drawing = null)
        {
            hrbfnpr_image image;
            Errors.Check(NativeMethods.hrbfnpr_image_init(&image, (uint)sizeof(hrbfnpr_image)));
            image.format = (uint)format;
            image.width = width;
            image.height = height;
            image.pixels = pixels;
            image.row_stride = rowStride;
            drawing = drawing ?? Drawing;
            hrbfnpr_camera camera = drawing.Camera.Native;
            hrbfnpr_error error = Errors.New();
            lock (gate)
            {
                Errors.Check(
                    NativeMethods.hrbfnpr_picture_rasterize(handle, drawing.Handle, &camera, &image, &error), &error);
            }
        }

        /// <summary>Writes the plate as vectors.</summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <param name="options">The options; null = an SVG with all defaults.</param>
        /// <param name="drawing">A drawing of this picture; null = <see cref="Drawing"/>.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range, a paper is not known or has no
        /// room, or a drawing with Visibility.Published, which has discs of paper, is written for a plotter or in plot
        /// order.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public PageInfo Write(
            Stream stream, PicturePageOptions options = null, Drawing drawing = null,
            IProgress<double> progress = null, CancellationToken cancellationToken = default(CancellationToken))
        {
            return Write(stream, null, options, drawing, progress, cancellationToken);
        }

        /// <summary>Writes the plate of <see cref="Drawing"/> as SVG.</summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <param name="options">The options, without their format; null = all defaults.</param>
        public PageInfo WriteSvg(Stream stream, PicturePageOptions options = null)
        {
            return Write(stream, PageFormat.Svg, options, null, null, default(CancellationToken));
        }

        /// <summary>Writes the plate of <see cref="Drawing"/> to an SVG file.</summary>
        /// <param name="path">The file, which is created or replaced.</param>
        /// <param name="options">The options, without their format; null = all defaults.</param>
        public PageInfo WriteSvg(string path, PicturePageOptions options = null)
        {
            return Write(path, PageFormat.Svg, options);
        }

        /// <summary>Writes the plate of <see cref="Drawing"/> as PDF.</summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <param name="options">The options, without their format; null = all defaults.</param>
        public PageInfo WritePdf(Stream stream, PicturePageOptions options = null)
        {
            return Write(stream, PageFormat.Pdf, options, null, null, default(CancellationToken));
        }

        /// <summary>Writes the plate of <see cref="Drawing"/> to a PDF file.</summary>
        /// <param name="path">The file, which is created or replaced.</param>
        /// <param name="options">The options, without their format; null = all defaults.</param>
        public PageInfo WritePdf(string path, PicturePageOptions options = null)
        {
            return Write(path, PageFormat.Pdf, options);
        }

        /// <summary>
        /// Writes a technical drawing of the first part, which must have a model: orthographic views and sections on a
        /// sheet, to scale.  A picture made with <see cref="PictureOptions.SurfaceOnly"/> is enough.
        /// </summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <param name="options">The options; null = all defaults.</param>
        /// <param name="progress">Receives the progress, from 0 to 1, on this thread; may be null.</param>
        /// <param name="cancellationToken">Cancels the call.</param>
        /// <exception cref="InvalidArgumentException">The picture is of a point set, a text is not understood, a plane
        /// misses the model, or the views have no room on the paper at the scale: the message names a scale or paper
        /// with room.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public ViewsInfo WriteViews(
            Stream stream, ViewsOptions options = null, IProgress<double> progress = null,
            CancellationToken cancellationToken = default(CancellationToken))
        {
            var target = new StreamState(stream);
            using (var pins = new Pins())
            using (var user = new UserHandle(target))
            {
                return Work(progress, cancellationToken, call =>
                {
                    hrbfnpr_views_desc desc;
                    (options ?? new ViewsOptions()).Write(&desc, pins);
                    ViewsInfo info;
                    Errors.Check(NativeMethods.hrbfnpr_views_info_init(&info, (uint)sizeof(ViewsInfo)));
                    hrbfnpr_error error = Errors.New();
                    int status = NativeMethods.hrbfnpr_picture_write_views(
                        handle, &desc, StreamState.Write, user.Pointer, &info, call.Operation, &error);
                    target.CheckStream();
                    state.Check(call, status, &error);
                    return info;
                });
            }
        }

        /// <summary>Writes what the picture was made with, for <see cref="PictureOptions.Settings"/>.</summary>
        /// <remarks>
        /// The picture gets a note <see cref="NoteCode.NotInSettings"/> about what settings do not hold.
        /// </remarks>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <exception cref="InvalidArgumentException">The picture was made with SurfaceOnly.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public void SaveSettings(Stream stream)
        {
            var target = new StreamState(stream);
            using (var user = new UserHandle(target))
            {
                Work(null, default(CancellationToken), call =>
                {
                    hrbfnpr_error error = Errors.New();
                    int status = NativeMethods.hrbfnpr_picture_write_settings(
                        handle, StreamState.Write, user.Pointer, &error);
                    target.CheckStream();
                    state.Check(call, status, &error);
                    return status;
                });
            }
        }

        /// <summary>Writes what the picture was made with to a JSON file.</summary>
        /// <param name="path">The file, which is created or replaced.</param>
        public void SaveSettings(string path)
        {
            using (FileStream file = File.Create(path))
            {
                SaveSettings(file);
            }
        }

        private PageInfo Write(string path, PageFormat format, PicturePageOptions options)
        {
            using (FileStream file = File.Create(path))
            {
                return Write(file, format, options, null, null, default(CancellationToken));
            }
        }

        private PageInfo Write(
            Stream stream, PageFormat? format, PicturePageOptions options, Drawing drawing,
            IProgress<double> progress, CancellationToken token)
        {
            var target = new StreamState(stream);
            drawing = drawing ?? Drawing;
            using (var pins = new Pins())
            using (var user = new UserHandle(target))
            {
                return Work(progress, token, call =>
                {
                    hrbfnpr_picture_page_desc desc;
                    (options ?? new PicturePageOptions()).Write(&desc, format, pins);
                    PageInfo info;
                    Errors.Check(NativeMethods.hrbfnpr_page_info_init(&info, (uint)sizeof(PageInfo)));
                    hrbfnpr_camera camera = drawing.Camera.Native;
                    hrbfnpr_error error = Errors.New();
                    int status = NativeMethods.hrbfnpr_picture_write(
                        handle, drawing.Handle, &camera, &desc, StreamState.Write, user.Pointer, &info,
                        call.Operation, &error);
                    target.CheckStream();
                    state.Check(call, status, &error);
                    return info;
                });
            }
        }
    }
}
