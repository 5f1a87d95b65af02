using System;

namespace Rabit.Uav.MissionControl;

/// <summary>A point of the ground plane of the local frame at home, metres. A plain value.</summary>
internal readonly struct PlanePoint(double north, double east)
{
    public double North { get; } = north;

    public double East { get; } = east;

    public static PlanePoint operator +(PlanePoint a, PlanePoint b) => new(a.North + b.North, a.East + b.East);

    public static PlanePoint operator -(PlanePoint a, PlanePoint b) => new(a.North - b.North, a.East - b.East);

    public static PlanePoint operator *(double factor, PlanePoint p) => new(factor * p.North, factor * p.East);

    /// <summary>The unit vector of a heading, radians clockwise from north.</summary>
    public static PlanePoint Towards(double headingRadians) => new(Trig.Cos(headingRadians), Trig.Sin(headingRadians));

    public double Length => Math.Sqrt((North * North) + (East * East));

    public double HeadingRadians => Math.Atan2(East, North);

    public double Dot(PlanePoint other) => (North * other.North) + (East * other.East);

    /// <summary>Above zero where the other lies to the right.</summary>
    public double Cross(PlanePoint other) => (North * other.East) - (East * other.North);

    public double DistanceTo(PlanePoint other) => (this - other).Length;
}
