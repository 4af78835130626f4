// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace HrbfNpr
{
    /// <summary>Gets lines of the library's log.</summary>
    public delegate void LogFunction(LogLevel level, string message);

    /// <summary>
    /// Runs the library's work in place of its own threads: it must call <paramref name="task"/> once for each number
    /// from 0 to <paramref name="count"/> - 1, on any threads and in any order, and return when all have ended.
    /// </summary>
    public delegate void TaskRunner(Action<long> task, long count);

    /// <summary>How a <see cref="Context"/> is to be.</summary>
    public sealed class ContextOptions
    {
        /// <summary>0 = all processors (default), 1 = serial; at most 256 are used.  Results are the same bits.</summary>
        public int ThreadCount { get; set; }

        /// <summary>Who runs the library's tasks; by default <see cref="RunTasks"/>, or a pool without it.</summary>
        public ThreadBackend ThreadBackend { get; set; }

        /// <summary>The highest instruction set to use; the best by default.</summary>
        public InstructionSet HighestInstructionSet { get; set; }

        /// <summary>Called on the thread that made a call; what it throws is ignored.</summary>
        public LogFunction Log { get; set; }

        /// <summary>Lines of a lower level than this are not reported; all are by default.</summary>
        public LogLevel LogLevel { get; set; }

        /// <summary>Replaces the library's own threads, for instance by <c>Parallel.For</c>.</summary>
        public TaskRunner RunTasks { get; set; }

        /// <summary>
        /// Address of a native <c>void* allocate(void* user, uint64_t size, uint64_t alignment)</c>; zero for the
        /// library's own.  Both functions or none.
        /// </summary>
        public IntPtr Allocate { get; set; }

        /// <summary>Address of <c>void deallocate(void* user, void* memory, uint64_t size, uint64_t alignment)</c>.</summary>
        public IntPtr Deallocate { get; set; }

        /// <summary>First argument of the two.</summary>
        public IntPtr AllocatorUser { get; set; }
    }

    /// <summary>What a context really uses.</summary>
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_context_info")]
    public struct ContextInfo
    {
        internal uint StructSize;

        /// <summary>Threads that a large call will use.</summary>
        public readonly int ThreadCount;

        private readonly uint instructionSet;
        private readonly uint threadBackend;

        /// <summary>Bytes allocated through the context at present.</summary>
        public readonly long BytesNow;

        /// <summary>The most bytes there ever were.</summary>
        public readonly long BytesPeak;

        /// <summary>Who runs the tasks of a large call; never <see cref="HrbfNpr.ThreadBackend.Auto"/>.</summary>
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
    /// Allocator, threads and log of everything that is made with it.  Most programs need none: where a context can
    /// be given, the default is <see cref="Default"/>.
    /// </summary>
    /// <remarks>
    /// Any number of threads may use a context at a time.  What was made with it goes on working after
    /// <see cref="Dispose"/>, and objects may be disposed of, or finalised, in any order.
    /// </remarks>
    public sealed unsafe class Context : IDisposable
    {
        private static readonly object DefaultLock = new object();
        private static readonly NativeCallbacks.Log LogCallback = OnLog;
        private static readonly NativeCallbacks.RunTasks RunTasksCallback = OnRunTasks;
        private static Context defaultContext;
        private readonly ContextHandle handle = new ContextHandle();

        /// <summary>Makes a context.</summary>
        /// <param name="options">All defaults if null.</param>
        /// <exception cref="InvalidArgumentException">
        /// A negative thread count, a backend that contradicts the task runner or that the build lacks, or one
        /// allocator function of two.
        /// </exception>
        /// <exception cref="VersionMismatchException">The library has another ABI version than this assembly.</exception>
        /// <exception cref="DllNotFoundException">The library was not found.</exception>
        public Context(ContextOptions options = null)
        {
            options = options ?? new ContextOptions();
            hrbfnpr_context_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_context_desc_init(&desc, (uint)sizeof(hrbfnpr_context_desc)));
            desc.abi_version = NativeMethods.AbiVersion; // not the library's own
            desc.thread_count = options.ThreadCount;
            desc.thread_backend = (uint)options.ThreadBackend;
            desc.highest_instruction_set = (uint)options.HighestInstructionSet;
            desc.log_level = (int)options.LogLevel;
            desc.allocate = options.Allocate;
            desc.deallocate = options.Deallocate;
            desc.allocator_user = options.AllocatorUser;
            var anchor = new ContextAnchor(new ContextState(options.Log, options.RunTasks));
            anchor.AddReference(); // this constructor's
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

        /// <summary>The context of all calls that are given none: all processors, made on first use.</summary>
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

        /// <summary>Threads, backend and instruction set really used, memory now and at peak.</summary>
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

        /// <summary>The first exception that the log or the task runner threw, or null.</summary>
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

        /// <summary>Lets go of the context; what was made with it keeps it alive.</summary>
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
        /// The library cannot go on unless each task has run once and has ended: a runner that fails, or forgets one,
        /// is made good.
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
