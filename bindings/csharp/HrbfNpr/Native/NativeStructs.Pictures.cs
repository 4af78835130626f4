// SPDX-License-Identifier: MIT
// Made by make_native.py from include/hrbfnpr.h; do not edit.
#pragma warning disable 169, 649 // some fields are only read or written by the library
using System;
using System.Runtime.InteropServices;

namespace HrbfNpr
{
    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_source_field")]
    internal unsafe struct hrbfnpr_source_field
    {
        internal uint struct_size;
        internal uint kind;
        internal IntPtr name;
        internal hrbfnpr_array values;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_picture_source")]
    internal unsafe struct hrbfnpr_picture_source
    {
        internal uint struct_size;
        internal uint flags;
        internal hrbfnpr_array points;
        internal hrbfnpr_array normals;
        internal hrbfnpr_array triangles;
        internal hrbfnpr_array sharp_edges;
        internal IntPtr model;
        internal IntPtr point_set;
        internal fixed double up[3];
        internal IntPtr up_by;
        internal fixed double viewpoint[3];
        internal long columns;
        internal long rows;
        internal IntPtr name;
        internal IntPtr fields;
        internal long field_count;
        internal long field_stride;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_change")]
    internal unsafe struct hrbfnpr_change
    {
        internal uint struct_size;
        internal uint reserved;
        internal IntPtr field;
        internal IntPtr value;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_note")]
    internal unsafe struct hrbfnpr_note
    {
        internal uint struct_size;
        internal uint code;
        internal uint severity;
        internal uint figure_count;
        internal fixed double figures[8];
        internal IntPtr text;
        internal IntPtr advice;
        internal IntPtr detail;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_picture_event")]
    internal unsafe struct hrbfnpr_picture_event
    {
        internal uint struct_size;
        internal uint stage;
        internal double fraction;
        internal double seconds;
        internal IntPtr name;
        internal IntPtr doing;
        internal IntPtr says;
        internal IntPtr note;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_picture_desc")]
    internal unsafe struct hrbfnpr_picture_desc
    {
        internal uint struct_size;
        internal uint flags;
        internal IntPtr sources;
        internal long source_count;
        internal long source_stride;
        internal uint preset;
        internal uint wording;
        internal IntPtr style_name;
        internal IntPtr style;
        internal IntPtr settings;
        internal IntPtr changes;
        internal long change_count;
        internal long change_stride;
        internal IntPtr dabs;
        internal long dab_count;
        internal long dab_stride;
        internal int width;
        internal int height;
        internal int size;
        internal uint sides;
        internal double pen;
        internal double line_width;
        internal IntPtr camera;
        internal fixed double up[3];
        internal double azimuth;
        internal double elevation;
        internal fixed double direction[3];
        internal fixed double eye[3];
        internal fixed double target[3];
        internal double fov;
        internal double margin;
        internal double turn;
        internal int turn_frames;
        internal uint normals;
        internal long samples;
        internal double tolerance;
        internal long maximum_centres;
        internal uint parts;
        internal uint edges;
        internal double edge_angle;
        internal double crease_angle;
        internal int subdivide;
        internal uint profile;
        internal fixed double viewpoint[3];
        internal double depth_smoothing;
        internal ulong random_seed;
        internal IntPtr mark_kinds;
        internal hrbfnpr_array seed_points;
        internal double hatch_angle;
        internal IntPtr lines;
        internal IntPtr scale_bar;
        internal IntPtr on_event;
        internal IntPtr event_user;
        internal uint ground;
        internal uint reserved;
        internal double ground_height;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_picture_part")]
    internal unsafe struct hrbfnpr_picture_part
    {
        internal uint struct_size;
        internal uint sides;
        internal IntPtr model;
        internal IntPtr point_set;
        internal IntPtr line_set;
        internal IntPtr mesh;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_picture_page_desc")]
    internal unsafe struct hrbfnpr_picture_page_desc
    {
        internal uint struct_size;
        internal uint reserved;
        internal IntPtr page;
        internal IntPtr paper;
        internal double paper_margin;
        internal hrbfnpr_array pen_widths;
    }

    [StructLayout(LayoutKind.Sequential), NativeStruct("hrbfnpr_views_desc")]
    internal unsafe struct hrbfnpr_views_desc
    {
        internal uint struct_size;
        internal uint flags;
        internal uint projection;
        internal uint hidden;
        internal IntPtr views;
        internal IntPtr sections;
        internal IntPtr paper;
        internal IntPtr scale;
        internal IntPtr smooth;
        internal IntPtr title;
        internal IntPtr model;
        internal double unit_mm;
        internal double crease_angle;
        internal double line_width;
        internal double hatch_spacing;
        internal double spacing;
        internal IntPtr page;
        internal uint tangent;
        internal uint reserved;
    }
}
