// Made by make_native.py from include/hrbfnpr.h; do not edit.
#pragma warning disable 169, 649 // some fields are only read or written by the library
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_error")]
    internal unsafe struct hrbfnpr_error
    {
        internal uint struct_size;
        internal int status;
        internal fixed byte message[248];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_array")]
    internal unsafe struct hrbfnpr_array
    {
        internal IntPtr data;
        internal long count;
        internal long stride;
        internal uint scalar;
        internal uint components;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_array_out")]
    internal unsafe struct hrbfnpr_array_out
    {
        internal IntPtr data;
        internal long count;
        internal long stride;
        internal uint scalar;
        internal uint components;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_image")]
    internal unsafe struct hrbfnpr_image
    {
        internal uint struct_size;
        internal uint format;
        internal int width;
        internal int height;
        internal IntPtr pixels;
        internal long row_stride;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_context_desc")]
    internal unsafe struct hrbfnpr_context_desc
    {
        internal uint struct_size;
        internal uint abi_version;
        internal int thread_count;
        internal uint flags;
        internal uint thread_backend;
        internal uint highest_instruction_set;
        internal IntPtr allocate;
        internal IntPtr deallocate;
        internal IntPtr allocator_user;
        internal IntPtr log;
        internal IntPtr log_user;
        internal int log_level;
        internal uint reserved;
        internal IntPtr run_tasks;
        internal IntPtr run_tasks_user;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_fit_desc")]
    internal unsafe struct hrbfnpr_fit_desc
    {
        internal uint struct_size;
        internal uint kernel;
        internal hrbfnpr_array points;
        internal hrbfnpr_array normals;
        internal double kernel_radius;
        internal int polynomial_degree;
        internal uint regularization_mode;
        internal double regularization;
        internal uint outliers;
        internal uint flipped_normals;
        internal double tolerance;
        internal long maximum_centres;
        internal uint solver;
        internal int refinement_steps;
        internal double solver_tolerance;
        internal int iteration_limit;
        internal uint preconditioner_neighbours;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_custom_desc")]
    internal unsafe struct hrbfnpr_custom_desc
    {
        internal uint struct_size;
        internal uint flags;
        internal IntPtr function;
        internal IntPtr user;
        internal IntPtr release;
        internal fixed double bounds_min[3];
        internal fixed double bounds_max[3];
        internal double difference_step;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_project_desc")]
    internal unsafe struct hrbfnpr_project_desc
    {
        internal uint struct_size;
        internal int evaluation_limit;
        internal double tolerance;
        internal double armijo_slope;
        internal double armijo_factor;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_projection")]
    internal unsafe struct hrbfnpr_projection
    {
        internal uint struct_size;
        internal uint reserved;
        internal hrbfnpr_array position;
        internal hrbfnpr_array normal;
        internal hrbfnpr_array status;
        internal long converged;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_curvature")]
    internal unsafe struct hrbfnpr_curvature
    {
        internal uint struct_size;
        internal uint reserved;
        internal hrbfnpr_array k1;
        internal hrbfnpr_array k2;
        internal hrbfnpr_array d1;
        internal hrbfnpr_array d2;
        internal hrbfnpr_array confidence;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_cast_desc")]
    internal unsafe struct hrbfnpr_cast_desc
    {
        internal uint struct_size;
        internal int maximum_hits;
        internal int evaluation_limit;
        internal uint reserved;
        internal double t_min;
        internal double t_max;
        internal double lipschitz;
        internal double smallest_step;
        internal double tolerance;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_ray_hits")]
    internal unsafe struct hrbfnpr_ray_hits
    {
        internal uint struct_size;
        internal uint reserved;
        internal hrbfnpr_array count;
        internal hrbfnpr_array t;
        internal hrbfnpr_array position;
        internal hrbfnpr_array normal;
        internal hrbfnpr_array entering;
        internal hrbfnpr_array status;
        internal long hit_rays;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_group_desc")]
    internal unsafe struct hrbfnpr_group_desc
    {
        internal int levels;
        internal uint seeds;
        internal int seed_level;
        internal uint reserved;
        internal long budget;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_layer")]
    internal unsafe struct hrbfnpr_layer
    {
        internal float begin;
        internal float end;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_generate_desc")]
    internal unsafe struct hrbfnpr_generate_desc
    {
        internal uint struct_size;
        internal uint groups;
        internal uint distribution;
        internal uint seed_source;
        internal uint flags;
        internal uint box_resolution;
        internal double box_jitter;
        internal double initial_step;
        internal double projection_tolerance;
        internal ulong random_seed;
        internal hrbfnpr_array seed_points;
        internal hrbfnpr_group_desc group0, group1, group2;
        internal double stroke_separation;
        internal double stroke_step;
        internal double stroke_length;
        internal uint stroke_field;
        internal uint density;
        internal double density_strength;
        internal IntPtr density_function;
        internal IntPtr density_user;
        internal uint order;
        internal uint reserved2;
        internal long shared_budget;
        internal hrbfnpr_layer layer0, layer1, layer2, layer3, layer4;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_group_arrays")]
    internal unsafe struct hrbfnpr_group_arrays
    {
        internal hrbfnpr_array position;
        internal hrbfnpr_array normal;
        internal hrbfnpr_array direction;
        internal hrbfnpr_array curvature;
        internal hrbfnpr_array rank;
        internal hrbfnpr_array level;
        internal hrbfnpr_array stroke;
        internal hrbfnpr_array width;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_point_set_desc")]
    internal unsafe struct hrbfnpr_point_set_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal ulong random_seed;
        internal hrbfnpr_group_arrays group0, group1, group2;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_camera")]
    internal unsafe struct hrbfnpr_camera
    {
        internal uint struct_size;
        internal uint depth_convention;
        internal fixed double view[16];
        internal fixed double projection[16];
        internal fixed double viewport[4];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_group_style")]
    internal unsafe struct hrbfnpr_group_style
    {
        internal uint shown;
        internal uint sets;
        internal float share;
        internal float radius;
        internal float radius_zoom;
        internal fixed float ink[4];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_style")]
    internal unsafe struct hrbfnpr_style
    {
        internal uint struct_size;
        internal uint hidden_lines;
        internal double silhouette_threshold;
        internal double attenuation_front;
        internal double attenuation_back;
        internal float cover_radius;
        internal float halo_width;
        internal float cover_layers;
        internal uint visibility;
        internal uint tone;
        internal uint tone_rule;
        internal uint light_space;
        internal uint silhouette_groups;
        internal fixed double light[3];
        internal double tone_exponent;
        internal IntPtr tone_function;
        internal IntPtr tone_user;
        internal double depth_min;
        internal double depth_max;
        internal double zoom_reference;
        internal double zoom_exponent;
        internal fixed float paper[4];
        internal fixed float silhouette_ink[4];
        internal float silhouette_radius;
        internal float silhouette_radius_zoom;
        internal hrbfnpr_group_style group0, group1, group2;
        internal uint tone_curve;
        internal uint silhouette_law;
        internal float tone_fade;
        internal float silhouette_width;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_item")]
    internal unsafe struct hrbfnpr_item
    {
        internal uint struct_size;
        internal uint reserved;
        internal IntPtr point_set;
        internal IntPtr style;
        internal fixed double transform[16];
        internal IntPtr model;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_draw_desc")]
    internal unsafe struct hrbfnpr_draw_desc
    {
        internal uint struct_size;
        internal uint flags;
        internal hrbfnpr_array host_depth;
        internal hrbfnpr_array depth;
        internal hrbfnpr_array id;
        internal hrbfnpr_array class_;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_vertex_attribute")]
    internal unsafe struct hrbfnpr_vertex_attribute
    {
        internal uint attribute;
        internal uint scalar;
        internal uint offset;
        internal uint reserved;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_vertex_layout")]
    internal unsafe struct hrbfnpr_vertex_layout
    {
        internal uint struct_size;
        internal uint attribute_count;
        internal long stride;
        internal hrbfnpr_vertex_attribute attributes0, attributes1, attributes2, attributes3, attributes4,
            attributes5, attributes6, attributes7, attributes8, attributes9, attributes10, attributes11, attributes12,
            attributes13, attributes14, attributes15;
    }
}
