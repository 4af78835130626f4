// SPDX-License-Identifier: MIT
// The part of Unity that the sample of the Unity package uses, so that a compiler can check it without Unity.
using System;
using Unity.Collections;

namespace UnityEngine
{
    public struct Vector3
    {
        public float x, y, z;
    }

    public static class Mathf
    {
        public static float Sin(float angle)
        {
            return (float)Math.Sin(angle);
        }

        public static float Cos(float angle)
        {
            return (float)Math.Cos(angle);
        }
    }

    public static class Time
    {
        public static float time;
    }

    public class Mesh
    {
        public Vector3[] vertices = null;
        public Vector3[] normals = null;
    }

    public class MeshFilter
    {
        public Mesh sharedMesh = null;
    }

    public class Camera
    {
    }

    public class Renderer
    {
    }

    public class Material
    {
        public Texture2D mainTexture;
    }

    public enum TextureFormat
    {
        RGBA32,
    }

    public class Texture2D
    {
        public Texture2D(int width, int height, TextureFormat format, bool mipmaps)
        {
        }

        public NativeArray<T> GetRawTextureData<T>()
            where T : struct
        {
            return default(NativeArray<T>);
        }

        public void Apply(bool mipmaps)
        {
        }
    }

    public class MonoBehaviour
    {
        public T GetComponent<T>()
        {
            return default(T);
        }
    }
}

namespace Unity.Collections
{
    public struct NativeArray<T>
        where T : struct
    {
    }

    namespace LowLevel.Unsafe
    {
        public static unsafe class NativeArrayUnsafeUtility
        {
            public static void* GetUnsafePtr<T>(NativeArray<T> array)
                where T : struct
            {
                return null;
            }
        }
    }
}
