// SPDX-License-Identifier: MIT
using System;
#if NET7_0_OR_GREATER
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Runtime.InteropServices;
#endif

namespace HrbfNpr
{
    /// <summary>Names the C struct whose layout a struct of this assembly has; a test compares both layouts.</summary>
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class NativeStructAttribute : Attribute
    {
        internal NativeStructAttribute(string name)
        {
            Name = name;
        }

        internal string Name { get; }
    }

    /// <summary>Names the prefix of the C constants that an enum has; a test compares both.</summary>
    [AttributeUsage(AttributeTargets.Enum)]
    internal sealed class NativeConstantsAttribute : Attribute
    {
        internal NativeConstantsAttribute(string prefix)
        {
            Prefix = prefix;
        }

        internal string Prefix { get; }
    }

    /// <summary>The functions of the C library.</summary>
    internal static unsafe partial class NativeMethods
    {
#if (UNITY_IOS || UNITY_WEBGL) && !UNITY_EDITOR
        internal const string Name = "__Internal"; // the library is linked into the player
#else
        // With "lib" also on Windows, where hrbfnpr.dll and HrbfNpr.dll, the name of this assembly, are the same file.
        internal const string Name = "libhrbfnpr";
#endif

#if NET7_0_OR_GREATER
        static NativeMethods()
        {
            try
            {
                NativeLibrary.SetDllImportResolver(typeof(NativeMethods).Assembly, Resolve);
            }
            catch (InvalidOperationException)
            {
                // The program has already set a resolver for this assembly, which must find the library.
            }
        }

        private static IntPtr Resolve(string name, Assembly assembly, DllImportSearchPath? searchPath)
        {
            if (name != Name)
            {
                return IntPtr.Zero;
            }
            string chosen = Environment.GetEnvironmentVariable("HRBFNPR_LIBRARY");
            if (!string.IsNullOrEmpty(chosen))
            {
                return NativeLibrary.Load(chosen); // no other file is tried
            }
            string[] fileNames = FileNames();
            foreach (string folder in Folders(assembly))
            {
                foreach (string fileName in fileNames)
                {
                    string path = Path.Combine(folder, fileName);
                    if (File.Exists(path) && NativeLibrary.TryLoad(path, out IntPtr library))
                    {
                        return library;
                    }
                }
            }
            if (NativeLibrary.TryLoad(name, assembly, searchPath, out IntPtr found))
            {
                return found;
            }
            foreach (string fileName in fileNames)
            {
                if (NativeLibrary.TryLoad(fileName, assembly, searchPath, out found))
                {
                    return found;
                }
            }
            return IntPtr.Zero; // the runtime throws DllNotFoundException
        }

        private static string[] FileNames()
        {
            if (OperatingSystem.IsWindows())
            {
                return new[] { "libhrbfnpr.dll" };
            }
            if (OperatingSystem.IsMacOS() || OperatingSystem.IsIOS())
            {
                return new[] { $"libhrbfnpr.{AbiVersion}.dylib", "libhrbfnpr.dylib" };
            }
            return new[] { $"libhrbfnpr.so.{AbiVersion}", "libhrbfnpr.so" };
        }

        private static IEnumerable<string> Folders(Assembly assembly)
        {
            string folder = AppContext.BaseDirectory;
            foreach (string rid in new[] { RuntimeInformation.RuntimeIdentifier, PortableIdentifier() })
            {
                yield return Path.Combine(folder, "runtimes", rid, "native");
            }
            yield return folder;
#pragma warning disable IL3000 // Location is empty in a single-file program, where BaseDirectory is used
            string beside = Path.GetDirectoryName(assembly.Location);
#pragma warning restore IL3000
            if (!string.IsNullOrEmpty(beside))
            {
                yield return Path.Combine(beside, "runtimes", PortableIdentifier(), "native");
                yield return beside;
            }
        }

        private static string PortableIdentifier()
        {
            string system = OperatingSystem.IsWindows() ? "win" : OperatingSystem.IsMacOS() ? "osx" : "linux";
            return system + "-" + RuntimeInformation.ProcessArchitecture.ToString().ToLowerInvariant();
        }
#endif
    }
}
