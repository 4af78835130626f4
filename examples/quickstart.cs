// SPDX-License-Identifier: MIT
// Draws 192 samples of a torus in pen and ink: as pixels for a PNG writer, and as torus.svg.
using System;
using System.IO;
using System.Linq;
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

        var options = new PictureOptions { Preset = Preset.Engraving, Width = 800, Height = 600 };
        using (Picture picture = Picture.Draw(PictureSource.FromPoints(points, normals), options))
        {
            byte[] rgba = picture.Rasterize();
            byte[] header = Encoding.ASCII.GetBytes("P6 800 600 255\n"); // PPM needs no library and has no alpha
            File.WriteAllBytes("torus.ppm", header.Concat(rgba.Where((value, i) => i % 4 < 3)).ToArray());
            picture.WriteSvg("torus.svg");
        }
    }
}
