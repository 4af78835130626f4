// SPDX-License-Identifier: MIT
// The scene of examples/README.md: Scene SAMPLES PICTURE.
using System;
using System.Globalization;
using System.IO;
using HrbfNpr;

public static class Scene
{
    public static void Main(string[] arguments)
    {
        string[] lines = File.ReadAllLines(arguments[0]);
        var points = new double[3 * lines.Length];
        var normals = new double[3 * lines.Length];
        for (int i = 0; i < lines.Length; ++i)
        {
            double[] sample = Array.ConvertAll(lines[i].Split(' '), word => double.Parse(word, CultureInfo.InvariantCulture));
            Array.Copy(sample, 0, points, 3 * i, 3);
            Array.Copy(sample, 3, normals, 3 * i, 3);
        }

        using (Model model = Model.Fit(points, normals))
        using (PointSet marks = model.Generate(GenerateOptions.ForPreset(Preset.ContourAndStipple)))
        using (var renderer = new Renderer())
        {
            ModelInfo info = model.Info;
            Camera camera = Camera.FitBounds(
                info.BoundsMin, info.BoundsMax, (0, 1, -1), (0, 0, 1), 640, 480, 0.5, 0.02);
            var item = new Item(marks, Style.Preset(Preset.ContourAndStipple));
            using (Drawing drawing = renderer.Draw(item, camera))
            {
                File.WriteAllBytes(arguments[1], drawing.Rasterize());
            }
        }
    }
}
