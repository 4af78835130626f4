// SPDX-License-Identifier: MIT
// Draws the scene of examples/README.md: Scene SAMPLES PICTURE.
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

        var options = new PictureOptions { Direction = (0, 1, -1), Up = (0, 0, 1), Width = 640, Height = 480 };
        using (Picture picture = Picture.Draw(PictureSource.FromPoints(points, normals), options))
        {
            File.WriteAllBytes(arguments[1], picture.Rasterize());
        }
    }
}
