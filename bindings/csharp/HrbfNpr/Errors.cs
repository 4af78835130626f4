// SPDX-License-Identifier: MIT
using System;
using System.Text;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>A call of the library failed; there is a subclass for each status.</summary>
    public class HrbfNprException : Exception
    {
        /// <summary>Makes one; the library's are made by its calls.</summary>
        public HrbfNprException(Status status, string message, Exception innerException = null)
            : base(message, innerException)
        {
            Status = status;
        }

        /// <summary>The library's status; a number that is in no list is to be treated like Internal.</summary>
        public Status Status { get; }
    }

    /// <summary>An argument was wrong; the message names it and says what would be right.</summary>
    public sealed class InvalidArgumentException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public InvalidArgumentException(string message)
            : base(Status.InvalidArgument, message)
        {
        }
    }

    /// <summary>There was not enough native memory.</summary>
    public sealed class NativeOutOfMemoryException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public NativeOutOfMemoryException(string message)
            : base(Status.OutOfMemory, message)
        {
        }
    }

    /// <summary>A destination was too small; nothing was written to it.</summary>
    public sealed class BufferTooSmallException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public BufferTooSmallException(string message)
            : base(Status.BufferTooSmall, message)
        {
        }
    }

    /// <summary>The library is older than this assembly and does not know a field that was set.</summary>
    public sealed class UnsupportedStructException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public UnsupportedStructException(string message)
            : base(Status.UnsupportedStruct, message)
        {
        }
    }

    /// <summary>The fit has no (numerically) unique solution.</summary>
    public sealed class SingularSystemException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public SingularSystemException(string message)
            : base(Status.SingularSystem, message)
        {
        }
    }

    /// <summary>An iteration ended short of its goal.</summary>
    public sealed class NotConvergedException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public NotConvergedException(string message)
            : base(Status.NotConverged, message)
        {
        }
    }

    /// <summary>
    /// The call was cancelled through its token.  It is .NET's own kind, so that a task that runs the call ends as
    /// cancelled and not as failed; it is the one status that is not a <see cref="HrbfNprException"/>.
    /// </summary>
    public sealed class CancelledException : OperationCanceledException
    {
        /// <summary>Makes one.</summary>
        public CancelledException(string message, CancellationToken token)
            : base(message, token)
        {
        }

        /// <summary>Always <see cref="Status.Cancelled"/>.</summary>
        public Status Status
        {
            get { return Status.Cancelled; }
        }
    }

    /// <summary>A stream failed while something was saved or loaded; its own exception is inside.</summary>
    public sealed class StreamException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public StreamException(string message, Exception innerException = null)
            : base(Status.Io, message, innerException)
        {
        }
    }

    /// <summary>The data is not a saved model or point set, or is cut short or damaged.</summary>
    public sealed class CorruptDataException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public CorruptDataException(string message)
            : base(Status.CorruptData, message)
        {
        }
    }

    /// <summary>The data was written by a newer library, or the library is not the one this assembly needs.</summary>
    public sealed class VersionMismatchException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public VersionMismatchException(string message)
            : base(Status.VersionMismatch, message)
        {
        }
    }

    /// <summary>A function of the program failed; what it threw is the InnerException.</summary>
    public sealed class CallbackException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public CallbackException(string message, Exception innerException = null)
            : base(Status.Callback, message, innerException)
        {
        }
    }

    /// <summary>A bug in the library: please report it.</summary>
    public sealed class InternalErrorException : HrbfNprException
    {
        /// <summary>Makes one.</summary>
        public InternalErrorException(Status status, string message)
            : base(status, message)
        {
        }
    }

    /// <summary>Turns statuses into exceptions.</summary>
    internal static unsafe class Errors
    {
        /// <summary>An error record to pass to a call.</summary>
        internal static hrbfnpr_error New()
        {
            hrbfnpr_error error;
            NativeMethods.hrbfnpr_error_init(&error, (uint)sizeof(hrbfnpr_error));
            return error;
        }

        internal static void Check(int status)
        {
            if (status != 0)
            {
                throw Make(status, string.Empty, default(CancellationToken));
            }
        }

        internal static void Check(int status, hrbfnpr_error* error)
        {
            if (status != 0)
            {
                throw Make(status, Utf8(error->message), default(CancellationToken));
            }
        }

        /// <summary>
        /// As above, for a call that calls functions of the program: what one of them threw comes out.  A state that
        /// several calls share is asked only if this call failed.
        /// </summary>
        internal static void Check(
            int status, hrbfnpr_error* error, CancellationToken token, CallbackState own, CallbackState shared = null)
        {
            Exception thrown = own == null ? null : own.TakeException();
            if (thrown == null && status != 0 && shared != null)
            {
                thrown = shared.TakeException();
            }
            if (thrown != null)
            {
                throw new CallbackException(
                    "a function of the program threw " + thrown.GetType().Name + ": " + thrown.Message, thrown);
            }
            if (status != 0)
            {
                throw Make(status, Utf8(error->message), token);
            }
        }

        private static Exception Make(int status, string message, CancellationToken token)
        {
            if (message.Length == 0)
            {
                message = Utf8(NativeMethods.hrbfnpr_status_name(status));
            }
            switch ((Status)status)
            {
                case Status.InvalidArgument: return new InvalidArgumentException(message);
                case Status.OutOfMemory: return new NativeOutOfMemoryException(message);
                case Status.BufferTooSmall: return new BufferTooSmallException(message);
                case Status.UnsupportedStruct: return new UnsupportedStructException(message);
                case Status.SingularSystem: return new SingularSystemException(message);
                case Status.NotConverged: return new NotConvergedException(message);
                case Status.Cancelled: return new CancelledException(message, token);
                case Status.Io: return new StreamException(message);
                case Status.CorruptData: return new CorruptDataException(message);
                case Status.VersionMismatch: return new VersionMismatchException(message);
                case Status.Callback: return new CallbackException(message);
                default: return new InternalErrorException((Status)status, message);
            }
        }

        /// <summary>A string of the library's; empty for NULL.</summary>
        internal static string Utf8(byte* text)
        {
            if (text == null)
            {
                return string.Empty;
            }
            int length = 0;
            while (text[length] != 0)
            {
                ++length;
            }
            return length == 0 ? string.Empty : Encoding.UTF8.GetString(text, length);
        }
    }
}
