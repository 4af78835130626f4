// SPDX-License-Identifier: MIT
using System;

namespace HrbfNpr
{
    /// <summary>
    /// What the lines of a surface are drawn from: contours as curves, traced on the surface itself for every camera,
    /// with a visibility that is counted and checked.
    /// </summary>
    /// <remarks>
    /// Made once for a model, by <see cref="Model.LineSet"/>; an <see cref="Item"/> that has one, and a style with
    /// lines, is drawn with curves in the place of contour marks.  Immutable: any number of threads may use a set at a
    /// time.  It keeps what it needs of the model alive.
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

        /// <summary>Counts, the size of cells, seconds and bytes.</summary>
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

        /// <summary>Of its model; called with every drawing.</summary>
        internal FunctionState Function
        {
            get { return function; }
        }

        /// <summary>Lets go of the set; a drawing needs it only while it is made.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
