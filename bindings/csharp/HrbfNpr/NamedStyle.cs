// SPDX-License-Identifier: MIT
using System;
using System.Text;

namespace HrbfNpr
{
    /// <summary>A name, also as UTF-8 with a terminating zero.</summary>
    internal readonly unsafe struct Utf8Name
    {
        internal readonly string Text;
        internal readonly byte[] Utf8;

        internal Utf8Name(string text)
        {
            Text = text;
            Utf8 = text == null ? null : Encoding.UTF8.GetBytes(text + "\0");
        }

        internal static string Read(IntPtr native)
        {
            return native == IntPtr.Zero ? null : Errors.Utf8((byte*)native);
        }
    }

    /// <summary>The base of styles of layers and of lines, which may be for those of one name only.</summary>
    public abstract unsafe class NamedStyle
    {
        private string name;

        internal NamedStyle()
        {
        }

        /// <summary>
        /// Name of the layers, or of the lines found once, that this style is for; default null = any name.
        /// </summary>
        public string Name
        {
            get
            {
                return name;
            }

            set
            {
                name = value;
                NameUtf8 = value == null ? null : Encoding.UTF8.GetBytes(value + "\0");
            }
        }

        /// <summary>The name as UTF-8 with a terminating zero.</summary>
        internal byte[] NameUtf8 { get; private set; }

        internal void ReadName(IntPtr native)
        {
            Name = native == IntPtr.Zero ? null : Errors.Utf8((byte*)native);
        }
    }
}
