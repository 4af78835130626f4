// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>
    /// How a drawing is drawn into an image, and which arrays are filled with it; a new one holds all defaults.
    /// </summary>
    /// <remarks>Each array has width * height elements, row by row from the top-left pixel of the image.</remarks>
    public sealed class RasterOptions
    {
        /// <summary>
        /// Bytes from a row to the row below; default 0 = packed.  Negative for an image that is stored bottom-up.
        /// </summary>
        /// <remarks>With native memory, pass the address of the top-left pixel for either sign.</remarks>
        public long RowStride { get; set; }

        /// <summary>
        /// Whether to lay the drawing over the image instead of replacing the image inside the viewport; default false.
        /// Use it with transparent paper.
        /// </summary>
        public bool Over { get; set; }

        /// <summary>
        /// Whether to blend in linear light (sRGB decoded) instead of in encoded values; default false.
        /// </summary>
        public bool LinearLight { get; set; }

        /// <summary>
        /// Depth of the host's scene in the camera's depth convention, float; ink behind it is not drawn; default not
        /// given.
        /// </summary>
        public ArrayView HostDepth { get; set; }

        /// <summary>
        /// Receives the depth of the nearest surface in the camera's depth convention, float; the far plane where there
        /// is no surface; default not given.
        /// </summary>
        public ArrayView Depth { get; set; }

        /// <summary>Receives the id of the nearest drawn mark, uint; 0 = none; default not given.</summary>
        public ArrayView Id { get; set; }

        /// <summary>
        /// Receives the class of that mark (<see cref="HrbfNpr.MarkClass"/>), byte or uint; default not given.
        /// </summary>
        public ArrayView MarkClass { get; set; }

        internal void Write(ref hrbfnpr_raster_desc desc, Pins pins)
        {
            desc.flags = (Over ? 1u : 0) | (LinearLight ? 2u : 0);
            desc.host_depth = HostDepth.ToNative(pins, 1, nameof(HostDepth));
            desc.depth = Depth.ToNative(pins, 1, nameof(Depth));
            desc.id = Id.ToNative(pins, 1, nameof(Id));
            desc.mark_class = MarkClass.ToNative(pins, 1, nameof(MarkClass));
        }
    }
}
