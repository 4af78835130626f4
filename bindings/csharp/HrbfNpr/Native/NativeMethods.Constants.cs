// SPDX-License-Identifier: MIT
// Made by make_native.py from include/hrbfnpr.h; do not edit.
namespace HrbfNpr
{
    internal static unsafe partial class NativeMethods
    {
        /// <summary>The ABI version that this assembly was made for.</summary>
        internal const uint AbiVersion = 1;
    }
}
