// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace HrbfNpr
{
    /// <summary>The native library that this assembly has loaded.  Any thread may use this class.</summary>
    /// <remarks>
    /// With .NET 7 and later, the library is looked for at the path in the environment variable HRBFNPR_LIBRARY.  If
    /// that is set, no other place is tried.  Else it is looked for in <c>runtimes/RID/native</c>, in the folder of the
    /// program and of this assembly, and where the system's loader looks.  Older runtimes look in their own places.
    /// </remarks>
    public static unsafe class Library
    {
        /// <summary>The library's version, "major.minor.patch".</summary>
        /// <exception cref="DllNotFoundException">The library was not found.</exception>
        public static string Version
        {
            get { return Errors.Utf8(NativeMethods.hrbfnpr_version_string()); }
        }

        /// <summary>The library's version as major * 10000 + minor * 100 + patch.</summary>
        public static int VersionNumber
        {
            get { return (int)NativeMethods.hrbfnpr_version(); }
        }

        /// <summary>
        /// The library's ABI version.  No context can be made if it differs from that of this assembly.
        /// </summary>
        public static int AbiVersion
        {
            get { return (int)NativeMethods.hrbfnpr_abi_version(); }
        }

        /// <summary>
        /// What the library's build is, as one JSON object: version, compiler, instruction sets and so on.
        /// </summary>
        public static string BuildInfo
        {
            get
            {
                long needed;
                NativeMethods.hrbfnpr_build_info(null, 0, &needed);
                var text = new byte[needed];
                fixed (byte* destination = text)
                {
                    Errors.Check(NativeMethods.hrbfnpr_build_info(destination, needed, &needed));
                }
                return Encoding.UTF8.GetString(text, 0, (int)needed - 1);
            }
        }
    }
}
