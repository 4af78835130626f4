// SPDX-License-Identifier: MIT
using System;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Xunit;

namespace HrbfNpr.Tests
{
    public class CancelTest
    {
        private static readonly double[] Many = Shapes.Sphere(600); // their fit takes long enough to be cancelled
        private static readonly FitOptions Direct = new FitOptions { Solver = Solver.Direct };

        [Fact]
        public void ProgressNeverFalls()
        {
            var reports = new Reports();
            using (Model model = Model.Fit((ArrayView)Many, (ArrayView)Many, Direct, null, reports))
            {
                Assert.True(reports.Seen.Distinct().Count() > 3);
                Assert.Equal(reports.Seen.OrderBy(at => at).ToArray(), reports.Seen.ToArray());
                Assert.InRange(reports.Seen.Last(), reports.Seen[0], 1.0);
                var marking = new Reports();
                model.Generate(Shapes.Stipples(500), null, marking).Dispose();
                Assert.True(marking.Seen.Count > 0 && marking.Seen[0] >= 0);
            }
        }

        [Fact]
        public void ACancelledTokenStopsEveryCallBeforeItStarts()
        {
            using (Model model = Shapes.FitSphere())
            using (var source = new CancellationTokenSource())
            {
                source.Cancel();
                CancellationToken token = source.Token;
                Cancelled(() => Model.Fit((ArrayView)Many, (ArrayView)Many, cancellationToken: token));
                Cancelled(() => model.Evaluate(Many, cancellationToken: token));
                Cancelled(() => model.Project(Many, cancellationToken: token));
                Cancelled(() => model.Curvature(Many, cancellationToken: token));
                Cancelled(() => model.CastRays(Many, Many, cancellationToken: token));
                Cancelled(() => model.Contains(Many, cancellationToken: token));
                Cancelled(() => model.Lipschitz(cancellationToken: token));
                Cancelled(() => model.Generate(cancellationToken: token));
                Cancelled(() => model.StepPatches(3, cancellationToken: token));
                Cancelled(() => model.LineSet(cancellationToken: token));
                using (PointSet marks = model.Generate(Shapes.Stipples(50)))
                using (LineSet lines = model.LineSet())
                using (var occluders = new Occluders(new Item(marks) { LineSet = lines }))
                using (var renderer = new Renderer())
                {
                    Camera camera = Shapes.Look(marks, 32);
                    Cancelled(() => new Occluders(new Item(marks) { LineSet = lines }, cancellationToken: token));
                    Cancelled(() => new Shading(occluders, new Item(marks), cancellationToken: token));
                    Cancelled(() => renderer.Draw(new Item(marks), camera, cancellationToken: token));
                    Cancelled(() => renderer.Draw(new[] { new Item(marks) }, camera, null, token));
                    var reports = new Reports();
                    renderer.Draw(new Item(marks), camera, reports).Dispose(); // the renderer still works
                    Assert.Equal(1.0, reports.Seen.Last());
                }
            }
        }

        [Fact]
        public void AnotherThreadCancelsAFit()
        {
            using (var source = new CancellationTokenSource())
            using (var began = new ManualResetEventSlim())
            {
                var canceller = new Thread(() =>
                {
                    began.Wait();
                    source.Cancel();
                });
                canceller.Start();
                var reports = new Reports(at =>
                {
                    began.Set();
                    canceller.Join();
                });
                CancelledException thrown = Assert.Throws<CancelledException>(() => Model.Fit(
                    (ArrayView)Many, (ArrayView)Many, Direct, null, reports, source.Token));
                Assert.Equal(source.Token, thrown.CancellationToken);
                Assert.Equal(Status.Cancelled, thrown.Status);
                Assert.True(reports.Seen.Last() < 0.9);
            }
        }

        [Fact]
        public void ACallEndsEvenIfAnotherCallbackOfTheTokenStillRuns()
        {
            using (var source = new CancellationTokenSource())
            using (var running = new ManualResetEventSlim())
            using (var goOn = new ManualResetEventSlim())
            {
                var canceller = new Thread(source.Cancel);
                var reports = new Reports(at =>
                {
                    if (canceller.ThreadState == ThreadState.Unstarted)
                    {
                        source.Token.Register(() => // runs before the callback of the call, which was registered earlier
                        {
                            running.Set();
                            goOn.Wait();
                        });
                        canceller.Start();
                        running.Wait();
                    }
                });
                CancelledException thrown = Assert.Throws<CancelledException>(() => Model.Fit(
                    (ArrayView)Many, (ArrayView)Many, Direct, null, reports, source.Token));
                goOn.Set();
                canceller.Join();
                Assert.Equal(source.Token, thrown.CancellationToken);
                Assert.Single(reports.Seen);
            }
        }

        [Fact]
        public void ATimerCancelsAndTheTaskEndsAsCancelled()
        {
            using (var source = new CancellationTokenSource(30))
            using (var cancelled = new ManualResetEventSlim())
            {
                CancellationToken token = source.Token;
                token.Register(cancelled.Set);
                // The timer needs a thread of the pool. When all are busy, the pool adds a thread only after up to some
                // seconds. Without this wait the fit could end before that.
                var reports = new Reports(at => cancelled.Wait());
                Task<Model> task = Task.Run(
                    () => Model.Fit((ArrayView)Many, (ArrayView)Many, Direct, null, reports, token), token);
                Assert.Throws<AggregateException>(() => task.Wait());
                Assert.True(task.IsCanceled);
                Assert.True(reports.Seen.Count == 0 || reports.Seen.Last() < 0.9);
            }
        }

        [Fact]
        public void AReportThatThrowsCancels()
        {
            var own = new InvalidOperationException("enough");
            CallbackException thrown = Assert.Throws<CallbackException>(() => Model.Fit(
                (ArrayView)Many, (ArrayView)Many, Direct, null, new Reports(at => { throw own; })));
            Assert.Same(own, thrown.InnerException);
        }

        private static void Cancelled(Action call)
        {
            Assert.Equal(Status.Cancelled, Assert.Throws<CancelledException>(call).Status);
        }
    }
}
