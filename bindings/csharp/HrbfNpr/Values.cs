// SPDX-License-Identifier: MIT
using System;
using System.Globalization;

namespace HrbfNpr
{
    /// <summary>Three numbers: a point or a direction.</summary>
    /// <example><c>Vector3d up = (0, 0, 1);</c></example>
    public readonly struct Vector3d : IEquatable<Vector3d>
    {
        /// <summary>First component.</summary>
        public readonly double X;

        /// <summary>Second component.</summary>
        public readonly double Y;

        /// <summary>Third component.</summary>
        public readonly double Z;

        /// <summary>Creates a vector of three components.</summary>
        public Vector3d(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        /// <summary>Makes a vector of three numbers in parentheses.</summary>
        public static implicit operator Vector3d((double x, double y, double z) value)
        {
            return new Vector3d(value.x, value.y, value.z);
        }

        /// <summary>Whether all components are equal.</summary>
        public static bool operator ==(Vector3d a, Vector3d b)
        {
            return a.Equals(b);
        }

        /// <summary>Whether any component differs.</summary>
        public static bool operator !=(Vector3d a, Vector3d b)
        {
            return !a.Equals(b);
        }

        /// <summary>Whether all components are equal.</summary>
        public bool Equals(Vector3d other)
        {
            return X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);
        }

        /// <inheritdoc/>
        public override bool Equals(object obj)
        {
            return obj is Vector3d other && Equals(other);
        }

        /// <inheritdoc/>
        public override int GetHashCode()
        {
            return (X.GetHashCode() * 31 + Y.GetHashCode()) * 31 + Z.GetHashCode();
        }

        /// <summary>Returns "(x, y, z)", the same in every culture.</summary>
        public override string ToString()
        {
            return string.Format(CultureInfo.InvariantCulture, "({0}, {1}, {2})", X, Y, Z);
        }
    }

    /// <summary>A colour: straight RGBA from 0 to 1, sRGB-encoded.</summary>
    public readonly struct Color : IEquatable<Color>
    {
        /// <summary>Red.</summary>
        public readonly float R;

        /// <summary>Green.</summary>
        public readonly float G;

        /// <summary>Blue.</summary>
        public readonly float B;

        /// <summary>Opacity; 0 = transparent.</summary>
        public readonly float A;

        /// <summary>Creates a colour from its channels; opaque by default.</summary>
        public Color(float r, float g, float b, float a = 1)
        {
            R = r;
            G = g;
            B = b;
            A = a;
        }

        /// <summary>Reads a colour from "#rrggbb" or "#rrggbbaa".</summary>
        /// <exception cref="FormatException">The text has neither form.</exception>
        public static Color Parse(string text)
        {
            if (text == null)
            {
                throw new ArgumentNullException(nameof(text));
            }
            bool sized = text.Length == 7 || text.Length == 9;
            if (!sized || text[0] != '#' || !uint.TryParse(text.Substring(1), NumberStyles.AllowHexSpecifier,
                CultureInfo.InvariantCulture, out uint number))
            {
                throw new FormatException("\"" + text + "\" is not a colour; write #rrggbb or #rrggbbaa");
            }
            if (text.Length == 7)
            {
                number = (number << 8) | 0xff;
            }
            return new Color(
                (number >> 24) / 255f, ((number >> 16) & 0xff) / 255f, ((number >> 8) & 0xff) / 255f,
                (number & 0xff) / 255f);
        }

        /// <summary>Whether all channels are equal.</summary>
        public static bool operator ==(Color a, Color b)
        {
            return a.Equals(b);
        }

        /// <summary>Whether any channel differs.</summary>
        public static bool operator !=(Color a, Color b)
        {
            return !a.Equals(b);
        }

        /// <summary>Whether all channels are equal.</summary>
        public bool Equals(Color other)
        {
            return R.Equals(other.R) && G.Equals(other.G) && B.Equals(other.B) && A.Equals(other.A);
        }

        /// <inheritdoc/>
        public override bool Equals(object obj)
        {
            return obj is Color other && Equals(other);
        }

        /// <inheritdoc/>
        public override int GetHashCode()
        {
            return ((R.GetHashCode() * 31 + G.GetHashCode()) * 31 + B.GetHashCode()) * 31 + A.GetHashCode();
        }

        /// <summary>Returns "(r, g, b, a)", the same in every culture.</summary>
        public override string ToString()
        {
            return string.Format(CultureInfo.InvariantCulture, "({0}, {1}, {2}, {3})", R, G, B, A);
        }

        internal static unsafe Color Read(float* channels)
        {
            return new Color(channels[0], channels[1], channels[2], channels[3]);
        }

        internal unsafe void Write(float* channels)
        {
            channels[0] = R;
            channels[1] = G;
            channels[2] = B;
            channels[3] = A;
        }
    }
}
