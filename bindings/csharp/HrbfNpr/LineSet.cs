// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>Holds what the lines of one model are drawn from, for every camera.</summary>
    /// <remarks>
    /// Contours are traced as curves on the surface itself, and their visibility is counted and checked.
    /// <see cref="Model.LineSet"/> makes a line set once for a model.  An <see cref="Item"/> that has one, and a style
    /// with lines, is drawn with curves.  A line set never changes, so several threads may use it at the same time.  It
    /// keeps the model's data alive.
    /// </remarks>
    /// <example>
    /// <code>
    /// using (LineSet lines = model.LineSet())
    /// using (Drawing drawing = renderer.Draw(new Item(marks, Style.Preset(Preset.Xray)) { LineSet = lines }, camera))
    /// {
    ///     byte[] pixels = drawing.Rasterize();
    /// }
    /// </code>
    /// </example>
    public sealed unsafe class LineSet : IDisposable
    {
        private readonly LineSetHandle handle;
        private readonly FunctionState function;

        internal LineSet(LineSetHandle handle, FunctionState function)
        {
            this.handle = handle;
            this.function = function;
        }

        /// <summary>What making the line set found.</summary>
        public LineSetInfo Info
        {
            get
            {
                LineSetInfo info;
                Errors.Check(NativeMethods.hrbfnpr_line_set_info_init(&info, (uint)sizeof(LineSetInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_line_set_get_info(handle, &info, &error), &error);
                return info;
            }
        }

        internal LineSetHandle Handle
        {
            get { return handle; }
        }

        /// <summary>The function of its model; it runs in every drawing.</summary>
        internal FunctionState Function
        {
            get { return function; }
        }

        /// <summary>Releases the line set.  A drawing needs it only while it is made.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
