// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;

namespace HrbfNpr.Tests
{
    /// <summary>Shapes that several tests use.</summary>
    internal static class Shapes
    {
        internal static readonly double[] Sphere6 =
        {
            1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1,
        };

        /// <summary>Even points on the unit sphere, which are their own normals.</summary>
        internal static double[] Sphere(int count)
        {
            var result = new double[3 * count];
            for (int i = 0; i < count; ++i)
            {
                double z = 1 - (2 * i + 1.0) / count;
                double angle = i * Math.PI * (3 - Math.Sqrt(5));
                double radius = Math.Sqrt(1 - z * z);
                result[3 * i] = radius * Math.Cos(angle);
                result[3 * i + 1] = radius * Math.Sin(angle);
                result[3 * i + 2] = z;
            }
            return result;
        }

        /// <summary>The cube of side 1 with its corner at the origin: 8 vertices, 12 faces.</summary>
        internal static void Cube(out double[] vertices, out int[] triangles)
        {
            vertices = new double[24];
            for (int i = 0; i < 24; ++i)
            {
                vertices[i] = (i / 3 >> i % 3) & 1;
            }
            triangles = new[]
            {
                0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
            };
        }

        internal static float[] ToFloats(double[] numbers)
        {
            return Array.ConvertAll(numbers, number => (float)number);
        }

        internal static Model FitSphere(Context context = null)
        {
            return Model.Fit((ArrayView)Sphere6, (ArrayView)Sphere6, null, context);
        }

        internal static GenerateOptions Stipples(long budget)
        {
            return new GenerateOptions { Layers = { Layer.Stipples(budget) } };
        }

        internal static PointSet Stipple(Model model, long budget, Context context = null)
        {
            return model.Generate(Stipples(budget), context);
        }

        internal static Camera Look(PointSet marks, int size)
        {
            PointSetInfo info = marks.Info;
            return Camera.FitBounds(info.BoundsMin, info.BoundsMax, (0, -0.3, -1), (0, 1, 0), size, size, 0.6);
        }

        internal static byte[] Draw(Renderer renderer, Item item, Camera camera)
        {
            using (Drawing drawing = renderer.Draw(item, camera))
            {
                return drawing.Rasterize();
            }
        }

        internal static DrawingInfo Count(Renderer renderer, Camera camera, params Item[] items)
        {
            using (Drawing drawing = renderer.Draw(items, camera))
            {
                return drawing.Info;
            }
        }

        internal static double Length(IList<double> numbers, int index)
        {
            double x = numbers[3 * index], y = numbers[3 * index + 1], z = numbers[3 * index + 2];
            return Math.Sqrt(x * x + y * y + z * z);
        }
    }

    /// <summary>Records progress reports, and calls a function for each.</summary>
    internal sealed class Reports : IProgress<double>
    {
        internal readonly List<double> Seen = new List<double>();
        private readonly Action<double> also;

        internal Reports(Action<double> also = null)
        {
            this.also = also;
        }

        public void Report(double value)
        {
            Seen.Add(value);
            if (also != null)
            {
                also(value);
            }
        }
    }

    internal struct Vector3f
    {
        internal float X;
        internal float Y;
        internal float Z;
        internal float Unused;
    }
}
