// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>Receives messages of the library's log.</summary>
    public delegate void LogFunction(LogLevel level, string message);

    /// <summary>
    /// Runs the library's tasks on threads of the program.  It calls <paramref name="task"/> once for each number from
    /// 0 to <paramref name="count"/> - 1, on any threads and in any order, and returns when all calls have ended.
    /// </summary>
    public delegate void TaskRunner(Action<long> task, long count);

    /// <summary>How a <see cref="Context"/> works; a new one holds all defaults.</summary>
    public sealed class ContextOptions
    {
        /// <summary>
        /// Number of threads; 0 or more; default 0 = one for each processor; 1 = serial.  At most 256 are used, and
        /// results do not depend on their number.
        /// </summary>
        public int ThreadCount { get; set; }

        /// <summary>
        /// Which threads run the library's tasks; default Auto: <see cref="RunTasks"/> if it is given, else a pool.
        /// </summary>
        public ThreadBackend ThreadBackend { get; set; }

        /// <summary>
        /// The best instruction set that may be used; default Auto = the best that the build and the processor have.
        /// </summary>
        public InstructionSet HighestInstructionSet { get; set; }

        /// <summary>
        /// Receives messages of the log, on the thread that called the library; default null = no log.  Exceptions that
        /// it throws are ignored.
        /// </summary>
        public LogFunction Log { get; set; }

        /// <summary>Messages below this level are not reported; default Debug = all are reported.</summary>
        public LogLevel LogLevel { get; set; }

        /// <summary>
        /// Runs the library's tasks in place of its own threads, for instance by <c>Parallel.For</c>; default null.
        /// </summary>
        public TaskRunner RunTasks { get; set; }

        /// <summary>
        /// Address of a native function <c>void* allocate(void* user, uint64_t size, uint64_t alignment)</c>; default
        /// zero = the library's allocator.  Give both functions or neither.
        /// </summary>
        public IntPtr Allocate { get; set; }

        /// <summary>
        /// Address of a native function <c>void deallocate(void* user, void* memory, uint64_t size, uint64_t
        /// alignment)</c>; default zero.
        /// </summary>
        public IntPtr Deallocate { get; set; }

        /// <summary>The <c>user</c> argument of both allocator functions; default zero.</summary>
        public IntPtr AllocatorUser { get; set; }
    }

    /// <summary>The settings that a context uses, and its memory.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_context_info")]
    public struct ContextInfo
    {
        internal uint StructSize;

        /// <summary>Number of threads that a large call uses.</summary>
        public readonly int ThreadCount;

        private readonly uint instructionSet;
        private readonly uint threadBackend;

        /// <summary>Bytes that are allocated through this context now.</summary>
        public readonly long BytesNow;

        /// <summary>The largest number of bytes that were allocated at the same time.</summary>
        public readonly long BytesPeak;

        /// <summary>The thread backend in use; never <see cref="HrbfNpr.ThreadBackend.Auto"/>.</summary>
        public ThreadBackend ThreadBackend
        {
            get { return (ThreadBackend)threadBackend; }
        }

        /// <summary>The instruction set in use.</summary>
        public InstructionSet InstructionSet
        {
            get { return (InstructionSet)instructionSet; }
        }
    }

    /// <summary>
    /// Holds the allocator, the threads and the log of everything that is made with it.  Most programs need none: calls
    /// without a context use <see cref="Default"/>.
    /// </summary>
    /// <remarks>
    /// Several threads may use a context at the same time.  Objects that were made with a context keep working after
    /// <see cref="Dispose"/>.  Objects may be disposed of or finalised in any order.
    /// </remarks>
    public sealed unsafe class Context : IDisposable
    {
        private static readonly object DefaultLock = new object();
        private static readonly NativeCallbacks.Log LogCallback = OnLog;
        private static readonly NativeCallbacks.RunTasks RunTasksCallback = OnRunTasks;
        private static Context defaultContext;
        private readonly ContextHandle handle = new ContextHandle();

        /// <summary>Creates a context.</summary>
        /// <param name="options">The options; null = all defaults.</param>
        /// <exception cref="InvalidArgumentException">The thread count is negative; the backend contradicts
        /// <c>RunTasks</c> or is not in this build; or only one of the two allocator functions is given.</exception>
        /// <exception cref="VersionMismatchException">The library has another ABI version than this
        /// assembly.</exception>
        /// <exception cref="DllNotFoundException">The library was not found.</exception>
        public Context(ContextOptions options = null)
        {
            options = options ?? new ContextOptions();
            hrbfnpr_context_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_context_desc_init(&desc, (uint)sizeof(hrbfnpr_context_desc)));
            desc.abi_version = NativeMethods.AbiVersion; // the version of this assembly, not the library's
            desc.thread_count = options.ThreadCount;
            desc.thread_backend = (uint)options.ThreadBackend;
            desc.highest_instruction_set = (uint)options.HighestInstructionSet;
            desc.log_level = (int)options.LogLevel;
            desc.allocate = options.Allocate;
            desc.deallocate = options.Deallocate;
            desc.allocator_user = options.AllocatorUser;
            var anchor = new ContextAnchor(new ContextState(options.Log, options.RunTasks));
            anchor.AddReference(); // the reference of this constructor
            try
            {
                if (options.Log != null)
                {
                    desc.log = Marshal.GetFunctionPointerForDelegate(LogCallback);
                    desc.log_user = anchor.User;
                }
                if (options.RunTasks != null)
                {
                    desc.run_tasks = Marshal.GetFunctionPointerForDelegate(RunTasksCallback);
                    desc.run_tasks_user = anchor.User;
                }
                hrbfnpr_error error = Errors.New();
                int status = NativeMethods.hrbfnpr_context_create(&desc, out IntPtr created, &error);
                anchor.Context = created;
                handle.Take(created, anchor);
                Errors.Check(status, &error);
            }
            finally
            {
                anchor.Release();
            }
        }

        /// <summary>
        /// The context that calls use if they get none: one thread for each processor.  It is created when it is first
        /// used.
        /// </summary>
        public static Context Default
        {
            get
            {
                lock (DefaultLock)
                {
                    if (defaultContext == null || defaultContext.handle.IsClosed)
                    {
                        defaultContext = new Context();
                    }
                    return defaultContext;
                }
            }

            set
            {
                lock (DefaultLock)
                {
                    defaultContext = value;
                }
            }
        }

        /// <summary>The threads, backend and instruction set in use, and the memory now and at its peak.</summary>
        /// <exception cref="ObjectDisposedException">The context was disposed of.</exception>
        public ContextInfo Info
        {
            get
            {
                ContextInfo info;
                Errors.Check(NativeMethods.hrbfnpr_context_info_init(&info, (uint)sizeof(ContextInfo)));
                hrbfnpr_error error = Errors.New();
                Errors.Check(NativeMethods.hrbfnpr_context_get_info(handle, &info, &error), &error);
                return info;
            }
        }

        /// <summary>The first exception that the log or the task runner threw; null if they threw none.</summary>
        public Exception CallbackException
        {
            get { return handle.Anchor == null ? null : handle.Anchor.State.LastException; }
        }

        internal ContextHandle Handle
        {
            get { return handle; }
        }

        internal ContextAnchor Anchor
        {
            get { return handle.Anchor; }
        }

        /// <summary>Releases the context.  Objects that were made with it keep it alive.</summary>
        public void Dispose()
        {
            handle.Dispose();
        }

        internal static Context Resolve(Context context)
        {
            return context ?? Default;
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.Log))]
        private static void OnLog(IntPtr user, int level, byte* message)
        {
            var state = CallbackState.From<ContextState>(user);
            try
            {
                state.Log((LogLevel)level, Errors.Utf8(message));
            }
            catch (Exception exception)
            {
                state.Keep(exception);
            }
        }

        [MonoPInvokeCallback(typeof(NativeCallbacks.RunTasks))]
        private static void OnRunTasks(IntPtr user, IntPtr task, IntPtr taskContext, long count)
        {
            var state = CallbackState.From<ContextState>(user);
            var tasks = new Tasks(task, taskContext, count);
            try
            {
                state.RunTasks(tasks.Run, count);
            }
            catch (Exception exception)
            {
                state.Keep(exception);
            }
            tasks.Finish();
        }

        private sealed class ContextState : CallbackState
        {
            internal readonly LogFunction Log;
            internal readonly TaskRunner RunTasks;

            internal ContextState(LogFunction log, TaskRunner runTasks)
            {
                Log = log;
                RunTasks = runTasks;
            }
        }

        /// <summary>
        /// Runs each task that a task runner failed to run, and waits until all tasks have ended: the library cannot go
        /// on before.
        /// </summary>
        private sealed class Tasks
        {
            private readonly NativeCallbacks.Task task;
            private readonly IntPtr taskContext;
            private readonly int[] started;
            private long ended;

            internal Tasks(IntPtr task, IntPtr taskContext, long count)
            {
                this.task = Marshal.GetDelegateForFunctionPointer<NativeCallbacks.Task>(task);
                this.taskContext = taskContext;
                started = new int[count];
            }

            internal void Run(long index)
            {
                if (index < 0 || index >= started.LongLength)
                {
                    throw new ArgumentOutOfRangeException(nameof(index));
                }
                if (Interlocked.Exchange(ref started[index], 1) == 0)
                {
                    task(taskContext, index);
                    Interlocked.Increment(ref ended);
                }
            }

            internal void Finish()
            {
                for (long index = 0; index < started.LongLength; ++index)
                {
                    Run(index);
                }
                var wait = new SpinWait();
                while (Interlocked.Read(ref ended) < started.LongLength)
                {
                    wait.SpinOnce();
                }
            }
        }
    }
}
