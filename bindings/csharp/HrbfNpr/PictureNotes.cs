// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>One thing that making a picture chose, repaired, measured or doubts.</summary>
    public sealed unsafe class Note
    {
        internal Note(hrbfnpr_note* note)
        {
            Code = (NoteCode)note->code;
            Severity = (Severity)note->severity;
            var figures = new double[Math.Min(note->figure_count, 8)];
            for (int i = 0; i < figures.Length; ++i)
            {
                figures[i] = note->figures[i];
            }
            Figures = new ReadOnlyCollection<double>(figures);
            Text = Errors.Utf8((byte*)note->text);
            Advice = note->advice == IntPtr.Zero ? null : Errors.Utf8((byte*)note->advice);
        }

        /// <summary>What it is about.</summary>
        public NoteCode Code { get; }

        /// <summary>How much it matters.</summary>
        public Severity Severity { get; }

        /// <summary>The numbers that <see cref="NoteCode"/> names, in that order.</summary>
        public IReadOnlyList<double> Figures { get; }

        /// <summary>One sentence without a full stop.</summary>
        public string Text { get; }

        /// <summary>What to do about it; null where the text says it, or there is nothing to say.</summary>
        public string Advice { get; }

        /// <summary>The text.</summary>
        public override string ToString()
        {
            return Text;
        }
    }

    /// <summary>
    /// What happens while a picture is made or drawn: a stage goes on or is over, or there is a note.
    /// </summary>
    public sealed unsafe class PictureEvent
    {
        internal PictureEvent(hrbfnpr_picture_event* happened)
        {
            Stage = (Stage)happened->stage;
            Fraction = happened->fraction;
            Seconds = happened->seconds;
            Name = Errors.Utf8((byte*)happened->name);
            Doing = Errors.Utf8((byte*)happened->doing);
            Says = happened->says == IntPtr.Zero ? null : Errors.Utf8((byte*)happened->says);
            Note = happened->note == IntPtr.Zero ? null : new Note((hrbfnpr_note*)happened->note);
        }

        /// <summary>The stage that runs; 0 between two.</summary>
        public Stage Stage { get; }

        /// <summary>The share of the stage that is done: 0 when it begins, 1 when it is over.</summary>
        public double Fraction { get; }

        /// <summary>Seconds that the stage took, when it is over; else 0.</summary>
        public double Seconds { get; }

        /// <summary>The stage's name, such as "place marks"; empty of a note.</summary>
        public string Name { get; }

        /// <summary>The same for a progress bar, such as "placing marks"; empty of a note.</summary>
        public string Doing { get; }

        /// <summary>What the stage came to, when it is over; else null.</summary>
        public string Says { get; }

        /// <summary>A new note; null if this is about the stage.</summary>
        public Note Note { get; }
    }

    /// <summary>The program's functions that a picture calls, and what became of them in the call that runs.</summary>
    internal sealed unsafe class PictureState : CallbackState
    {
        internal static readonly IntPtr Function;
        private static readonly NativeCallbacks.PictureEvent FunctionCallback = OnHappened;
        private readonly Action<PictureEvent> onEvent;
        private readonly ToneState tone;
        private readonly CallbackState functions;
        private OperationHandle operation = OperationHandle.None;
        private string failure;

        static PictureState()
        {
            Function = Marshal.GetFunctionPointerForDelegate(FunctionCallback);
        }

        /// <param name="onEvent">May be null.</param>
        /// <param name="tone">The tone function of a style of the program's; may be null.</param>
        /// <param name="functions">The functions of models; may be null.</param>
        internal PictureState(Action<PictureEvent> onEvent, ToneState tone, CallbackState functions)
        {
            this.onEvent = onEvent;
            this.tone = tone;
            this.functions = functions;
        }

        /// <summary>Whether calls need an operation: an event function that throws cancels them.</summary>
        internal bool IsWatched
        {
            get { return onEvent != null; }
        }

        /// <summary>Before a call; with the operation that an exception cancels.</summary>
        internal void Begin(OperationHandle operation)
        {
            this.operation = operation;
            failure = null;
            TakeException();
        }

        /// <summary>After a call: throws what a function of the program threw, or what the call says.</summary>
        internal void Check(LongCall call, int status, hrbfnpr_error* error)
        {
            operation = OperationHandle.None;
            Throw("event", TakeException());
            Throw("tone", tone == null ? null : tone.TakeException());
            if (status == (int)Status.InvalidArgument && failure != null)
            {
                throw new InvalidArgumentException(failure); // longer than an error has room for
            }
            if (call != null)
            {
                call.Check(status, error, functions);
            }
            else
            {
                Errors.Check(status, error);
            }
        }

        private static void Throw(string name, Exception thrown)
        {
            if (thrown != null)
            {
                throw new CallbackException("the " + name + " function threw: " + thrown.Message, thrown);
            }
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.PictureEvent))]
        private static void OnHappened(IntPtr user, hrbfnpr_picture_event* happened)
        {
            From<PictureState>(user).Tell(happened);
        }

        private void Tell(hrbfnpr_picture_event* happened)
        {
            try
            {
                var note = (hrbfnpr_note*)happened->note;
                if (note != null && note->severity == (uint)Severity.Failure)
                {
                    failure = Errors.Utf8((byte*)note->text);
                }
                if (onEvent != null && LastException == null)
                {
                    onEvent(new PictureEvent(happened));
                }
            }
            catch (Exception exception)
            {
                Keep(exception);
                NativeMethods.hrbfnpr_operation_cancel(operation);
            }
        }
    }
}
