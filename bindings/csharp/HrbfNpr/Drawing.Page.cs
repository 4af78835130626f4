// SPDX-License-Identifier: MIT
using System.IO;

namespace HrbfNpr
{
    public sealed partial class Drawing
    {
        internal DrawingHandle Handle
        {
            get { return handle; }
        }

        /// <summary>Writes the drawing alone on a page, with pixels of 1/96 inch; <see cref="Page"/> does more.</summary>
        /// <param name="stream">Written to on this thread, and not closed.</param>
        /// <param name="options">An SVG with all defaults if null.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range, or the drawing has discs of paper,
        /// as Published frames have, and is to be plotted.</exception>
        /// <exception cref="StreamException">The stream failed.</exception>
        public PageInfo Save(Stream stream, PageOptions options = null)
        {
            return Page.Write(stream, new[] { new PageItem(this) }, options);
        }
    }
}
