// SPDX-License-Identifier: MIT
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
        internal uint normal_mode;
        internal uint trim;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_orient_desc")]
    internal unsafe struct hrbfnpr_orient_desc
    {
        internal uint struct_size;
        internal uint mode;
        internal hrbfnpr_array points;
        internal hrbfnpr_array normals;
        internal fixed double up[3];
        internal fixed double viewpoint[3];
        internal uint has_viewpoint;
        internal uint reserved;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_depth_image_desc")]
    internal unsafe struct hrbfnpr_depth_image_desc
    {
        internal uint struct_size;
        internal int columns;
        internal int rows;
        internal uint keep_points;
        internal hrbfnpr_array points;
        internal double noise;
        internal double smoothing;
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
        internal IntPtr line_set;
        internal uint refine;
        internal uint reserved2;
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

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_trim_desc")]
    internal unsafe struct hrbfnpr_trim_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal double limit;
        internal double hole;
        internal double closest;
        internal hrbfnpr_array points;
        internal hrbfnpr_array normals;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_csg_node")]
    internal unsafe struct hrbfnpr_csg_node
    {
        internal uint struct_size;
        internal uint kind;
        internal long parent;
        internal IntPtr model;
        internal fixed double transform[16];
        internal fixed double size[3];
        internal double radius;
        internal double second_radius;
        internal double height;
        internal double distance;
        internal double blend;
        internal double exponent;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_csg_desc")]
    internal unsafe struct hrbfnpr_csg_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal IntPtr nodes;
        internal long node_count;
        internal long node_stride;
        internal fixed double bounds_min[3];
        internal fixed double bounds_max[3];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_layer_desc")]
    internal unsafe struct hrbfnpr_layer_desc
    {
        internal uint struct_size;
        internal uint kind;
        internal IntPtr name;
        internal long budget;
        internal float tone_begin;
        internal float tone_end;
        internal float second_tone_begin;
        internal float second_tone_end;
        internal uint flags;
        internal uint density;
        internal double density_strength;
        internal IntPtr density_function;
        internal IntPtr density_user;
        internal IntPtr direction_function;
        internal IntPtr direction_user;
        internal uint guide;
        internal uint start;
        internal int start_level;
        internal int levels;
        internal double separation;
        internal double step;
        internal double angle;
        internal double smoothing;
        internal fixed double axis[3];
        internal double axis_weight;
        internal fixed double guide_direction[3];
        internal double guide_weight;
        internal double tone_smoothing;
        internal IntPtr density_field;
        internal IntPtr direction_field;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_generate_desc")]
    internal unsafe struct hrbfnpr_generate_desc
    {
        internal uint struct_size;
        internal uint distribution;
        internal IntPtr layers;
        internal long layer_count;
        internal long layer_stride;
        internal long shared_budget;
        internal uint tone_ranges;
        internal uint seed_source;
        internal hrbfnpr_array seed_points;
        internal double box_jitter;
        internal uint box_resolution;
        internal uint reserved;
        internal double initial_step;
        internal double projection_tolerance;
        internal ulong random_seed;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_layer_arrays")]
    internal unsafe struct hrbfnpr_layer_arrays
    {
        internal uint struct_size;
        internal uint kind;
        internal IntPtr name;
        internal hrbfnpr_array position;
        internal hrbfnpr_array normal;
        internal hrbfnpr_array stroke_first;
        internal hrbfnpr_array stroke_direction;
        internal hrbfnpr_array direction;
        internal hrbfnpr_array curvature;
        internal hrbfnpr_array rank;
        internal hrbfnpr_array level;
        internal hrbfnpr_array width;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_point_set_desc")]
    internal unsafe struct hrbfnpr_point_set_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal IntPtr @base;
        internal IntPtr layers;
        internal long layer_count;
        internal long layer_stride;
        internal ulong random_seed;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mark_field")]
    internal unsafe struct hrbfnpr_mark_field
    {
        internal uint struct_size;
        internal uint reserved;
        internal IntPtr name;
        internal IntPtr field;
        internal IntPtr transform;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_line_desc")]
    internal unsafe struct hrbfnpr_line_desc
    {
        internal uint struct_size;
        internal uint kind;
        internal IntPtr name;
        internal double lower;
        internal double upper;
        internal double shortest;
        internal fixed double plane[3];
        internal hrbfnpr_array levels;
        internal hrbfnpr_array position;
        internal hrbfnpr_array line_first;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_line_set_desc")]
    internal unsafe struct hrbfnpr_line_set_desc
    {
        internal uint struct_size;
        internal uint flags;
        internal double cell_size;
        internal hrbfnpr_array seed_points;
        internal IntPtr lines;
        internal long line_count;
        internal long line_stride;
        internal double support;
        internal hrbfnpr_array support_points;
        internal hrbfnpr_array support_normals;
        internal IntPtr mesh;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_desc")]
    internal unsafe struct hrbfnpr_mesh_desc
    {
        internal uint struct_size;
        internal uint parts;
        internal hrbfnpr_array vertices;
        internal hrbfnpr_array triangles;
        internal double crease_angle;
        internal uint faces;
        internal uint reserved;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_sample_desc")]
    internal unsafe struct hrbfnpr_sample_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal long candidates;
        internal ulong random_seed;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_edges_desc")]
    internal unsafe struct hrbfnpr_mesh_edges_desc
    {
        internal uint struct_size;
        internal uint edges;
        internal double crease_angle;
        internal double far;
        internal uint tangent;
        internal uint reserved;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_compare_desc")]
    internal unsafe struct hrbfnpr_compare_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal double tolerance;
        internal double far;
        internal double support;
        internal long points;
        internal double cell_size;
        internal ulong random_seed;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_mesh_fit_desc")]
    internal unsafe struct hrbfnpr_mesh_fit_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal double tolerance;
        internal double share;
        internal double far;
        internal long maximum_centres;
        internal long candidates;
        internal ulong random_seed;
        internal double crease_angle;
        internal uint edges;
        internal uint reserved2;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_page_item")]
    internal unsafe struct hrbfnpr_page_item
    {
        internal uint struct_size;
        internal uint reserved;
        internal IntPtr drawing;
        internal double x;
        internal double y;
        internal double scale;
        internal IntPtr name;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_pen")]
    internal unsafe struct hrbfnpr_pen
    {
        internal uint struct_size;
        internal uint line_type;
        internal IntPtr groups;
        internal double width;
        internal fixed float ink[4];
        internal uint number;
        internal uint reserved;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_annotation")]
    internal unsafe struct hrbfnpr_annotation
    {
        internal uint struct_size;
        internal uint line_type;
        internal IntPtr group;
        internal IntPtr text;
        internal hrbfnpr_array points;
        internal double width;
        internal fixed float ink[4];
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_page_desc")]
    internal unsafe struct hrbfnpr_page_desc
    {
        internal uint struct_size;
        internal uint format;
        internal uint flags;
        internal uint widths;
        internal uint dots;
        internal uint curves;
        internal double width;
        internal double height;
        internal double tolerance;
        internal double width_step;
        internal double join;
        internal double shortest;
        internal double dot_distance;
        internal double draw_speed;
        internal double travel_speed;
        internal double pen_seconds;
        internal IntPtr pen_down;
        internal IntPtr pen_up;
        internal IntPtr title;
        internal IntPtr description;
        internal IntPtr metadata;
        internal IntPtr items;
        internal long item_count;
        internal long item_stride;
        internal IntPtr pens;
        internal long pen_count;
        internal long pen_stride;
        internal IntPtr annotations;
        internal long annotation_count;
        internal long annotation_stride;
        internal double longest;
    }
}
