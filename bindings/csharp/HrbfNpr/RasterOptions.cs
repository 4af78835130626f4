// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How a drawing becomes an image, and what is wanted beside the picture.</summary>
    public sealed class RasterOptions
    {
        /// <summary>
        /// Bytes from a row to the one below; 0 = packed (default).  Negative for an image whose first row in memory
        /// is the lowest: the pixels given are the top-left one's, wherever it is.
        /// </summary>
        public long RowStride { get; set; }

        /// <summary>Lay the drawing over the image's contents; wants a style with transparent paper.</summary>
        public bool Over { get; set; }

        /// <summary>Blend in linear light (sRGB decoded), not in encoded values.</summary>
        public bool LinearLight { get; set; }

        /// <summary>width * height floats in the camera's convention: hides the ink behind it.</summary>
        public ArrayView HostDepth { get; set; }

        /// <summary>width * height floats, to be filled: depth of the nearest surface.</summary>
        public ArrayView Depth { get; set; }

        /// <summary>width * height uints, to be filled: id of the nearest drawn mark, 0 = none.</summary>
        public ArrayView Id { get; set; }

        /// <summary>width * height bytes or uints, to be filled: <see cref="HrbfNpr.MarkClass"/> of that mark.</summary>
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
