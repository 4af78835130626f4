// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>
    /// A light of a style.  It adds intensity * max(0, n . l)^exponent to the light of a mark, where l is the unit
    /// vector to the light, and the exponent is <see cref="Style.ToneExponent"/>.
    /// </summary>
    /// <remarks><c>Renderer.Draw</c> refuses numbers out of range.</remarks>
    public sealed unsafe class Light
    {
        /// <summary>Creates a light with all defaults.</summary>
        /// <param name="kind">Where the light comes from.</param>
        public Light(LightKind kind = LightKind.Directional)
        {
            hrbfnpr_light native;
            Errors.Check(NativeMethods.hrbfnpr_light_init(&native, (uint)sizeof(hrbfnpr_light)));
            Read(&native);
            Kind = kind;
        }

        internal Light(hrbfnpr_light* native)
        {
            Read(native);
        }

        /// <summary>Where the light comes from; default Directional.</summary>
        public LightKind Kind { get; set; }

        /// <summary>Space of <see cref="Place"/>; default Camera.</summary>
        public LightSpace Space { get; set; }

        /// <summary>
        /// Strength of the light; 0 to 16; default 1 = a surface that faces the light is white.
        /// </summary>
        public float Intensity { get; set; }

        /// <summary>
        /// Share of its light that its cast shadows take away; 0 to 1; default 0 = it casts none.
        /// </summary>
        /// <remarks>It has an effect on items with an <see cref="Item.Shading"/>.</remarks>
        public float Shadow { get; set; }

        /// <summary>
        /// Radius of the light as it is seen from the surface, in radians; 0 to 0.5; default 0 = shadows with sharp
        /// borders.  The sun has 0.0047.
        /// </summary>
        public float Softness { get; set; }

        /// <summary>
        /// Directional: the direction to the light, of any length but 0.  Place: the place of the light.  Default
        /// (-0.4, 0.6, 0.7).
        /// </summary>
        public Vector3d Place { get; set; }

        /// <summary>Copies the light.</summary>
        public Light Clone()
        {
            return (Light)MemberwiseClone();
        }

        internal void Write(hrbfnpr_light* native)
        {
            Errors.Check(NativeMethods.hrbfnpr_light_init(native, (uint)sizeof(hrbfnpr_light)));
            native->kind = (uint)Kind;
            native->space = (uint)Space;
            native->intensity = Intensity;
            native->shadow = Shadow;
            native->softness = Softness;
            *(Vector3d*)native->place = Place;
        }

        private void Read(hrbfnpr_light* native)
        {
            Kind = (LightKind)native->kind;
            Space = (LightSpace)native->space;
            Intensity = native->intensity;
            Shadow = native->shadow;
            Softness = native->softness;
            Place = *(Vector3d*)native->place;
        }
    }
}
