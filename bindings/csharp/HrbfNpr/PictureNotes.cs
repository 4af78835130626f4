// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Collections.ObjectModel;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    /// <summary>A note: something that was chosen, repaired, left out or measured, or that may be wrong.</summary>
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
            Detail = note->detail == IntPtr.Zero ? null : Errors.Utf8((byte*)note->detail);
        }

        /// <summary>What the note is about.</summary>
        public NoteCode Code { get; }

        /// <summary>How much it matters.</summary>
        public Severity Severity { get; }

        /// <summary>The figures of its <see cref="NoteCode"/>, in the order of the brackets there.</summary>
        public IReadOnlyList<double> Figures { get; }

        /// <summary>A short sentence without a full stop.</summary>
        public string Text { get; }

        /// <summary>What to do about it; null if the text says it or nothing needs doing.</summary>
        public string Advice { get; }

        /// <summary>One or two more sentences that explain the text; null if none.</summary>
        public string Detail { get; }

        /// <summary>The text.</summary>
        public override string ToString()
        {
            return Text;
        }
    }

    /// <summary>What happens while a picture is made or drawn: a new note, or the progress of a stage.</summary>
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

        /// <summary>The stage that runs; 0 if none runs.</summary>
        public Stage Stage { get; }

        /// <summary>Progress of the stage: 0 when it begins, 1 when it ends; 0 with a note.</summary>
        public double Fraction { get; }

        /// <summary>Time that the stage took, in seconds, when it ends; else 0.</summary>
        public double Seconds { get; }

        /// <summary>Name of the stage, such as "place marks"; empty with a note.</summary>
        public string Name { get; }

        /// <summary>The same for a progress bar, such as "placing marks"; empty with a note.</summary>
        public string Doing { get; }

        /// <summary>Result of the stage in words, when it ends; else null.</summary>
        public string Says { get; }

        /// <summary>A new note; null if the event is about the stage.</summary>
        public Note Note { get; }
    }

    /// <summary>
    /// The functions of the program that a picture runs, and what they threw during the running call.
    /// </summary>
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

        /// <param name="onEvent">Receives events; may be null.</param>
        /// <param name="tone">The tone function of the program's style; may be null.</param>
        /// <param name="functions">The functions of models; may be null.</param>
        internal PictureState(Action<PictureEvent> onEvent, ToneState tone, CallbackState functions)
        {
            this.onEvent = onEvent;
            this.tone = tone;
            this.functions = functions;
        }

        /// <summary>Whether calls need an operation, because the event function cancels them if it throws.</summary>
        internal bool IsWatched
        {
            get { return onEvent != null; }
        }

        /// <summary>Prepares a call.  <paramref name="operation"/> is cancelled if the event function throws.</summary>
        internal void Begin(OperationHandle operation)
        {
            this.operation = operation;
            failure = null;
            TakeException();
        }

        /// <summary>Ends a call: throws what a function of the program threw, or the failure of the call.</summary>
        internal void Check(LongCall call, int status, hrbfnpr_error* error)
        {
            operation = OperationHandle.None;
            Throw("event", TakeException());
            Throw("tone", tone == null ? null : tone.TakeException());
            if (status == (int)Status.InvalidArgument && failure != null)
            {
                throw new InvalidArgumentException(failure); // the message of an error may have cut it
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
