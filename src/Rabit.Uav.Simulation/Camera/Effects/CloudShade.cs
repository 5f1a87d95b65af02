using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The shade of clouds that stand still over the ground: half of it is darker, with soft edges. The light is computed
/// at the corners of blocks of the picture and blended between them. Allocates nothing for a picture.
/// </summary>
internal sealed class CloudShade
{
    private const int TileSize = 128;
    private const double MetresPerCell = 4;
    private const int CoarsestCells = 8;     // 64 m
    private const int Octaves = 3;
    private const double EdgeWidth = 0.05;   // of the noise, whose slope makes it some metres
    private const int Block = 16;
    private const double MinDown = 0.02;     // of a ray; the ground nearer to the horizon is in full light

    private readonly LensRays _lens;
    private readonly double _darkness;
    private readonly double[] _clouds;
    private readonly double _middle;
    private readonly int _columns;
    private readonly int _rows;
    private readonly int[] _light;   // at the corners of the blocks, 1/256

    public CloudShade(LensRays lens, double darkness, ulong seed)
    {
        (_lens, _darkness) = (lens, darkness);
        var random = new SeededSequence(seed);
        _clouds = ValueNoise.Fill(TileSize, CoarsestCells, Octaves, ref random);
        double[] sorted = (double[])_clouds.Clone();
        Array.Sort(sorted);
        _middle = sorted[sorted.Length / 2];
        (_columns, _rows) = (((lens.Width - 1) / Block) + 2, ((lens.Height - 1) / Block) + 2);
        _light = new int[_columns * _rows];
    }

    public void Apply(in CameraPose pose, byte[] pixels)
    {
        if (pose.Height < GroundPainter.MinHeight)
            return;
        for (int row = 0; row < _rows; row++)
        {
            for (int column = 0; column < _columns; column++)
                _light[(row * _columns) + column] = LightAt(pose, column * Block, row * Block);
        }

        int at = 0;
        for (int v = 0; v < _lens.Height; v++)
        {
            int corner = v / Block * _columns;
            int down = v % Block;
            for (int u = 0; u < _lens.Width; u++)
            {
                int light = Between(corner + (u / Block), u % Block, down);
                pixels[at] = (byte)((pixels[at] * light) >> 8);
                pixels[at + 1] = (byte)((pixels[at + 1] * light) >> 8);
                pixels[at + 2] = (byte)((pixels[at + 2] * light) >> 8);
                at += 3;
            }
        }
    }

    private int Between(int corner, int right, int down)
    {
        int upper = (_light[corner] * (Block - right)) + (_light[corner + 1] * right);
        int lower = (_light[corner + _columns] * (Block - right)) + (_light[corner + _columns + 1] * right);
        return ((upper * (Block - down)) + (lower * down)) / (Block * Block);
    }

    private int LightAt(in CameraPose pose, int u, int v)
    {
        int ray = 2 * ((Math.Min(v, _lens.Height - 1) * _lens.Width) + Math.Min(u, _lens.Width - 1));
        (double x, double y) = (_lens.Rays[ray], _lens.Rays[ray + 1]);
        (Vector3 right, Vector3 below, Vector3 axis) = (pose.Axes.Right, pose.Axes.Down, pose.Axes.Forward);
        double down = (x * right.Third) + (y * below.Third) + axis.Third;
        if (down < MinDown)
            return 256;
        double along = pose.Height / down;
        double north = pose.North + (along * ((x * right.First) + (y * below.First) + axis.First));
        double east = pose.East + (along * ((x * right.Second) + (y * below.Second) + axis.Second));
        double over = (CloudAt(north / MetresPerCell, east / MetresPerCell) - _middle) / EdgeWidth;
        double part = Math.Max(0, Math.Min(1, 0.5 + over));
        return (int)(256 * (1 - (_darkness * part)));
    }

    private double CloudAt(double row, double column)
    {
        (double top, double left) = (Math.Floor(row), Math.Floor(column));
        (double down, double right) = (row - top, column - left);
        (int r, int c) = (Wrapped(top), Wrapped(left));
        (int below, int beside) = ((r + 1) % TileSize, (c + 1) % TileSize);
        double upper = _clouds[(r * TileSize) + c]
            + (right * (_clouds[(r * TileSize) + beside] - _clouds[(r * TileSize) + c]));
        double lower = _clouds[(below * TileSize) + c]
            + (right * (_clouds[(below * TileSize) + beside] - _clouds[(below * TileSize) + c]));
        return upper + (down * (lower - upper));
    }

    private static int Wrapped(double index) => (int)(index - (TileSize * Math.Floor(index / TileSize)));
}
