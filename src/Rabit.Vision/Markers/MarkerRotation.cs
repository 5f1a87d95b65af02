using System;

namespace Rabit.Vision;

/// <summary>A rotation from a marker to the camera, as three columns: the marker's axes. A plain value.</summary>
internal readonly struct MarkerRotation
{
    private readonly double _xx;
    private readonly double _xy;
    private readonly double _xz;
    private readonly double _yx;
    private readonly double _yy;
    private readonly double _yz;
    private readonly double _zx;
    private readonly double _zy;
    private readonly double _zz;

    // The columns x and y, at right angles and of length 1; z follows.
    private MarkerRotation(double xx, double xy, double xz, double yx, double yy, double yz)
    {
        (_xx, _xy, _xz, _yx, _yy, _yz) = (xx, xy, xz, yx, yy, yz);
        _zx = (xy * yz) - (xz * yy);
        _zy = (xz * yx) - (xx * yz);
        _zz = (xx * yy) - (xy * yx);
    }

    /// <summary>The direction into the marker.</summary>
    public (double X, double Y, double Z) Normal => (_zx, _zy, _zz);

    /// <summary>The nearest to two directions of the marker's axes x and y: both are turned alike.</summary>
    public static MarkerRotation FromAxes(double ax, double ay, double az, double bx, double by, double bz)
    {
        double a = Math.Sqrt((ax * ax) + (ay * ay) + (az * az));
        double b = Math.Sqrt((bx * bx) + (by * by) + (bz * bz));
        (ax, ay, az, bx, by, bz) = (ax / a, ay / a, az / a, bx / b, by / b, bz / b);
        (double sx, double sy, double sz) = Unit(ax + bx, ay + by, az + bz);
        (double dx, double dy, double dz) = Unit(ax - bx, ay - by, az - bz);
        double half = Math.Sqrt(0.5);
        return new MarkerRotation(
            half * (sx + dx), half * (sy + dy), half * (sz + dz), half * (sx - dx), half * (sy - dy), half * (sz - dz));
    }

    /// <summary>A point of the marker's plane, in the axes of the camera.</summary>
    public void Apply(double u, double v, out double x, out double y, out double z)
    {
        x = (_xx * u) + (_yx * v);
        y = (_xy * u) + (_yy * v);
        z = (_xz * u) + (_yz * v);
    }

    /// <summary>Turned further by a vector in the axes of the camera: its length is the angle, radians.</summary>
    public MarkerRotation Turned(double x, double y, double z)
    {
        double angle = Math.Sqrt((x * x) + (y * y) + (z * z));
        if (angle < 1e-15)
            return this;
        (x, y, z) = (x / angle, y / angle, z / angle);
        (double sin, double cos) = (Trig.Sin(angle), Trig.Cos(angle));
        (double ax, double ay, double az) = Turn(_xx, _xy, _xz);
        (double bx, double by, double bz) = Turn(_yx, _yy, _yz);
        return FromAxes(ax, ay, az, bx, by, bz);

        (double X, double Y, double Z) Turn(double u, double v, double w)
        {
            double along = (1 - cos) * ((x * u) + (y * v) + (z * w));
            return (
                (u * cos) + (sin * ((y * w) - (z * v))) + (along * x),
                (v * cos) + (sin * ((z * u) - (x * w))) + (along * y),
                (w * cos) + (sin * ((x * v) - (y * u))) + (along * z));
        }
    }

    /// <summary>A pose with this rotation as a quaternion.</summary>
    public MarkerPose ToPose()
    {
        // The largest of four is not near zero (Shepperd 1978).
        double w = 1 + _xx + _yy + _zz;
        double x = 1 + _xx - _yy - _zz;
        double y = 1 - _xx + _yy - _zz;
        double z = 1 - _xx - _yy + _zz;
        double most = Math.Max(Math.Max(w, x), Math.Max(y, z));
        if (most == w)
            (x, y, z) = (_yz - _zy, _zx - _xz, _xy - _yx);
        else if (most == x)
            (w, y, z) = (_yz - _zy, _yx + _xy, _zx + _xz);
        else if (most == y)
            (w, x, z) = (_zx - _xz, _yx + _xy, _zy + _yz);
        else
            (w, x, y) = (_xy - _yx, _zx + _xz, _zy + _yz);
        double scale = (w < 0 ? -1 : 1) / Math.Sqrt((w * w) + (x * x) + (y * y) + (z * z));
        return new MarkerPose
        {
            RotationW = w * scale,
            RotationX = x * scale,
            RotationY = y * scale,
            RotationZ = z * scale,
        };
    }

    private static (double X, double Y, double Z) Unit(double x, double y, double z)
    {
        double length = Math.Sqrt((x * x) + (y * y) + (z * z));
        return (x / length, y / length, z / length);
    }
}
