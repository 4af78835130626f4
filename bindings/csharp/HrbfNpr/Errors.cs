// SPDX-License-Identifier: MIT
using System;
using System.Text;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>A call of the library failed.  Each status has its own subclass.</summary>
    public class HrbfNprException : Exception
    {
        /// <summary>Creates an exception.</summary>
        public HrbfNprException(Status status, string message, Exception innerException = null)
            : base(message, innerException)
        {
            Status = status;
        }

        /// <summary>
        /// The status that the library returned.  Treat a number that is not in the list like Internal.
        /// </summary>
        public Status Status { get; }
    }

    /// <summary>An argument is wrong.  The message names it and says what to do.</summary>
    public sealed class InvalidArgumentException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public InvalidArgumentException(string message)
            : base(Status.InvalidArgument, message)
        {
        }
    }

    /// <summary>The native allocator returned no memory.</summary>
    public sealed class NativeOutOfMemoryException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public NativeOutOfMemoryException(string message)
            : base(Status.OutOfMemory, message)
        {
        }
    }

    /// <summary>A destination is too small; nothing was written to it.</summary>
    public sealed class BufferTooSmallException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public BufferTooSmallException(string message)
            : base(Status.BufferTooSmall, message)
        {
        }
    }

    /// <summary>The library is older than this assembly and does not know a field that was set.</summary>
    public sealed class UnsupportedStructException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public UnsupportedStructException(string message)
            : base(Status.UnsupportedStruct, message)
        {
        }
    }

    /// <summary>The linear system of the fit has no numerically unique solution.</summary>
    public sealed class SingularSystemException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public SingularSystemException(string message)
            : base(Status.SingularSystem, message)
        {
        }
    }

    /// <summary>An iteration ended before it reached its goal.</summary>
    public sealed class NotConvergedException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public NotConvergedException(string message)
            : base(Status.NotConverged, message)
        {
        }
    }

    /// <summary>
    /// The call was cancelled through its token.  It is an <c>OperationCanceledException</c> and no
    /// <see cref="HrbfNprException"/>, so that a task that runs the call ends as cancelled and not as failed.
    /// </summary>
    public sealed class CancelledException : OperationCanceledException
    {
        /// <summary>Creates an exception.</summary>
        public CancelledException(string message, CancellationToken token)
            : base(message, token)
        {
        }

        /// <summary>Always <see cref="HrbfNpr.Status.Cancelled"/>.</summary>
        public Status Status
        {
            get { return Status.Cancelled; }
        }
    }

    /// <summary>
    /// A stream failed while something was saved or loaded.  The InnerException is what the stream threw.
    /// </summary>
    public sealed class StreamException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public StreamException(string message, Exception innerException = null)
            : base(Status.Io, message, innerException)
        {
        }
    }

    /// <summary>The data is not a saved model or point set, or is truncated or damaged.</summary>
    public sealed class CorruptDataException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public CorruptDataException(string message)
            : base(Status.CorruptData, message)
        {
        }
    }

    /// <summary>A newer library wrote the data, or the library has another ABI version than this assembly.</summary>
    public sealed class VersionMismatchException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public VersionMismatchException(string message)
            : base(Status.VersionMismatch, message)
        {
        }
    }

    /// <summary>
    /// A function of the program threw an exception, which is the InnerException, or gave invalid results.
    /// </summary>
    public sealed class CallbackException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public CallbackException(string message, Exception innerException = null)
            : base(Status.Callback, message, innerException)
        {
        }
    }

    /// <summary>A bug in the library: please report it.</summary>
    public sealed class InternalErrorException : HrbfNprException
    {
        /// <summary>Creates an exception.</summary>
        public InternalErrorException(Status status, string message)
            : base(status, message)
        {
        }
    }

    /// <summary>Turns statuses into exceptions.</summary>
    internal static unsafe class Errors
    {
        /// <summary>Sets up an error struct to pass to a call.</summary>
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
        /// Throws what a function of the program threw, or else the failure of the call.  <paramref name="own"/>
        /// belongs to this call; <paramref name="shared"/> belongs to several calls, and is asked only if this call
        /// failed.
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

        /// <summary>Copies a text of the library; empty for NULL.</summary>
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
