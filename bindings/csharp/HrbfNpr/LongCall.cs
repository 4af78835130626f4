// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>
    /// Progress and cancelling of one long call.  It has an operation of the library if either is used.
    /// </summary>
    internal sealed unsafe class LongCall : IDisposable
    {
        private static readonly NativeCallbacks.Progress ProgressCallback = OnProgress;
        private static readonly Action<object> CancelCallback = OnCancel;
        private readonly OperationHandle operation;
        private readonly CancellationToken token;
        private readonly ProgressState state;
        private UserHandle user;
        private CancellationTokenRegistration registration;

        /// <param name="owner">A handle of the context, which keeps the context alive while the call begins.</param>
        /// <param name="progress">Receives the progress; may be null.</param>
        /// <param name="token">Cancels the call; may be a token that is never cancelled.</param>
        /// <param name="always">Whether to make an operation even if neither progress nor cancelling is used.</param>
        internal LongCall(
            NativeHandle owner, IProgress<double> progress, CancellationToken token, bool always = false)
        {
            this.token = token;
            operation = OperationHandle.None;
            if (token.IsCancellationRequested)
            {
                throw new CancelledException("the call was cancelled before it began", token);
            }
            if (progress == null && !token.CanBeCanceled && !always)
            {
                return;
            }
            operation = Create(owner);
            try
            {
                if (progress != null || token.CanBeCanceled)
                {
                    state = new ProgressState(progress, token);
                    user = new UserHandle(state);
                    hrbfnpr_error error = Errors.New();
                    Errors.Check(
                        NativeMethods.hrbfnpr_operation_set_callback(
                            operation, Marshal.GetFunctionPointerForDelegate(ProgressCallback), user.Pointer, &error),
                        &error);
                }
                registration = token.Register(CancelCallback, operation);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        internal OperationHandle Operation
        {
            get { return operation; }
        }

        public void Dispose()
        {
            registration.Dispose(); // waits for a cancel that is running
            if (operation != OperationHandle.None)
            {
                operation.Dispose();
            }
            user.Dispose();
        }

        /// <summary>Throws if the call failed, or if a function that it called threw.</summary>
        internal void Check(int status, hrbfnpr_error* error, CallbackState shared = null)
        {
            Errors.Check(status, error, token, state, shared);
        }

        private static OperationHandle Create(NativeHandle owner)
        {
            var result = new OperationHandle();
            bool held = false;
            try
            {
                owner.DangerousAddRef(ref held);
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_operation_create(
                    owner.Anchor.Context, out IntPtr created, &error);
                result.Take(created, owner.Anchor);
                Errors.Check(status, &error);
            }
            finally
            {
                if (held)
                {
                    owner.DangerousRelease();
                }
            }
            return result;
        }

        private static void OnCancel(object operation)
        {
            NativeMethods.hrbfnpr_operation_cancel((OperationHandle)operation);
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Progress))]
        private static int OnProgress(IntPtr user, double progress)
        {
            var state = CallbackState.From<ProgressState>(user);
            try
            {
                if (state.Progress != null)
                {
                    state.Progress.Report(progress);
                }
                // The token may be cancelled before OnCancel has run: a token runs its callbacks one after another.
                return state.Token.IsCancellationRequested ? 1 : 0;
            }
            catch (Exception exception)
            {
                state.Keep(exception);
                return 1;
            }
        }

        private sealed class ProgressState : CallbackState
        {
            internal readonly IProgress<double> Progress;
            internal readonly CancellationToken Token;

            internal ProgressState(IProgress<double> progress, CancellationToken token)
            {
                Progress = progress;
                Token = token;
            }
        }
    }
}
