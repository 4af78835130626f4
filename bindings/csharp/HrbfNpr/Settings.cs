// SPDX-License-Identifier: MIT
using System;
using System.IO;

namespace HrbfNpr
{
    /// <summary>
    /// What a picture is made with, as a file of JSON that <see cref="Picture.SaveSettings(Stream)"/>, the command
    /// line or the viewer wrote; see docs/settings.md of the project.
    /// </summary>
    /// <remarks>Immutable: any number of threads may use it at a time.</remarks>
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
        /// <param name="stream">Read from on this thread to its end, and not closed.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="InvalidArgumentException">The message names the key, and says what would be
        /// right.</exception>
        /// <exception cref="StreamException">The stream failed.</exception>
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

        /// <summary>Reads a file of settings.</summary>
        /// <param name="path">The file.</param>
        /// <param name="context">The default context if null.</param>
        /// <exception cref="InvalidArgumentException">The message names the key, and says what would be
        /// right.</exception>
        public static Settings Load(string path, Context context = null)
        {
            using (FileStream file = File.OpenRead(path))
            {
                return Load(file, context);
            }
        }

        /// <summary>Lets go of the settings; pictures that were made with them keep them.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }
    }
}
