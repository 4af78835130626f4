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

        /// <summary>
        /// Writes the drawing alone on a page, with pixels of 1/96 inch.  <see cref="Page"/> writes several drawings,
        /// lines and texts.
        /// </summary>
        /// <param name="stream">The stream, which is written on this thread and is not closed.</param>
        /// <param name="options">The options; null = an SVG with all defaults.</param>
        /// <exception cref="InvalidArgumentException">A number is out of its range, or a drawing with
        /// Visibility.Published, which has discs of paper, is written for a plotter or in plot order.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public PageInfo Save(Stream stream, PageOptions options = null)
        {
            return Page.Write(stream, new[] { new PageItem(this) }, options);
        }
    }
}
