// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using System.Threading;
using System.Threading.Tasks;
using Xunit;

namespace HrbfNpr.Tests
{
    public class LifetimeTest
    {
        private static readonly LineSetOptions Coarse = new LineSetOptions
        {
            CellSize = 0.5, Lines = { LineOptions.Section((0, 0, 1), 0.0) },
        };

        private static readonly Style Contours = Style.Preset(Preset.Silhouette);

        [Fact]
        public void AThousandCyclesLeakNothing()
        {
            using (var context = new Context(new ContextOptions { ThreadCount = 1 }))
            {
                for (int i = 0; i < 100; ++i)
                {
                    Cycle(context);
                }
                long idle = context.Info.BytesNow; // includes memory that is kept for the next drawings
                long before = ResidentBytes();
                for (int i = 0; i < 1000; ++i)
                {
                    Cycle(context);
                }
                Assert.Equal(idle, context.Info.BytesNow);
                long growth = ResidentBytes() - before;
                Assert.True(growth < 16 << 20, "the process grew by " + growth + " bytes");
            }
        }

        [Fact]
        public void FinalisersRunInAnyOrder()
        {
            using (var context = new Context(new ContextOptions { ThreadCount = 1, Log = (level, message) => { } }))
            {
                long idle = context.Info.BytesNow;
                RunAndForget(() => LoseObjects(context));
                long lost = context.Info.BytesNow;
                Assert.True(lost > idle);
                Collect();
                // A conservative collector may still find some objects on a stack.
                Assert.True(context.Info.BytesNow - idle <= (lost - idle) / 10, "finalisers did not run");
            }
        }

        [Fact]
        public void ContextsMayBeLeftUndisposed()
        {
            int before = 0;
            RunAndForget(() =>
            {
                for (int i = 0; i < 50; ++i)
                {
                    var context = new Context(new ContextOptions
                    {
                        ThreadCount = 2,
                        Log = (level, message) => Interlocked.Increment(ref before),
                        RunTasks = (task, count) => InOrder(task, count),
                    });
                    Model model = Shapes.FitSphere(context);
                    if (i % 2 == 0)
                    {
                        context.Dispose(); // its objects still work
                    }
                    PointSet marks = i % 2 == 0 ? null : Shapes.Stipple(model, 50, context);
                    model.Evaluate(Shapes.Sphere6, progress: new Reports());
                    GC.KeepAlive(marks);
                }
            });
            Collect();
        }

        [Fact]
        public void ChildrenOutliveTheirParents()
        {
            var context = new Context();
            Model model = Shapes.FitSphere(context);
            PointSet marks = Shapes.Stipple(model, 100, context);
            var renderer = new Renderer(context);
            Drawing drawing = renderer.Draw(marks, Shapes.Look(marks, 20));
            long count = marks.Count;
            context.Dispose();
            model.Dispose();
            marks.Dispose();
            renderer.Dispose();
            Assert.Equal(1600, drawing.Rasterize().Length); // the drawing keeps its marks
            Assert.Equal(20, drawing.Width);
            Assert.Equal(count - 1, drawing.Identify((uint)count).Mark);
            drawing.Dispose();
        }

        [Fact]
        public void AModelReleasesItsFunction()
        {
            var functions = new List<WeakReference>();
            RunAndForget(() =>
            {
                for (int i = 0; i < 20; ++i)
                {
                    functions.Add(MakeAndDispose());
                }
            });
            Collect();
            Assert.True(functions.Count(function => function.IsAlive) <= 2);
        }

        [Fact]
        public void ThreadBackendsCanBeChosen()
        {
            using (var context = new Context(new ContextOptions { ThreadCount = 2 }))
            {
                Assert.Equal(ThreadBackend.Pool, context.Info.ThreadBackend);
            }
            using (var context = new Context(
                new ContextOptions { ThreadCount = 2, ThreadBackend = ThreadBackend.Serial }))
            {
                Assert.Equal(ThreadBackend.Serial, context.Info.ThreadBackend);
            }
            Assert.Throws<InvalidArgumentException>(
                () => new Context(new ContextOptions { ThreadBackend = ThreadBackend.RunTasks }));
        }

        [Fact]
        public void TheProgramsThreadsRunTheTasks()
        {
            long ran = 0;
            int failures = 0;
            var options = new ContextOptions
            {
                ThreadCount = 4,
                RunTasks = (task, count) =>
                {
                    Parallel.For(0L, count, index =>
                    {
                        Interlocked.Increment(ref ran);
                        task(index);
                    });
                    if (++failures % 2 == 0)
                    {
                        throw new InvalidOperationException("after the work");
                    }
                },
            };
            double[] points = Shapes.Sphere(300), at = Shapes.Sphere(5000);
            using (var context = new Context(options))
            using (var alone = new Context(new ContextOptions { ThreadCount = 1 }))
            using (Model first = Model.Fit((ArrayView)points, (ArrayView)points, null, context))
            using (Model second = Model.Fit((ArrayView)points, (ArrayView)points, null, alone))
            {
                Assert.Equal(second.Evaluate(at).Value, first.Evaluate(at).Value);
                Assert.True(ran > 0);
                Assert.IsType<InvalidOperationException>(context.CallbackException);
                Assert.Equal(4, context.Info.ThreadCount);
                Assert.Equal(1, alone.Info.ThreadCount);
            }
        }

        [Fact]
        public void ARunnerThatSkipsTasksGivesTheSameResults()
        {
            var options = new ContextOptions { ThreadCount = 4, RunTasks = (task, count) => task(count - 1) };
            using (var context = new Context(options))
            using (Model model = Shapes.FitSphere(context))
            using (Model other = Shapes.FitSphere())
            {
                double[] at = Shapes.Sphere(5000);
                Assert.Equal(other.Evaluate(at).Value, model.Evaluate(at).Value);
            }
        }

        [Fact]
        public void LogsMayThrow()
        {
            var lines = new List<string>();
            var options = new ContextOptions
            {
                Log = (level, message) =>
                {
                    lines.Add(level + " " + message);
                    throw new InvalidOperationException("no more");
                },
            };
            double[] points = Shapes.Sphere(300);
            using (var context = new Context(options))
            using (Model model = Model.Fit((ArrayView)points, (ArrayView)points, null, context))
            using (PointSet marks = model.Generate(null, context))
            {
                Assert.True(lines.Count > 0);
                Assert.True(lines.All(line => line.Length > 8));
                Assert.IsType<InvalidOperationException>(context.CallbackException);
            }
        }

        [Fact]
        public void TheDefaultContextCanBeReplaced()
        {
            Context old = Context.Default;
            try
            {
                using (var mine = new Context(new ContextOptions { ThreadCount = 1 }))
                {
                    Context.Default = mine;
                    Assert.Same(mine, Context.Default);
                    using (Shapes.FitSphere())
                    {
                        Assert.True(mine.Info.BytesNow > 0);
                    }
                }
                Assert.True(Context.Default.Info.ThreadCount > 0); // a disposed context is replaced
            }
            finally
            {
                Context.Default = old;
            }
        }

        private static void InOrder(Action<long> task, long count)
        {
            for (long i = 0; i < count; ++i)
            {
                task(i);
            }
        }

        private static void Cycle(Context context)
        {
            using (Model model = Shapes.FitSphere(context))
            using (PointSet marks = Shapes.Stipple(model, 20, context))
            using (LineSet lines = model.LineSet(Coarse, context))
            using (var occluders = new Occluders(new Item(marks) { LineSet = lines }, context))
            using (var shading = new Shading(occluders, marks, null, null, context))
            using (var renderer = new Renderer(context))
            using (NativeView view = marks.Layers[0].View(MarkAttribute.Position))
            using (Model function = Model.FromFunction((p, v, g, h) => { }, (0, 0, 0), (1, 1, 1), null, context))
            using (var other = new Context(new ContextOptions { ThreadCount = 1, Log = (level, message) => { } }))
            {
                Shapes.Draw(renderer, marks, Shapes.Look(marks, 8));
                var item = new Item(marks, Contours) { LineSet = lines, Shading = shading };
                Shapes.Draw(renderer, item, Shapes.Look(marks, 8));
                model.Evaluate(Shapes.Sphere6, progress: new Reports());
            }
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        private static void LoseObjects(Context context)
        {
            var kept = new List<object>();
            for (int i = 0; i < 30; ++i)
            {
                Model model = Shapes.FitSphere(context);
                PointSet marks = Shapes.Stipple(model, 100, context);
                var renderer = new Renderer(context);
                Drawing drawing = renderer.Draw(marks, Shapes.Look(marks, 8));
                NativeView view = marks.Layers[0].View(MarkAttribute.Rank);
                LineSet lines = model.LineSet(Coarse, context);
                var occluders = new Occluders(new Item(marks) { LineSet = lines }, context);
                var shading = new Shading(occluders, marks, null, null, context);
                object[] all = { model, marks, renderer, drawing, view, lines, occluders, shading };
                kept.AddRange(i % 2 == 0 ? all : all.Reverse());
            }
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        private static WeakReference MakeAndDispose()
        {
            var big = new double[1000];
            ImplicitFunction function = (points, value, gradient, hessian) => value[0] = big[0];
            using (Model.FromFunction(function, (0, 0, 0), (1, 1, 1)))
            {
                return new WeakReference(big);
            }
        }

        /// <summary>Runs an action on a new thread, whose stack the collector does not scan afterwards.</summary>
        private static void RunAndForget(Action action)
        {
            Exception thrown = null;
            var thread = new Thread(() =>
            {
                try
                {
                    action();
                }
                catch (Exception exception)
                {
                    thrown = exception;
                }
            });
            thread.Start();
            thread.Join();
            Assert.Null(thrown);
        }

        private static void Collect()
        {
            for (int i = 0; i < 4; ++i)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
        }

        private static long ResidentBytes()
        {
            Collect();
            return File.Exists("/proc/self/statm")
                ? 4096 * long.Parse(File.ReadAllText("/proc/self/statm").Split(' ')[1]) : 0;
        }
    }
}
