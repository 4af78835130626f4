// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace HrbfNpr
{
    /// <summary>The native library that this assembly has loaded.</summary>
    /// <remarks>
    /// With .NET 7 and later it is looked for in the environment variable HRBFNPR_LIBRARY (then nowhere else), in
    /// <c>runtimes/RID/native</c> and in the folder of the program and of this assembly, and where the system's
    /// loader looks; elsewhere where the runtime looks.  Any thread may use this class.
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

        /// <summary>The library's ABI version; a context of another one than this assembly's cannot be made.</summary>
        public static int AbiVersion
        {
            get { return (int)NativeMethods.hrbfnpr_abi_version(); }
        }

        /// <summary>What the library's build is, as one JSON object: version, compiler, instruction sets and so on.</summary>
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
