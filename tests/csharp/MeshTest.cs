// SPDX-License-Identifier: MIT
using System;
using System.Linq;
using System.Threading;
using Xunit;

namespace HrbfNpr.Tests
{
    public unsafe class MeshTest
    {
        // A torus with radii 1 and 0.4, made of quadrilaterals cut into triangles.
        private static double[] Torus(int around, int along, out int[] triangles)
        {
            var vertices = new double[3 * around * along];
            triangles = new int[6 * around * along];
            for (int i = 0, at = 0; i < around; ++i)
            {
                for (int j = 0; j < along; ++j)
                {
                    double u = 2 * Math.PI * i / around, v = 2 * Math.PI * j / along, r = 1 + 0.4 * Math.Cos(v);
                    int k = (i + 1) % around, l = (j + 1) % along, a = i * along + j;
                    vertices[3 * a] = r * Math.Cos(u);
                    vertices[3 * a + 1] = r * Math.Sin(u);
                    vertices[3 * a + 2] = 0.4 * Math.Sin(v);
                    foreach (int corner in new[] { a, k * along + j, k * along + l, a, k * along + l, i * along + l })
                    {
                        triangles[at++] = corner;
                    }
                }
            }
            return vertices;
        }

        [Fact]
        public void SharpEdgesDivideTheFacesOfABox()
        {
            double[] corners = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1 };
            int[] triangles =
            {
                0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
            };
            using (var mesh = new TriangleMesh(corners, triangles))
            {
                MeshEdgesInfo info = mesh.FindEdges(out int[] sharp, out int[] patches);
                Assert.Equal(12, info.Edges);
                Assert.Equal(6, info.Patches);
                Assert.Equal(12.0, info.Length, 9);
                Assert.Equal(24, sharp.Sum());
                Assert.Equal(5, patches.Max());
                Assert.Equal(1, mesh.FindEdges(out sharp, out patches, MeshEdges.Smooth).Patches);
                Assert.Throws<InvalidArgumentException>(() => mesh.FindEdges(out _, out _, creaseAngle: 200));
            }
        }

        [Fact]
        public void AMeshReportsItsProperties()
        {
            double[] vertices = Torus(40, 20, out int[] triangles);
            using (var mesh = new TriangleMesh(vertices, triangles))
            {
                MeshInfo info = mesh.Info;
                Assert.True(info.Closed);
                Assert.Equal(800L, info.Vertices);
                Assert.Equal(1600L, info.Faces);
                Assert.Equal(1L, info.Genus);
                Assert.InRange(info.Volume, 2.9, 3.2);
                using (NativeView view = mesh.View(MeshAttribute.Triangle))
                {
                    Assert.Equal(1600L, view.Count);
                    Assert.Equal(ScalarType.Int32, view.Scalar);
                    Assert.Equal(triangles[4], ((int*)view.Data)[4]);
                }
            }
            long[] wide = Array.ConvertAll(triangles, corner => (long)corner);
            using (var mesh = new TriangleMesh(vertices, wide, new MeshOptions { Parts = MeshParts.Largest }))
            {
                Assert.Equal(1600L, mesh.Info.Faces);
            }
            wide[7] = 800;
            var thrown = Assert.Throws<InvalidArgumentException>(() => new TriangleMesh(vertices, wide));
            Assert.Contains("triangles[2] has the index 800", thrown.Message);
        }

        [Fact]
        public void AModelIsFittedToAMeshAndComparedWithIt()
        {
            double[] vertices = Torus(60, 30, out int[] triangles);
            using (var mesh = new TriangleMesh(vertices, triangles))
            using (Model model = Model.FitMesh(mesh, out MeshFitInfo info, new MeshFitOptions { Tolerance = 0.01 }))
            {
                Assert.True(info.Reached && !info.Supported);
                Assert.Equal(info.Centres, model.Info.Centres);
                Assert.Equal(0.01, info.Tolerance);
                MeshComparison compared = model.Compare(mesh, new CompareOptions { Tolerance = 0.01, Points = 2000 });
                Assert.Equal(2000L, compared.MeshPoints);
                Assert.InRange(compared.MeshShare, 0.98, 1.0);
                Assert.InRange(compared.SurfaceShare, 0.98, 1.0);
                Assert.Equal(1L, compared.Genus);
                Assert.Throws<InvalidArgumentException>(
                    () => Model.FitMesh(mesh, out _, new MeshFitOptions { Share = 2 }));
                Assert.Throws<CancelledException>(
                    () => Model.FitMesh(mesh, out _, null, null, null, new CancellationToken(true)));
            }
        }

        [Fact]
        public void EdgesStaySharp()
        {
            double[] vertices = { 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1 };
            int[] triangles =
            {
                0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3
            };
            using (var cube = new TriangleMesh(vertices, triangles))
            {
                using (Model model = Model.FitMesh(cube, out MeshFitInfo info))
                {
                    Assert.True(info.Reached);
                    Assert.Equal(6, info.Sheets);
                    Assert.Equal(12.0, info.CreaseLength, 1e-9);
                    Assert.Equal(0.0, info.SmoothLength);
                    Assert.True(info.Cells > 0 && info.PoorCells == 0);
                }
                var options = new MeshFitOptions { Edges = MeshEdges.Smooth, MaximumCentres = 200 };
                using (Model model = Model.FitMesh(cube, out MeshFitInfo info, options))
                {
                    Assert.Equal(1, info.Sheets);
                }
                Assert.Throws<InvalidArgumentException>(
                    () => Model.FitMesh(cube, out _, new MeshFitOptions { CreaseAngle = 1 }));
            }
        }

        [Fact]
        public void SamplesAndFarthestPointsAreEven()
        {
            double[] vertices = Torus(60, 30, out int[] triangles);
            using (var mesh = new TriangleMesh(vertices, triangles))
            {
                double[] points = mesh.Sample(100, out double[] normals, 3);
                Assert.Equal(300, points.Length);
                for (int i = 0; i < 100; ++i)
                {
                    double squared = Enumerable.Range(0, 3).Sum(c => normals[3 * i + c] * normals[3 * i + c]);
                    Assert.Equal(1.0, squared, 1e-9);
                }
                Assert.True(points.SequenceEqual(mesh.Sample(100, out _, 3)));
                Assert.False(points.SequenceEqual(mesh.Sample(100, out _, 4)));
            }
            long[] chosen = TriangleMesh.FarthestPoints(new double[] { 0, 0, 0, 1, 0, 0, 9, 0, 0, 5, 0, 0 }, 3);
            Assert.True(chosen.SequenceEqual(new long[] { 3, 0, 2 }));
        }
    }
}
