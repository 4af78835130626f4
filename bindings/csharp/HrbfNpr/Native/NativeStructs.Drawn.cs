// SPDX-License-Identifier: MIT
// Made by make_native.py from include/hrbfnpr.h; do not edit.
#pragma warning disable 169, 649 // some fields are only read or written by the library
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_camera")]
    internal unsafe struct hrbfnpr_camera
    {
        internal uint struct_size;
        internal uint depth_convention;
        internal fixed double view[16];
        internal fixed double projection[16];
        internal fixed double viewport[4];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_light")]
    internal unsafe struct hrbfnpr_light
    {
        internal uint struct_size;
        internal uint kind;
        internal uint space;
        internal float intensity;
        internal float shadow;
        internal float softness;
        internal fixed double place[3];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_layer_style")]
    internal unsafe struct hrbfnpr_layer_style
    {
        internal uint struct_size;
        internal uint kind;
        internal IntPtr name;
        internal uint shown;
        internal uint contours;
        internal uint directions;
        internal uint shape;
        internal float share;
        internal float radius;
        internal float radius_zoom;
        internal uint reserved;
        internal fixed float ink[4];
        internal float hatch_tone_begin;
        internal float hatch_tone_end;
        internal float hatch_coverage_begin;
        internal float hatch_coverage_end;
        internal float hatch_spacing;
        internal float hatch_pen;
        internal float hatch_white;
        internal float hatch_taper;
        internal float hatch_shortest;
        internal uint reserved2;
        internal float hatch_wobble;
        internal float hatch_overshoot;
        internal uint hatch_seed;
        internal uint reserved3;
        internal IntPtr density_field;
        internal IntPtr tone_field;
        internal IntPtr width_field;
        internal IntPtr ink_field;
        internal IntPtr mask_field;
        internal uint tone_field_rule;
        internal uint palette_rule;
        internal float hatch_fade;
        internal uint reserved4;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_line_style")]
    internal unsafe struct hrbfnpr_line_style
    {
        internal uint struct_size;
        internal uint kind;
        internal IntPtr name;
        internal uint hidden;
        internal uint cap;
        internal float width;
        internal float taper;
        internal float hidden_width;
        internal float hidden_opacity;
        internal float dash;
        internal float gap;
        internal float shortest;
        internal float fade;
        internal double lower;
        internal double upper;
        internal hrbfnpr_array levels;
        internal fixed float ink[4];
        internal float outline_factor;
        internal float far_factor;
        internal float lit_factor;
        internal float curvature_factor;
        internal float curvature_radius;
        internal float wobble;
        internal float wobble_width;
        internal float wobble_length;
        internal uint wobble_seed;
        internal uint creases;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_style")]
    internal unsafe struct hrbfnpr_style
    {
        internal uint struct_size;
        internal uint tone;
        internal fixed float paper[4];
        internal IntPtr layers;
        internal long layer_count;
        internal long layer_stride;
        internal uint tone_rule;
        internal uint tone_curve;
        internal fixed double light[3];
        internal double tone_exponent;
        internal IntPtr tone_function;
        internal IntPtr tone_user;
        internal uint light_space;
        internal float tone_fade;
        internal double silhouette_threshold;
        internal float silhouette_radius;
        internal float silhouette_radius_zoom;
        internal fixed float silhouette_ink[4];
        internal uint visibility;
        internal uint hidden_lines;
        internal double attenuation_front;
        internal double attenuation_back;
        internal float splat_radius;
        internal float splat_overlap;
        internal float halo_width;
        internal uint verify_lines;
        internal double depth_min;
        internal double depth_max;
        internal double zoom_reference;
        internal double zoom_exponent;
        internal IntPtr lines;
        internal long line_count;
        internal long line_stride;
        internal float fill_light;
        internal uint reserved2;
        internal float light_intensity;
        internal float light_shadow;
        internal float light_softness;
        internal uint evenness;
        internal IntPtr lights;
        internal long light_count;
        internal long light_stride;
        internal fixed double ambient_up[3];
        internal float ambient_sky;
        internal float ambient_ground;
        internal float occlusion;
        internal float occlusion_exponent;
        internal float rim_light;
        internal float rim_exponent;
        internal float tone_black;
        internal float tone_white;
        internal float tone_gamma;
        internal uint tone_steps;
        internal float curvature_contrast;
        internal float occlusion_lights;
        internal IntPtr palette;
        internal long palette_count;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_dab")]
    internal unsafe struct hrbfnpr_dab
    {
        internal uint struct_size;
        internal uint map;
        internal fixed double position[3];
        internal fixed double normal[3];
        internal double radius;
        internal double strength;
        internal double value;
        internal fixed double direction[3];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_field_desc")]
    internal unsafe struct hrbfnpr_field_desc
    {
        internal uint struct_size;
        internal uint kind;
        internal uint source;
        internal uint flags;
        internal fixed double range[2];
        internal hrbfnpr_array points;
        internal hrbfnpr_array triangles;
        internal hrbfnpr_array values;
        internal double reach;
        internal IntPtr function;
        internal IntPtr user;
        internal IntPtr dabs;
        internal long dab_count;
        internal long dab_stride;
        internal IntPtr image;
        internal IntPtr camera;
        internal IntPtr occluders;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_layer_pose")]
    internal unsafe struct hrbfnpr_layer_pose
    {
        internal uint struct_size;
        internal uint reserved;
        internal long layer;
        internal hrbfnpr_array position;
        internal hrbfnpr_array normal;
        internal hrbfnpr_array direction;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_item")]
    internal unsafe struct hrbfnpr_item
    {
        internal uint struct_size;
        internal uint sides;
        internal IntPtr point_set;
        internal IntPtr style;
        internal IntPtr model;
        internal fixed double transform[16];
        internal IntPtr poses;
        internal long pose_count;
        internal long pose_stride;
        internal IntPtr line_set;
        internal IntPtr shading;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_shading_desc")]
    internal unsafe struct hrbfnpr_shading_desc
    {
        internal uint struct_size;
        internal int sky_rays;
        internal int shadow_rays;
        internal uint flags;
        internal double occlusion_reach;
        internal IntPtr previous;
        internal double curvature_scale;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_raster_desc")]
    internal unsafe struct hrbfnpr_raster_desc
    {
        internal uint struct_size;
        internal uint flags;
        internal hrbfnpr_array host_depth;
        internal hrbfnpr_array depth;
        internal hrbfnpr_array id;
        internal hrbfnpr_array mark_class;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_vertex_attribute")]
    internal unsafe struct hrbfnpr_vertex_attribute
    {
        internal uint struct_size;
        internal uint attribute;
        internal uint scalar;
        internal uint offset;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_vertex_layout")]
    internal unsafe struct hrbfnpr_vertex_layout
    {
        internal uint struct_size;
        internal uint primitive;
        internal IntPtr attributes;
        internal long attribute_count;
        internal long attribute_stride;
        internal long stride;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mark_results")]
    internal unsafe struct hrbfnpr_mark_results
    {
        internal uint struct_size;
        internal uint reserved;
        internal hrbfnpr_array shown;
        internal hrbfnpr_array radius;
        internal hrbfnpr_array opacity;
    }
}
