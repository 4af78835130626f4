// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Xunit;

namespace HrbfNpr.Tests
{
    public unsafe class ErrorTest
    {
        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate IntPtr Allocate(IntPtr user, ulong size, ulong alignment);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void Deallocate(IntPtr user, IntPtr memory, ulong size, ulong alignment);

        [Fact]
        public void EveryStatusHasItsException()
        {
            Assert.IsType<InvalidArgumentException>(Thrown(-1));
            Assert.IsType<NativeOutOfMemoryException>(Thrown(-2));
            Assert.IsType<BufferTooSmallException>(Thrown(-3));
            Assert.IsType<UnsupportedStructException>(Thrown(-4));
            Assert.IsType<SingularSystemException>(Thrown(-5));
            Assert.IsType<NotConvergedException>(Thrown(-6));
            Assert.IsType<CancelledException>(Thrown(-7));
            Assert.IsType<StreamException>(Thrown(-8));
            Assert.IsType<CorruptDataException>(Thrown(-9));
            Assert.IsType<VersionMismatchException>(Thrown(-10));
            Assert.IsType<CallbackException>(Thrown(-11));
            Assert.IsType<InternalErrorException>(Thrown(-99));
            InternalErrorException unknown = Assert.IsType<InternalErrorException>(Thrown(-12345));
            Assert.Equal(-12345, (int)unknown.Status);
            Assert.Equal("SINGULAR_SYSTEM", Thrown(-5).Message);
            for (int status = -11; status < 0; ++status)
            {
                var ours = Thrown(status) as HrbfNprException;
                Assert.Equal(status, ours == null ? -7 : (int)ours.Status);
            }
        }

        [Fact]
        public void MessagesSayWhatIsWrong()
        {
            double[] points = Shapes.Sphere(10);
            points[7] = double.NaN;
            InvalidArgumentException wrong = Assert.Throws<InvalidArgumentException>(
                () => Model.Fit((ArrayView)points, (ArrayView)Shapes.Sphere(10)));
            Assert.Contains("points", wrong.Message);
            Assert.Contains("2", wrong.Message);
            Assert.Throws<InvalidArgumentException>(() => Model.Fit(default(ArrayView), default(ArrayView)));
            Assert.Throws<InvalidArgumentException>(() => Model.Fit((ArrayView)new double[4], (ArrayView)new double[3]));
            Assert.Throws<InvalidArgumentException>(
                () => Model.Fit((ArrayView)Shapes.Sphere(10), (ArrayView)Shapes.Sphere(9)));
            Assert.Throws<InvalidArgumentException>(() => new Context(new ContextOptions { ThreadCount = -1 }));
            Assert.Throws<ArgumentNullException>(() => PointSet.Create((OwnLayer[])null));
            Assert.Throws<ArgumentNullException>(() => PointSet.Create(new OwnLayer[] { null }));
            Assert.Throws<ArgumentNullException>(() => Model.Load((byte[])null));
            Assert.Throws<ArgumentNullException>(() => Model.Load((Stream)null));
            Assert.Throws<ArgumentNullException>(() => Model.FromFunction(null, (0, 0, 0), (1, 1, 1)));
        }

        [Fact]
        public void ALibraryOfAnotherAbiIsRefused()
        {
            hrbfnpr_context_desc desc;
            Errors.Check(NativeMethods.hrbfnpr_context_desc_init(&desc, (uint)sizeof(hrbfnpr_context_desc)));
            desc.abi_version = NativeMethods.AbiVersion + 1;
            hrbfnpr_error error = Errors.New();
            int status = NativeMethods.hrbfnpr_context_create(&desc, out IntPtr created, &error);
            Assert.Equal((int)Status.VersionMismatch, status);
            Assert.Equal(IntPtr.Zero, created);
        }

        [Fact]
        public void MessagesAreUtf8()
        {
            hrbfnpr_error error = Errors.New();
            byte[] letters = { 0x70, 0x68, 0xc3, 0xa9, 0xe2, 0x82, 0xac, 0 };
            for (int i = 0; i < letters.Length; ++i)
            {
                error.message[i] = letters[i];
            }
            try
            {
                Errors.Check(-1, &error);
            }
            catch (InvalidArgumentException exception)
            {
                Assert.Equal("ph\u00e9\u20ac", exception.Message);
                return;
            }
            Assert.True(false, "nothing was thrown");
        }

        [Fact]
        public void DamagedDataIsRefused()
        {
            byte[] data;
            using (Model model = Shapes.FitSphere())
            {
                data = model.ToBytes();
                Assert.Throws<CorruptDataException>(() => PointSet.Load(data)); // a model is not a point set
            }
            byte[] damaged = (byte[])data.Clone();
            damaged[data.Length / 2] ^= 1;
            Assert.Throws<CorruptDataException>(() => Model.Load(damaged));
            Assert.Throws<CorruptDataException>(() => Model.Load(new byte[0]));
            Assert.Throws<CorruptDataException>(() => Model.Load(new MemoryStream(data, 0, data.Length - 1)));
            byte[] newer = (byte[])data.Clone();
            newer[12] = 200; // format version
            BitConverter.GetBytes(Crc32(newer, 36)).CopyTo(newer, 36);
            VersionMismatchException mismatch = Assert.Throws<VersionMismatchException>(() => Model.Load(newer));
            Assert.Equal(Status.VersionMismatch, mismatch.Status);
        }

        [Fact]
        public void StreamErrorsAreReported()
        {
            using (Model model = Shapes.FitSphere())
            {
                StreamException failed = Assert.Throws<StreamException>(() => model.Save(new Broken()));
                Assert.IsType<NotImplementedException>(failed.InnerException);
                Assert.Equal(Status.Io, failed.Status);
                failed = Assert.Throws<StreamException>(() => PointSet.Load(new Broken()));
                Assert.IsType<NotImplementedException>(failed.InnerException);
            }
            using (Model model = Model.FromFunction(One, (0, 0, 0), (1, 1, 1)))
            {
                Assert.Throws<InvalidArgumentException>(() => model.Save(new MemoryStream()));
                Assert.Throws<InvalidArgumentException>(() => model.ToBytes());
            }
        }

        [Fact]
        public void ExceptionsInFunctionsAreTheInnerException()
        {
            var own = new InvalidOperationException("my own");
            ImplicitFunction function = (points, value, gradient, hessian) => { throw own; };
            using (Model model = Model.FromFunction(function, (0, 0, 0), (1, 1, 1)))
            {
                CallbackException thrown =
                    Assert.Throws<CallbackException>(() => model.Evaluate(new double[] { 0, 0, 0 }));
                Assert.Same(own, thrown.InnerException);
                Assert.Equal(Status.Callback, thrown.Status);
                Assert.Contains("my own", thrown.Message);
                Assert.Same(own, Assert.Throws<CallbackException>(
                    () => model.Generate(Shapes.Stipples(10))).InnerException);
            }
            using (Model model = Shapes.FitSphere())
            {
                Layer layer = Layer.Stipples(50);
                var options = new GenerateOptions { Layers = { layer } };
                layer.Density = Density.Callback;
                layer.DensityFunction = (positions, normals, density) => { throw own; };
                Assert.Same(own, Assert.Throws<CallbackException>(
                    () => model.Generate(options)).InnerException);
                layer.DensityFunction = (positions, normals, density) => density[0] = double.NaN;
                Assert.Null(Assert.Throws<CallbackException>(() => model.Generate(options)).InnerException);
                Layer field = Layer.Hatch(budget: 50);
                field.DirectionFunction = (positions, normals, directions) => { throw own; };
                CallbackException wrong = Assert.Throws<CallbackException>(
                    () => model.Generate(new GenerateOptions { Layers = { field } }));
                Assert.Same(own, wrong.InnerException);
                Assert.Contains("direction", wrong.Message);
                using (PointSet marks = Shapes.Stipple(model, 50))
                using (var renderer = new Renderer())
                {
                    var style = new Style { Tone = Tone.Callback };
                    style.ToneFunction = (positions, normals, tau) => { throw own; };
                    Assert.Same(own, Assert.Throws<CallbackException>(
                        () => renderer.Draw(new Item(marks, style), Shapes.Look(marks, 20))).InnerException);
                    Camera camera = Shapes.Look(marks, 20);
                    style.ToneFunction = (positions, normals, tau) => renderer.Draw(marks, camera);
                    Assert.IsType<InvalidOperationException>(Assert.Throws<CallbackException>(
                        () => renderer.Draw(new Item(marks, style), camera)).InnerException);
                }
                Assert.Same(own, Assert.Throws<CallbackException>(
                    () => model.Lipschitz(new Reports(at => { throw own; }))).InnerException);
            }
            Assert.Same(own, Assert.Throws<CallbackException>(() => Model.Fit(
                (ArrayView)Shapes.Sphere6, (ArrayView)Shapes.Sphere6, null, null,
                new Reports(at => { throw own; }))).InnerException);
        }

        [Fact]
        public void AFailingAllocatorGivesOutOfMemory()
        {
            long left = long.MaxValue;
            Allocate allocate = (user, size, alignment) =>
            {
                return Interlocked.Add(ref left, -(long)size) < 0 ? IntPtr.Zero : AlignedAlloc(alignment, size);
            };
            Deallocate deallocate = (user, memory, size, alignment) => Free(memory);
            var options = new ContextOptions
            {
                ThreadCount = 1,
                Allocate = Marshal.GetFunctionPointerForDelegate(allocate),
                Deallocate = Marshal.GetFunctionPointerForDelegate(deallocate),
            };
            using (var context = new Context(options))
            {
                using (Shapes.FitSphere(context))
                {
                    Assert.True(context.Info.BytesNow > 0);
                }
                Interlocked.Exchange(ref left, 3000);
                NativeOutOfMemoryException thrown =
                    Assert.Throws<NativeOutOfMemoryException>(() => Shapes.FitSphere(context));
                Assert.Equal(Status.OutOfMemory, thrown.Status);
            }
            GC.KeepAlive(allocate);
            GC.KeepAlive(deallocate);
            Assert.Throws<InvalidArgumentException>(
                () => new Context(new ContextOptions { Allocate = options.Allocate }));
        }

        [Fact]
        public void DisposedObjectsThrow()
        {
            Model model = Shapes.FitSphere();
            PointSet marks = Shapes.Stipple(model, 20);
            MarkLayer layer = marks.Layers[0];
            var renderer = new Renderer();
            Drawing drawing = renderer.Draw(marks, Shapes.Look(marks, 20));
            var context = new Context();
            model.Dispose();
            model.Dispose();
            marks.Dispose();
            renderer.Dispose();
            drawing.Dispose();
            drawing.Dispose();
            context.Dispose();
            Assert.Throws<ObjectDisposedException>(() => model.Info);
            Assert.Throws<ObjectDisposedException>(() => model.Evaluate(new double[3]));
            Assert.Throws<ObjectDisposedException>(() => model.Evaluate(new double[3], progress: new Reports()));
            Assert.Throws<ObjectDisposedException>(() => marks.Info);
            Assert.Throws<ObjectDisposedException>(() => layer.View(MarkAttribute.Normal));
            Assert.Throws<ObjectDisposedException>(() => layer.Info);
            Assert.Throws<ObjectDisposedException>(() => renderer.Draw(new Item[0], new Camera()));
            Assert.Throws<ObjectDisposedException>(() => drawing.Info);
            Assert.Throws<ObjectDisposedException>(() => drawing.Rasterize());
            Assert.Throws<ObjectDisposedException>(() => context.Info);
            Assert.Throws<ObjectDisposedException>(() => new Renderer(context));
            using (var other = new Renderer())
            {
                Assert.Throws<ObjectDisposedException>(() => other.Draw(marks, new Camera()));
            }
        }

        private static void One(double[] points, double[] value, double[] gradient, double[] hessian)
        {
            for (int i = 0; i < value.Length; ++i)
            {
                value[i] = 1;
            }
        }

        private static Exception Thrown(int status)
        {
            try
            {
                Errors.Check(status);
            }
            catch (Exception exception)
            {
                return exception;
            }
            return null;
        }

        private static uint Crc32(byte[] data, int count)
        {
            uint crc = 0xffffffff;
            for (int i = 0; i < count; ++i)
            {
                crc ^= data[i];
                for (int bit = 0; bit < 8; ++bit)
                {
                    crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320 : 0);
                }
            }
            return ~crc;
        }

        [DllImport("libc.so.6", EntryPoint = "aligned_alloc")]
        private static extern IntPtr AlignedAllocate(UIntPtr alignment, UIntPtr size);

        [DllImport("libc.so.6", EntryPoint = "free")]
        private static extern void Free(IntPtr memory);

        private static IntPtr AlignedAlloc(ulong alignment, ulong size)
        {
            return AlignedAllocate((UIntPtr)alignment, (UIntPtr)((size + alignment - 1) / alignment * alignment));
        }

        private sealed class Broken : MemoryStream
        {
            public override void Write(byte[] buffer, int offset, int count)
            {
                throw new NotImplementedException();
            }

            public override int Read(byte[] buffer, int offset, int count)
            {
                throw new NotImplementedException();
            }
        }
    }
}
