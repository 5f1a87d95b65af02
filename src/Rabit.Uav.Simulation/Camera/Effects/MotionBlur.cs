using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Smears a picture by what the ground moves in it during the exposure: at the corners of blocks that way is computed,
/// by the poses at a quarter and at three quarters, and blended between them; each pixel is the mean along its way.
/// Allocates nothing for a picture.
/// </summary>
internal sealed class MotionBlur
{
    private const int Block = 32;
    private const int MaxTaps = 32;
    private const int Unit = 256;             // of places in the picture
    private const double NoMotion = 0.25;     // pixels

    // What is seen above the horizon, or near it, is as if so many heights away.
    private const double MinDown = 0.01;

    private readonly LensRays _lens;
    private readonly int _columns;
    private readonly int _rows;
    private readonly int[] _wayX;   // at the corners of the blocks, 1/256 pixels
    private readonly int[] _wayY;
    private readonly byte[] _copy;

    public MotionBlur(LensRays lens)
    {
        _lens = lens;
        (_columns, _rows) = (((lens.Width - 1) / Block) + 2, ((lens.Height - 1) / Block) + 2);
        (_wayX, _wayY) = (new int[_columns * _rows], new int[_columns * _rows]);
        _copy = new byte[lens.Width * lens.Height * 3];
    }

    public void Apply(in CameraPose middle, in CameraPose early, in CameraPose late, byte[] pixels)
    {
        if (middle.Height < GroundPainter.MinHeight || early.Height < GroundPainter.MinHeight
            || late.Height < GroundPainter.MinHeight)
            return;
        int longest = 0;
        for (int corner = 0; corner < _wayX.Length; corner++)
        {
            SetWay(corner, middle, early, late);
            longest = Math.Max(longest, Math.Max(Math.Abs(_wayX[corner]), Math.Abs(_wayY[corner])));
        }

        if (longest < NoMotion * Unit)
            return;
        Buffer.BlockCopy(pixels, 0, _copy, 0, _copy.Length);
        for (int v = 0; v < _lens.Height; v++)
        {
            for (int u = 0; u < _lens.Width; u++)
                Smear(u, v, pixels);
        }
    }

    private void SetWay(int corner, in CameraPose middle, in CameraPose early, in CameraPose late)
    {
        int u = Math.Min(corner % _columns * Block, _lens.Width - 1);
        int v = Math.Min(corner / _columns * Block, _lens.Height - 1);
        int ray = 2 * ((v * _lens.Width) + u);
        (double x, double y) = (_lens.Rays[ray], _lens.Rays[ray + 1]);
        Vector3 towards = middle.Axes.Transform(new Vector3(1, x, y));
        double along = middle.Height / Math.Max(towards.Third, MinDown);
        (double north, double east, double height) = (
            middle.North + (along * towards.First), middle.East + (along * towards.Second),
            middle.Height - (along * towards.Third));
        bool isSeen = TryProject(early, north, east, height, out double fromU, out double fromV)
            & TryProject(late, north, east, height, out double toU, out double toV);

        // From a quarter to three quarters is half of the way.
        _wayX[corner] = isSeen ? Limited(2 * (toU - fromU)) : 0;
        _wayY[corner] = isSeen ? Limited(2 * (toV - fromV)) : 0;
    }

    private bool TryProject(in CameraPose pose, double north, double east, double height, out double u, out double v)
    {
        var way = new Vector3(north - pose.North, east - pose.East, pose.Height - height);
        double depth = Along(way, pose.Axes.Forward);
        (u, v) = (0, 0);
        if (depth <= 0)
            return false;
        (u, v) = _lens.Project(Along(way, pose.Axes.Right) / depth, Along(way, pose.Axes.Down) / depth);
        return true;
    }

    private void Smear(int u, int v, byte[] pixels)
    {
        int corner = (v / Block * _columns) + (u / Block);
        int wayX = Between(_wayX, corner, u % Block, v % Block);
        int wayY = Between(_wayY, corner, u % Block, v % Block);
        int taps = Math.Min(MaxTaps, 2 + (Math.Max(Math.Abs(wayX), Math.Abs(wayY)) / Unit));
        (int red, int green, int blue) = (0, 0, 0);
        for (int tap = 0; tap < taps; tap++)
        {
            int part = (2 * tap) + 1 - taps;
            int x = Clamped((u * Unit) + (wayX * part / (2 * taps)), _lens.Width);
            int y = Clamped((v * Unit) + (wayY * part / (2 * taps)), _lens.Height);
            Add(x, y, ref red, ref green, ref blue);
        }

        int at = ((v * _lens.Width) + u) * 3;
        int half = taps / 2;
        pixels[at] = (byte)((red + half) / taps);
        pixels[at + 1] = (byte)((green + half) / taps);
        pixels[at + 2] = (byte)((blue + half) / taps);
    }

    // Between four pixels.
    private void Add(int x, int y, ref int red, ref int green, ref int blue)
    {
        (int right, int down) = (x % Unit, y % Unit);
        int upper = (((y / Unit) * _lens.Width) + (x / Unit)) * 3;
        int beside = x / Unit < _lens.Width - 1 ? 3 : 0;
        int lower = upper + (y / Unit < _lens.Height - 1 ? _lens.Width * 3 : 0);
        (int a, int b) = ((Unit - right) * (Unit - down), right * (Unit - down));
        (int c, int d) = ((Unit - right) * down, right * down);
        red += Mix(upper, beside, lower, a, b, c, d);
        green += Mix(upper + 1, beside, lower + 1, a, b, c, d);
        blue += Mix(upper + 2, beside, lower + 2, a, b, c, d);
    }

    private int Mix(int upper, int beside, int lower, int a, int b, int c, int d)
        => ((_copy[upper] * a) + (_copy[upper + beside] * b) + (_copy[lower] * c) + (_copy[lower + beside] * d)
            + (Unit * Unit / 2)) / (Unit * Unit);

    private int Between(int[] ways, int corner, int right, int down)
    {
        int upper = (ways[corner] * (Block - right)) + (ways[corner + 1] * right);
        int lower = (ways[corner + _columns] * (Block - right)) + (ways[corner + _columns + 1] * right);
        return ((upper * (Block - down)) + (lower * down)) / (Block * Block);
    }

    private int Limited(double pixels)
    {
        double reach = Math.Max(_lens.Width, _lens.Height);
        return (int)(Unit * Math.Max(-reach, Math.Min(reach, pixels)));
    }

    private static int Clamped(int place, int size) => Math.Max(0, Math.Min((size - 1) * Unit, place));

    private static double Along(Vector3 a, Vector3 b)
        => (a.First * b.First) + (a.Second * b.Second) + (a.Third * b.Third);
}
