// SPDX-License-Identifier: MIT
using System;
using System.Text;

namespace HrbfNpr
{
    /// <summary>What styles of layers and of lines have in common: whom they are for may be told by a name.</summary>
    public abstract unsafe class NamedStyle
    {
        private string name;

        internal NamedStyle()
        {
        }

        /// <summary>Of layers, and of lines found once: those that are called so; null = any name.</summary>
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

        /// <summary>The name with a zero behind it.</summary>
        internal byte[] NameUtf8 { get; private set; }

        internal void ReadName(IntPtr native)
        {
            Name = native == IntPtr.Zero ? null : Errors.Utf8((byte*)native);
        }
    }
}
