// SPDX-License-Identifier: MIT
using System;
using System.IO;

namespace HrbfNpr
{
    /// <summary>
    /// What a picture is made with, as a JSON file that <see cref="Picture.SaveSettings(Stream)"/>, the command line or
    /// the viewer wrote. docs/settings.md describes the format.
    /// </summary>
    /// <remarks>It never changes, so several threads may use it at the same time.</remarks>
    public sealed class Settings : IDisposable
    {
        private readonly SettingsHandle handle;

        private Settings(SettingsHandle handle)
        {
            this.handle = handle;
        }

        internal SettingsHandle Handle
        {
            get { return handle; }
        }

        /// <summary>Reads settings.</summary>
        /// <param name="stream">The stream, which is read to its end on this thread and is not closed.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="InvalidArgumentException">The settings are wrong; the message names the key and says what
        /// would be right.</exception>
        /// <exception cref="StreamException">The stream threw an exception, which is the InnerException.</exception>
        public static unsafe Settings Load(Stream stream, Context context = null)
        {
            context = Context.Resolve(context);
            var state = new StreamState(stream);
            using (var user = new UserHandle(state))
            {
                hrbfnpr_error error = Errors.New();
                var made = new SettingsHandle();
                int status = NativeMethods.hrbfnpr_settings_load(
                    context.Handle, StreamState.Read, user.Pointer, out IntPtr created, &error);
                made.Take(created, context.Anchor);
                state.Check(status, &error);
                return new Settings(made);
            }
        }

        /// <summary>Reads settings from a file.</summary>
        /// <param name="path">The file.</param>
        /// <param name="context">The context; null = the default context.</param>
        /// <exception cref="InvalidArgumentException">The settings are wrong; the message names the key and says what
        /// would be right.</exception>
        public static Settings Load(string path, Context context = null)
        {
            using (FileStream file = File.OpenRead(path))
            {
                return Load(file, context);
            }
        }

        /// <summary>Releases the settings.  Pictures that were made with them keep them alive.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
