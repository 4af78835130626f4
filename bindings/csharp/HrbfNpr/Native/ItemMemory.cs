// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr
{
    /// <summary>
    /// Writes items as structs of the library, in native memory that is kept from one call to the next.  One thread may
    /// use it at a time.
    /// </summary>
    internal sealed unsafe class ItemMemory : IDisposable
    {
        private readonly Memory memory = new Memory();
        private readonly HeldHandles held = new HeldHandles();
        private readonly Pins pins = new Pins();
        private readonly List<ToneState> tones = new List<ToneState>();
        private readonly List<UserHandle> users = new List<UserHandle>();

        /// <summary>Releases the memory.</summary>
        public void Dispose()
        {
            Clear();
            memory.Dispose();
        }

        /// <summary>
        /// Writes a struct for each item.  What they point to stays alive until <see cref="Clear"/>, which is needed
        /// even if this throws.
        /// </summary>
        /// <param name="items">The items.</param>
        /// <param name="shaded">Whether to write the shadings, which may have been disposed of otherwise.</param>
        internal hrbfnpr_item* Write(IReadOnlyList<Item> items, bool shaded = true)
        {
            int count = items.Count;
            long size = 0;
            for (int i = 0; i < count; ++i)
            {
                if (items[i] == null)
                {
                    throw new ArgumentNullException(nameof(items));
                }
                size += Size(items[i]);
            }
            memory.Begin(size);
            var first = (hrbfnpr_item*)memory.Take((long)count * sizeof(hrbfnpr_item));
            for (int i = 0; i < count; ++i)
            {
                Describe(items[i], shaded, first + i);
            }
            return first;
        }

        /// <summary>Lets go of everything that the structs point to.</summary>
        internal void Clear()
        {
            held.Dispose();
            pins.Dispose();
            tones.Clear();
            foreach (UserHandle user in users)
            {
                user.Dispose();
            }
            users.Clear();
        }

        /// <summary>Throws what a tone function threw, or, after a call that failed, the function of a model.</summary>
        internal void CheckFunctions(IReadOnlyList<Item> items, int status)
        {
            foreach (ToneState tone in tones)
            {
                Exception thrown = tone.TakeException();
                if (thrown != null)
                {
                    throw new CallbackException("the tone function threw: " + thrown.Message, thrown);
                }
            }
            for (int i = 0; status != 0 && i < items.Count; ++i)
            {
                CheckFunction(items[i].Model == null ? null : items[i].Model.Function);
                CheckFunction(items[i].LineSet == null ? null : items[i].LineSet.Function);
            }
        }

        private static long Size(Item item)
        {
            long size = Memory.Rounded(sizeof(hrbfnpr_item))
                + Memory.Rounded((long)item.Poses.Count * sizeof(hrbfnpr_layer_pose));
            return item.Style == null ? size : size + StyleMemory.Size(item.Style);
        }

        private void Describe(Item item, bool shaded, hrbfnpr_item* native)
        {
            Errors.Check(NativeMethods.hrbfnpr_item_init(native, (uint)sizeof(hrbfnpr_item)));
            native->sides = (uint)item.Sides;
            native->point_set = held.Hold(item.PointSet.Handle);
            if (item.Model != null)
            {
                native->model = held.Hold(item.Model.Handle);
            }
            if (item.LineSet != null)
            {
                native->line_set = held.Hold(item.LineSet.Handle);
            }
            if (shaded && item.Shading != null)
            {
                native->shading = held.Hold(item.Shading.Handle);
            }
            if (item.Style != null)
            {
                native->style = (IntPtr)Describe(item.Style);
            }
            double[] transform = item.Transform;
            for (int i = 0; transform != null && i < 16; ++i)
            {
                native->transform[i] = transform[i];
            }
            int poses = item.Poses.Count;
            if (poses > 0)
            {
                var pose = (hrbfnpr_layer_pose*)memory.Take((long)poses * sizeof(hrbfnpr_layer_pose));
                native->poses = (IntPtr)pose;
                native->pose_count = poses;
                for (int i = 0; i < poses; ++i)
                {
                    if (item.Poses[i] == null)
                    {
                        throw new ArgumentNullException(nameof(item.Poses));
                    }
                    item.Poses[i].Write(pose + i, pins);
                }
            }
        }

        private hrbfnpr_style* Describe(Style style)
        {
            hrbfnpr_style* native = StyleMemory.Write(style, memory);
            if (style.ToneFunction != null)
            {
                var tone = new ToneState(style.ToneFunction);
                tones.Add(tone);
                users.Add(new UserHandle(tone));
                native->tone_function = ToneState.Function;
                native->tone_user = users[users.Count - 1].Pointer;
            }
            else if (style.NativeTone != null)
            {
                native->tone_function = style.NativeTone.Function;
                native->tone_user = style.NativeTone.Hold(held);
            }
            return native;
        }

        private static void CheckFunction(FunctionState function)
        {
            Exception thrown = function == null ? null : function.TakeException();
            if (thrown != null)
            {
                throw new CallbackException("the function of a model threw: " + thrown.Message, thrown);
            }
        }
    }
}
