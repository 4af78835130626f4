// SPDX-License-Identifier: MIT
// 192 samples of a torus become a pen-and-ink drawing, torus.ppm.
using System;
using System.IO;
using System.Text;
using HrbfNpr;

public static class Quickstart
{
    public static void Main()
    {
        var points = new double[3 * 192];
        var normals = new double[3 * 192];
        for (int i = 0; i < 192; ++i)
        {
            double a = 2 * Math.PI * (i / 8) / 24, b = 2 * Math.PI * (i % 8) / 8;
            double[] normal = { Math.Cos(a) * Math.Cos(b), Math.Sin(a) * Math.Cos(b), Math.Sin(b) };
            double[] centre = { Math.Cos(a), Math.Sin(a), 0 };
            for (int k = 0; k < 3; ++k)
            {
                normals[3 * i + k] = normal[k];
                points[3 * i + k] = centre[k] + 0.4 * normal[k];
            }
        }

        // Samples become a smooth surface, on which the marks of a style are placed and drawn for a camera.
        using (Model model = Model.Fit(points, normals))
        using (PointSet marks = model.Generate(GenerateOptions.ForPreset(Preset.ContourAndStipple)))
        using (var renderer = new Renderer())
        {
            ModelInfo info = model.Info;
            Camera camera = Camera.FitBounds(
                info.BoundsMin, info.BoundsMax, (0, 1, -1), (0, 0, 1), 800, 600, 0.5, 0.02);
            var item = new Item(marks, Style.Preset(Preset.ContourAndStipple));
            using (Drawing drawing = renderer.Draw(item, camera))
            using (FileStream file = File.Create("torus.ppm"))
            {
                byte[] pixels = drawing.Rasterize();
                byte[] header = Encoding.ASCII.GetBytes("P6 800 600 255\n");
                file.Write(header, 0, header.Length);
                for (int i = 0; i < pixels.Length; i += 4)
                {
                    file.Write(pixels, i, 3);
                }
            }
        }
    }
}
