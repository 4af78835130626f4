// SPDX-License-Identifier: MIT
namespace HrbfNpr
{
    /// <summary>How a <see cref="Shading"/> is computed.</summary>
    public sealed class ShadingOptions
    {
        /// <summary>
        /// Number of rays by which a mark sees the sky; 1 to 4096; default 64.  Larger: less noise.
        /// </summary>
        public int SkyRays { get; set; } = 64;

        /// <summary>
        /// Number of rays by which a mark in a penumbra sees a light; 1 to 4096; default 32.  Larger: less noise.
        /// </summary>
        public int ShadowRays { get; set; } = 32;

        /// <summary>
        /// Distance beyond which nothing hides the sky, in diagonals of the box around all occluders; 0 to 100; default
        /// 0.35; 0 = the whole sky is seen everywhere.
        /// </summary>
        /// <remarks>The nearer a surface is, the more it hides: 1 - distance / reach.</remarks>
        public double OcclusionReach { get; set; } = 0.35;

        /// <summary>
        /// A shading of the same item and the same occluders, but for other lights, whose occlusion is taken; default
        /// null = occlusion is computed.
        /// </summary>
        /// <remarks><see cref="SkyRays"/> and <see cref="OcclusionReach"/> then have no effect.</remarks>
        public Shading Previous { get; set; }

        /// <summary>
        /// Distance over which curvature is measured, in diagonals of the box around the item's surface; 0 to 1; default
        /// 0.02; 0 = it is not measured.
        /// </summary>
        /// <remarks>It is measured if the item's style has a <see cref="Style.CurvatureContrast"/>.</remarks>
        public double CurvatureScale { get; set; } = 0.02;

        /// <summary>
        /// Whether lines of the kinds <see cref="LineKind.Shadow"/> and <see cref="LineKind.Terminator"/> are found, for
        /// items with a line set; default false.
        /// </summary>
        public bool WithLines { get; set; }

        internal unsafe void Write(hrbfnpr_shading_desc* desc, HeldHandles held)
        {
            Errors.Check(NativeMethods.hrbfnpr_shading_desc_init(desc, (uint)sizeof(hrbfnpr_shading_desc)));
            desc->sky_rays = SkyRays;
            desc->shadow_rays = ShadowRays;
            desc->occlusion_reach = OcclusionReach;
            desc->curvature_scale = CurvatureScale;
            desc->flags = WithLines ? 1u : 0;
            if (Previous != null)
            {
                desc->previous = held.Hold(Previous.Handle);
            }
        }
    }
}
