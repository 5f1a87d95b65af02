using System;

namespace Rabit.Vision;

/// <summary>One pose of a square, fitted to its four corners by Levenberg and Marquardt's method.</summary>
internal ref struct PoseFit
{
    private const int Unknowns = 6;
    private const int MaxRounds = 30;

    private readonly ReadOnlySpan<PicturePoint> _rays;
    private readonly double _half;
    private MarkerRotation _rotation;
    private double _x;
    private double _y;
    private double _z;

    public PoseFit(ReadOnlySpan<PicturePoint> rays, double side)
    {
        _rays = rays;
        _half = side / 2;
        _rotation = default;
        (_x, _y, _z) = (0, 0, 0);
    }

    /// <summary>From the map of the unit square: its columns are the marker's axes in perspective.</summary>
    public void Start(in PlaneMap map)
    {
        // From the square of side 1 around 0, -0.5 to 0.5, to the rays.
        double c = map.C + (0.5 * (map.A + map.B));
        double f = map.F + (0.5 * (map.D + map.E));
        double i = 1 + (0.5 * (map.G + map.H));
        double first = Math.Sqrt((map.A * map.A) + (map.D * map.D) + (map.G * map.G));
        double second = Math.Sqrt((map.B * map.B) + (map.E * map.E) + (map.H * map.H));
        double scale = 2 * (2 * _half) / (first + second);
        _rotation = MarkerRotation.FromAxes(map.A, map.D, map.G, map.B, map.E, map.H);
        (_x, _y, _z) = (c * scale, f * scale, i * scale);
    }

    /// <summary>Turns the marker so that its normal lies on the other side of the line of sight.</summary>
    public void Mirror()
    {
        double distance = Math.Sqrt((_x * _x) + (_y * _y) + (_z * _z));
        (double vx, double vy, double vz) = (_x / distance, _y / distance, _z / distance);
        (double nx, double ny, double nz) = _rotation.Normal;
        double cross1 = (ny * vz) - (nz * vy);
        double cross2 = (nz * vx) - (nx * vz);
        double cross3 = (nx * vy) - (ny * vx);
        double sin = Math.Sqrt((cross1 * cross1) + (cross2 * cross2) + (cross3 * cross3));
        if (sin < 1e-9)
            return;
        double angle = 2 * Math.Atan2(sin, (nx * vx) + (ny * vy) + (nz * vz)) / sin;
        _rotation = _rotation.Turned(angle * cross1, angle * cross2, angle * cross3);
    }

    /// <summary>Fits; false if it leads behind the camera or to no numbers.</summary>
    public bool Refine()
    {
        Span<double> normal = stackalloc double[Unknowns * Unknowns];
        Span<double> step = stackalloc double[Unknowns];
        Span<double> damped = stackalloc double[Unknowns * Unknowns];
        double error = Build(normal, step);
        double damping = 1e-4;
        Span<double> gradient = stackalloc double[Unknowns];
        step.CopyTo(gradient);
        for (int round = 0; round < MaxRounds && error < double.PositiveInfinity; round++)
        {
            normal.CopyTo(damped);
            for (int i = 0; i < Unknowns; i++)
                damped[(i * Unknowns) + i] *= 1 + damping;
            gradient.CopyTo(step);
            if (!SmallSystem.TrySolve(damped, step, Unknowns))
                return false;
            PoseFit before = this;
            Move(step);
            double next = Error();
            if (!(next < error))
            {
                this = before;
                damping *= 10;
                if (damping > 1e6)
                    break;
                continue;
            }

            bool isDone = error - next < 1e-12 * error;
            damping = Math.Max(1e-9, damping / 10);
            error = Build(normal, gradient);
            if (isDone)
                break;
        }

        return error < double.PositiveInfinity && _z > 0;
    }

    public readonly MarkerPose ToPose(double sigma)
    {
        Span<double> normal = stackalloc double[Unknowns * Unknowns];
        Span<double> unused = stackalloc double[Unknowns];
        double error = Build(normal, unused);
        MarkerPose pose = _rotation.ToPose();
        (pose.X, pose.Y, pose.Z) = (_x, _y, _z);
        pose.ChiSquare = error / (sigma * sigma);
        Span<double> sigmas = stackalloc double[Unknowns];
        Span<double> copy = stackalloc double[Unknowns * Unknowns];
        for (int i = 0; i < Unknowns; i++)
        {
            normal.CopyTo(copy);
            unused.Clear();
            unused[i] = 1;
            sigmas[i] = SmallSystem.TrySolve(copy, unused, Unknowns)
                ? sigma * Math.Sqrt(Math.Max(0, unused[i])) : double.PositiveInfinity;
        }

        pose.SigmaTilt = Math.Max(sigmas[0], sigmas[1]);
        (pose.SigmaX, pose.SigmaY, pose.SigmaZ) = (sigmas[3], sigmas[4], sigmas[5]);
        return pose;
    }

    private void Move(scoped ReadOnlySpan<double> step)
    {
        _rotation = _rotation.Turned(step[0], step[1], step[2]);
        _x += step[3];
        _y += step[4];
        _z += step[5];
    }

    private readonly double Error()
    {
        double sum = 0;
        for (int corner = 0; corner < 4; corner++)
        {
            Place(corner, out double x, out double y, out double z);
            double dx = _rays[corner].X - ((x + _x) / (z + _z));
            double dy = _rays[corner].Y - ((y + _y) / (z + _z));
            sum += z + _z > 0 ? (dx * dx) + (dy * dy) : double.PositiveInfinity;
        }

        return sum;
    }

    // A corner relative to the centre, in the axes of the camera.
    private readonly void Place(int corner, out double x, out double y, out double z)
        => _rotation.Apply(
            corner is 1 or 2 ? _half : -_half, corner >= 2 ? _half : -_half, out x, out y, out z);

    // The normal equations of small turns and moves; the sum of squares.
    private readonly double Build(Span<double> normal, Span<double> right)
    {
        normal.Clear();
        right.Clear();
        Span<double> row = stackalloc double[Unknowns];
        for (int corner = 0; corner < 4; corner++)
        {
            Place(corner, out double x, out double y, out double z);
            double depth = z + _z;
            for (int axis = 0; axis < 2; axis++)
            {
                double seen = (axis == 0 ? x + _x : y + _y) / depth;
                double off = (axis == 0 ? _rays[corner].X : _rays[corner].Y) - seen;
                (double px, double py) = axis == 0 ? (1 / depth, 0.0) : (0.0, 1 / depth);
                double pz = -seen / depth;

                // Turning by w moves the corner by w x corner.
                row[0] = (pz * y) - (py * z);
                row[1] = (px * z) - (pz * x);
                row[2] = (py * x) - (px * y);
                (row[3], row[4], row[5]) = (px, py, pz);
                for (int i = 0; i < Unknowns; i++)
                {
                    right[i] += row[i] * off;
                    for (int j = 0; j < Unknowns; j++)
                        normal[(i * Unknowns) + j] += row[i] * row[j];
                }
            }
        }

        return Error();
    }
}
