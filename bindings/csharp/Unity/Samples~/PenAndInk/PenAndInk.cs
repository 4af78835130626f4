// SPDX-License-Identifier: MIT
using HrbfNpr;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;

/// <summary>Draws the mesh of this object in pen and ink, into the main texture of a material.</summary>
public sealed unsafe class PenAndInk : MonoBehaviour
{
    public Preset preset = Preset.ContourAndStipple;
    public int marks = 20000;
    public int size = 512;
    public Material target;

    private Model model;
    private PointSet pointSet;
    private HrbfNpr.Renderer penAndInk;
    private Texture2D texture;
    private Item item;
    private readonly RasterOptions upwards = new RasterOptions();

    private void Start()
    {
        Mesh mesh = GetComponent<MeshFilter>().sharedMesh;
        Vector3[] points = mesh.vertices, normals = mesh.normals;
        for (int i = 0; i < points.Length; ++i)
        {
            // Unity's coordinate systems are left-handed.
            points[i].z = -points[i].z;
            normals[i].z = -normals[i].z;
        }
        model = Model.Fit(
            ArrayView.Of(points, ScalarType.Float32, 3), ArrayView.Of(normals, ScalarType.Float32, 3),
            new FitOptions { MaximumCentres = 1000 });
        pointSet = model.Generate(GenerateOptions.ForPreset(preset, marks));
        item = new Item(pointSet, Style.Preset(preset));
        upwards.RowStride = -4 * size; // the rows of Unity's textures go upward
        penAndInk = new HrbfNpr.Renderer();
        texture = new Texture2D(size, size, TextureFormat.RGBA32, false);
        target.mainTexture = texture;
    }

    private void Update()
    {
        PointSetInfo info = pointSet.Info;
        float angle = Time.time;
        var camera = HrbfNpr.Camera.FitBounds(
            info.BoundsMin, info.BoundsMax, (Mathf.Sin(angle), -0.3, -Mathf.Cos(angle)), (0, 1, 0), size, size, 0.6);
        NativeArray<byte> pixels = texture.GetRawTextureData<byte>();
        byte* bottom = (byte*)NativeArrayUnsafeUtility.GetUnsafePtr(pixels);
        using (Drawing drawing = penAndInk.Draw(item, camera))
        {
            drawing.Rasterize(
                (System.IntPtr)(bottom + 4 * size * (size - 1)), size, size, PixelFormat.Rgba8, upwards);
        }
        texture.Apply(false);
    }

    private void OnDestroy()
    {
        penAndInk?.Dispose();
        pointSet?.Dispose();
        model?.Dispose();
    }
}
